// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/force_feedback/feedback_output.hpp"
#include "device/touch_output/force_feedback/simulated_feedback.hpp"

#include <memory>

namespace tp::testing {

/// The back end before a model motor, in the motor's time.
struct MotorBench {
    ModelMotor motor;
    FeedbackOutput output;
    bool writer_stalled = false;

    explicit MotorBench(FeedbackKind kind, unsigned places = 16)
        : motor(kind, places),
          output(
              {"Twin motors", "00:11"},
              [this]() -> Result<std::unique_ptr<FeedbackNode>> {
                  return std::unique_ptr<FeedbackNode>(std::make_unique<SimulatedFeedbackNode>(motor));
              },
              LatestWriter::Thread::caller, [this] { return motor.now(); }) {}
    /// A millisecond.
    void step() {
        if (!writer_stalled)
            output.deliver();
        motor.step();
    }
    void run(double seconds) {
        for (const double end = motor.now() + seconds; motor.now() < end - 1e-9;)
            step();
    }
};

} // namespace tp::testing
