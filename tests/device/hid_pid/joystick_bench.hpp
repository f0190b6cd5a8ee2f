// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../closed_loop/loop_bench.hpp"
#include "device/hid_pid/pid_joystick.hpp"
#include "device/hid_pid/simulated_joystick_link.hpp"
#include "recorded_descriptors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tp::testing {

/// Where a SideWinder Force Feedback 2 has what in its reports, read off its recorded descriptor by hand.
inline JoystickWire sidewinder() {
    static const std::vector<std::uint8_t> descriptor = bytes_of(sidewinder_force_feedback_2.hex);
    JoystickWire wire;
    wire.descriptor = descriptor;
    wire.create = 0x01;
    wire.block_load = 0x02;
    wire.effect_bytes = 15;
    wire.enable_byte = 10;
    wire.direction_byte = 11;
    wire.direction_bytes = 1;
    wire.whole_turn = 255;
    wire.magnitude_full = 255;
    wire.x_byte = 0;
    wire.y_byte = 2;
    wire.axis_most = 511;
    wire.state_bytes = 2;
    wire.power_bit = 4;
    return wire;
}

/// Lets a transport that a test keeps be opened.
class BorrowedJoystickLink : public PidTransport {
public:
    explicit BorrowedJoystickLink(PidTransport& lent) : lent_(lent) {}
    std::vector<std::uint8_t> descriptor() override { return lent_.descriptor(); }
    Got read(hid::Report& report, int wait_ms) noexcept override { return lent_.read(report, wait_ms); }
    Got input_now(hid::Report& report) noexcept override { return lent_.input_now(report); }
    bool write(const hid::Report& report) noexcept override { return lent_.write(report); }
    void write_from_signal(const hid::Report& report) noexcept override { lent_.write_from_signal(report); }
    bool set_feature(const hid::Report& report) noexcept override { return lent_.set_feature(report); }
    bool get_feature(hid::Report& report) noexcept override { return lent_.get_feature(report); }
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report> no_force,
                                              std::span<const hid::Report> at_the_end) override {
        return lent_.guard(no_force, at_the_end);
    }

private:
    PidTransport& lent_;
};

/// A model stick on a simulated cable. The scale is the stick's true one, so that what is felt is what was sent.
struct JoystickBench : LoopBench {
    ModelJoystick model;
    SimulatedJoystickLink link;
    PidJoystick device;

    static JoystickScale true_scale(const ModelJoystick& model) {
        return {model.newtons_at_full, model.sign, true};
    }

    explicit JoystickBench(const JoystickWire& wire = open_controller(), const HandlePlant& plant = {},
                           unsigned delay_ms = 0, std::uint32_t seed = 1)
        : model(wire, plant), link(model, delay_ms, seed),
          device(
              [this]() -> Result<std::unique_ptr<PidTransport>> {
                  return std::unique_ptr<PidTransport>(std::make_unique<BorrowedJoystickLink>(link));
              },
              {"a stick", "0001"}, true_scale(model), LatestWriter::Thread::caller) {
        begin(device, device.open());
        for (int i = 0; i < 10; ++i) // what the opening has sent arrives
            link.advance();
    }
    ~JoystickBench() override { loop.reset(); }

    Vec2 felt() const override { return model.force(); }
    Vec2 handle() const override { return model.grip(); }
    void place(Vec2 there) override { model.place_grip(there); }
    void move_hand(Vec2 there) override { model.move_hand(there); }
    bool& unplugged() override { return link.troubles.unplugged; }

    /// The stick limits nothing itself: it may feel what the chain may send (40 N/s and a spring's change over the
    /// finger's own way), and what it did not hear of for a while comes at once. Motors that come on again before anybody could know that they were off pull as
    /// before.
    bool may_be_felt(Vec2 before, Vec2 now, double dt, double slack) const {
        return length(now) <= length(before) + slack || came_on_unheard_ ||
               length(now - before) <= 40.0 * (dt + 1e-3 * silent_ms_) + stiffness * way_unheard() + slack;
    }

    void tick(double dt = 0.001) override {
        silent_ms_ = link.silent_ms();
        const unsigned off_ms = off_ms_;
        clock.sleep_until(clock.now() + dt);
        loop->tick();
        const Vec2 finger = loop->snapshot().finger();
        ways_[ticks_++ % ways_.size()] = length(finger - finger_);
        finger_ = finger;
        pass(dt);
        came_on_unheard_ = off_ms > 0 && model.motors_on() && (off_ms < 6 || unheard_);
        note_motors();
        after_tick();
    }

protected:
    void deliver() override { device.deliver(); }
    void advance() override { link.advance(); }

private:
    /// mm that the finger has gone in the ticks that the stick hears of now: one of the last few, or all of a silence.
    double way_unheard() const {
        double longest = 0.0;
        double all = 0.0;
        for (std::size_t back = 1;
             back <= std::min<std::size_t>({ticks_, ways_.size(), silent_ms_ + few_ticks}); ++back) {
            const double way = ways_[(ticks_ - back) % ways_.size()];
            longest = std::max(longest, way);
            all += way;
        }
        return silent_ms_ > 0 ? all : longest;
    }
    void note_motors() {
        const JoystickLinkTroubles& t = link.troubles;
        off_ms_ = model.motors_on() ? 0 : off_ms_ + 1;
        unheard_ = (off_ms_ > 1 && unheard_) || t.mute || t.drop > 0.0 || t.garble > 0.0 || t.cut > 0.0 ||
                   !model.wire().has_state;
    }

    static constexpr double stiffness = 0.2;    ///< N/mm, of the default profile
    static constexpr std::size_t few_ticks = 4; ///< from the servo to the stick
    std::array<double, 256> ways_{};            ///< mm, of each tick
    std::size_t ticks_ = 0;
    Vec2 finger_{0.0};
    unsigned silent_ms_ = 0;
    unsigned off_ms_ = 0;
    bool unheard_ = false; ///< what the stick said since its motors went off may be lost
    bool came_on_unheard_ = false;
};

} // namespace tp::testing
