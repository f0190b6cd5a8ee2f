// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/snapshot.hpp"
#include "core/touch/touch_output.hpp"
#include "device/touch_output/drawn/braked_finger.hpp"

#include <atomic>
#include <cstdint>
#include <memory>

namespace tp {

/// Who is told of the ticks of a drawn finger, to let them be heard.
class TickListener {
public:
    virtual ~TickListener() = default;
    /// There may be ticks from now on; there are none any more. As TouchOutput::open and stop.
    virtual void begin() = 0;
    virtual void end() = 0;
    /// A tick at `time` s of the caller's clock. Neither waits nor allocates.
    virtual void ticked(const Tick& tick, double time) noexcept = 0;
    /// Those that are under way end now. As TouchOutput::halt.
    virtual void hush() noexcept = 0;
};

/// The output of a machine that has none: the finger is drawn, and lags behind the hand where there is friction; who listens
/// is told of the ticks. It tells where the drawn finger is, as a pad does. The hand is moved by any one thread.
class DrawnTouch final : public TouchOutput {
public:
    /// On a surface of that size, mm, its origin in the middle. `listener` may be null.
    DrawnTouch(double width_mm, double height_mm, std::shared_ptr<TickListener> listener);

    /// The hand is there, mm, and draws the finger after it.
    void move_hand(Vec2 place) noexcept { send(place, true, false); }
    /// The finger is set down there.
    void set_down(Vec2 place) noexcept { send(place, true, true); }
    /// It is on the surface no more.
    void lift() noexcept { send({sent_.x, sent_.y}, false, false); }

    Result<TouchCapabilities> open() override;
    std::optional<PadTouch> read(double now) noexcept override;
    bool resist(double level) noexcept override;
    bool tick(const Tick& tick) noexcept override;
    void halt() noexcept override;
    void stop() noexcept override;

private:
    struct Hand {
        double x = 0.0, y = 0.0;
        std::uint64_t downs = 0; ///< counts set_down
        bool touched = false;
    };
    void send(Vec2 place, bool touched, bool down) noexcept;

    Vec2 half_; ///< mm
    std::shared_ptr<TickListener> listener_;
    Published<Hand> hand_;
    std::atomic<double> level_{0.0};
    Hand sent_; ///< only the hand's thread

    // Only the thread that reads.
    bool stopped_ = false;
    BrakedFinger finger_;
    std::uint64_t downs_ = 0;
    double time_ = -1.0;       ///< s; negative: it was not read yet
    double level_until_ = 0.0; ///< s
};

} // namespace tp
