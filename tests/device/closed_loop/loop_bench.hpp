// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"
#include "stamp_troubles.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp::testing {

/// A device's back end before a model of the device, and a servo loop with one or more lines, all in simulated
/// time. Who derives from it has the model, its link and the back end, and ends the loop, which stops the device,
/// before the link goes.
class LoopBench {
public:
    VirtualClock clock;
    Capabilities can;
    std::unique_ptr<ServoLoop> loop;
    std::string error; ///< why there is no loop
    bool writer_stalled = false;
    std::function<void()> after_tick = [] {};

    LoopBench() = default;
    virtual ~LoopBench() = default;
    LoopBench(const LoopBench&) = delete;
    LoopBench& operator=(const LoopBench&) = delete;

    /// What the handle feels in truth, N.
    virtual Vec2 felt() const = 0;
    /// No motor turns; where the handle has more axes than two, on none of them.
    virtual bool lets_go() const { return felt() == Vec2(0.0); }
    /// The middle of what it reaches, mm, device frame.
    virtual Vec2 middle() const { return Vec2(0.0); }
    /// Where the handle is, mm, device frame.
    virtual Vec2 handle() const = 0;
    /// Puts the handle there, at rest; the hand follows.
    virtual void place(Vec2 there) = 0;
    virtual void move_hand(Vec2 there) = 0;
    virtual bool& unplugged() = 0;
    ForceDevice& back_end() { return *back_end_; }
    /// Between the back end and the loop.
    StampTroubles& stamps() { return *stamps_; }

    void render(std::vector<Contour> lines) {
        auto made = make_haptic_scene(Scene{300.0, 300.0, std::move(lines)});
        loop->render(std::move(made).value());
        loop->engage();
    }
    /// The model's side goes on, and the servo stands still.
    void pass(double dt = 0.001) {
        if (!writer_stalled)
            deliver();
        for (double t = 0.0005; t < dt; t += 0.001)
            advance();
    }
    virtual void tick(double dt = 0.001) {
        clock.sleep_until(clock.now() + dt);
        loop->tick();
        pass(dt);
        after_tick();
    }
    void run(double seconds) {
        for (double t = 0.0005; t < seconds; t += 0.001)
            tick();
    }

protected:
    /// With what `open` of the back end has said.
    void begin(ForceDevice& back_end, const Result<Capabilities>& opened,
               const ServoSettings& settings = {}) {
        back_end_ = &back_end;
        if (!opened.ok()) {
            error = opened.error();
            return;
        }
        can = *opened;
        stamps_.emplace(back_end);
        loop = std::make_unique<ServoLoop>(*stamps_, can, clock, settings);
    }
    /// The back end's writer sends the newest that it was given.
    virtual void deliver() = 0;
    /// A millisecond of the link and the model.
    virtual void advance() = 0;

private:
    ForceDevice* back_end_ = nullptr;
    std::optional<StampTroubles> stamps_;
};

} // namespace tp::testing
