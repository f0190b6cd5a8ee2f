// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/finger_path.hpp"
#include "core/participant/person.hpp"
#include "core/trials/study_trial.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace tp {

/// What one person does in one trial.
class SimulatedHand {
public:
    virtual ~SimulatedHand() = default;
    /// Where the hand means to be next, mm; `finger` (mm) and `force` (N) are what acts on it.
    virtual Vec2 step(Vec2 finger, Vec2 force) = 0;
    /// The answer, once it is known; `path` is the finger's so far. Never where nothing is to be named.
    virtual std::optional<std::string> knows(std::span<const FingerSample> path) = 0;
    /// The best answer when the time is over; empty: none.
    virtual std::string guess(std::span<const FingerSample> path) = 0;
};

/// A hand that follows, or feels a shape, or a face, whichever the trial has. `dt_s` passes between two steps.
std::unique_ptr<SimulatedHand> hand_for(const StudyTrial& trial, const Person& person, double dt_s,
                                        std::uint64_t seed);

} // namespace tp
