// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/force_feedback/feedback_node.hpp"

#include <cstdint>
#include <optional>

namespace tp {

/// What can go wrong between a program and a motor.
struct FeedbackTroubles {
    bool unplugged = false;
    bool refuses = false;         ///< the driver answers each request with an error
    unsigned upload_takes_ms = 0; ///< as over a slow bus
};

/// A motor, and the table of effects that a kernel keeps for it, in simulated time.
class ModelMotor {
public:
    /// `places` of the table are free.
    explicit ModelMotor(FeedbackKind kind, unsigned places = 16) : kind_(kind), free_(places) {}

    /// A millisecond.
    void step();
    double now() const { return 0.001 * static_cast<double>(now_ms_); } ///< s
    /// How strongly it shakes now, 0 … 1.
    double shakes() const;
    /// s since what shakes now was begun.
    double shakes_for() const { return 0.001 * static_cast<double>(now_ms_ - begun_ms_); }
    /// What was begun last.
    const FeedbackEffect& begun() const { return begun_; }
    std::uint64_t beginnings() const { return beginnings_; }
    std::uint64_t uploads() const { return uploads_; }
    unsigned free_places() const { return free_; }
    FeedbackKind kind() const { return kind_; }

    FeedbackTroubles troubles;

private:
    friend class SimulatedFeedbackNode;
    FeedbackKind kind_;
    unsigned free_;
    std::uint64_t now_ms_ = 0;
    std::uint64_t begun_ms_ = 0;
    std::uint64_t beginnings_ = 0;
    std::uint64_t uploads_ = 0;
    FeedbackEffect begun_;
    bool playing_ = false;
};

/// A program's descriptor of it, with the answers of Linux. The motor must outlive it.
class SimulatedFeedbackNode final : public FeedbackNode {
public:
    explicit SimulatedFeedbackNode(ModelMotor& motor) : motor_(motor) {}
    ~SimulatedFeedbackNode() override;
    SimulatedFeedbackNode(const SimulatedFeedbackNode&) = delete;
    SimulatedFeedbackNode& operator=(const SimulatedFeedbackNode&) = delete;

    FeedbackKind kind() const override { return motor_.kind(); }
    int upload(const FeedbackEffect& effect) noexcept override;
    int play(bool on) noexcept override;
    bool there() const noexcept override { return !motor_.troubles.unplugged; }

private:
    ModelMotor& motor_;
    std::optional<FeedbackEffect> stored_; ///< its place is taken
};

} // namespace tp
