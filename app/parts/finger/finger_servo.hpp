// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/device_drive.hpp"
#include "app/parts/devices/touch_drive.hpp"
#include "core/base/result.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "core/servo/clock.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace tp {

/// Settings for a finger that is only drawn: it hurts nobody, and an ordinary desktop is late by times at
/// which a real device must be switched off.
ServoSettings settings_for_a_drawn_finger();

/// The device that moves the finger, the loop that serves it on a thread of its own, and the scene that is felt. It is
/// the simulated device until `use` brings another. Called from the page's thread only. Places in the surface frame, mm.
///
/// The loop of a finger that is only drawn ticks as long as it is awake. A real device's always does, for its motors are
/// not left alone.
///
/// |         | park   | stir  | rest    | wake  |
/// |---------|--------|-------|---------|-------|
/// | awake   | parked |       | resting |       |
/// | parked  |        | awake | resting | awake |
/// | resting |        |       |         | awake |
class FingerServo {
public:
    /// `surface`: width and height, mm. `settings` and `plant` are the simulated device's. In `time`, which must outlive
    /// it, nothing ticks but by `pass`; null: the machine's time, on threads of its own.
    FingerServo(Vec2 surface, const ServoSettings& settings, const SimulatedPlant& plant,
                VirtualClock* time = nullptr);

    /// An open device moves the finger from now on, without force until `engage`. Returns what moved it before, to be
    /// ended where that may wait.
    std::unique_ptr<DeviceDrive> use(std::unique_ptr<DeviceDrive> real);
    /// The simulated one again, its finger where the other has left it; without force until `engage`.
    std::unique_ptr<DeviceDrive> use_simulated();
    /// An output under a bare finger is felt from now on in place of a drawn force, without anything until `engage`; null: the
    /// drawn force again. Only where no device moves the finger. Returns the one before, to be ended where that may wait.
    std::unique_ptr<TouchDrive> feel_by(std::unique_ptr<TouchDrive> touch);
    /// It; null where a force is felt.
    TouchDrive* touch() { return touch_.get(); }
    bool by_touch() const { return touch_ != nullptr; }
    /// A device, or a pad, tells where a real finger is; place and move do nothing then.
    bool real() const { return simulated_ == nullptr || (touch_ && touch_->is_pad()); }
    /// A real finger is there: on its pad, or at a device's handle.
    bool held() const { return !touch_ || touch_->loop().snapshot().touched; }
    /// Why the device's own motors are off, in its words; empty where they are not.
    std::string complaint() const { return drive_->device().complaint(); }

    /// Renders `scene` from now on; the sentence that says why not, or empty.
    std::string show(Scene scene);
    /// Makes what is rendered; called again whenever it is rendered anew.
    using Make = std::function<Result<std::unique_ptr<HapticScene>>()>;
    /// The same for a scene that pulls in its own way.
    std::string render(Make make);
    /// Nothing is felt any more, and nothing ticks.
    void clear();
    /// What is felt; empty where nothing is.
    const FlatScene& felt() const { return felt_; }

    /// The finger is lifted and set down there.
    void place(Vec2 pointer);
    /// The hand moves there.
    void move(Vec2 pointer);
    /// The hand is gone from the surface.
    void lift();
    /// The hand; a real device's is where its finger is.
    Vec2 pointer() const { return real() ? finger() : pointer_; }
    /// Where the finger is, mm; where it was set down until the servo has seen that.
    Vec2 finger() const;

    /// Leads the relaxed finger along that contour.
    void lead_along(std::size_t contour);
    /// Leads it straight to a place.
    void lead_to(Vec2 place);
    /// The hand takes hold again where the finger is; the whole scene is felt again.
    void let_go();
    bool leads() const { return tour_number_ != 0; }
    /// The lead has come to its end; let_go() is due.
    bool has_led() const;
    /// The place that leads, mm: where the finger is, or where it should be if only ticks lead it.
    Vec2 leader() const { return touch_ ? touch_->loop().snapshot().leader() : finger(); }

    void engage();
    void disengage();
    bool engaged() const { return engaged_; }
    void set_max_force(double newtons);

    /// The finger is up for a while: one that is only drawn stands still without force, its loop without threads, until
    /// anything is done with it. Who wanted the force has it then again. False where a real device's finger goes on.
    bool park();
    /// Something is about to be felt: what was parked ticks from now on.
    void stir();
    /// Called when what was parked ticks again.
    void when_stirred(std::function<void()> call) { stirred_ = std::move(call); }
    bool parked() const { return state_ == State::parked; }

    /// Nobody is there to feel anything: without force, and a finger that is only drawn stands still.
    void rest();
    /// As before, without force until `engage`.
    void wake();

    /// With a touch output the place and the tour are its, and there is no force.
    ServoSnapshot snapshot() const;

    /// So much of `time` passes, where it was given.
    void pass(double seconds);

private:
    enum class State { awake, parked, resting };

    std::unique_ptr<DeviceDrive> simulated_drive();
    std::unique_ptr<DeviceDrive> exchange(std::unique_ptr<DeviceDrive> drive);
    Vec2 inside(Vec2 p) const;
    void relax(bool relaxed);
    void lead(Polyline way);
    void start();
    void start_threads();

    Vec2 size_; ///< mm
    Rect surface_;
    ServoSettings settings_;
    SimulatedPlant plant_;
    VirtualClock* time_;                   ///< null: the machine's
    SimulatedDevice* simulated_ = nullptr; ///< drive_'s, where it is that
    std::unique_ptr<DeviceDrive> drive_;
    std::unique_ptr<TouchDrive> touch_; ///< null: none; while it is there drive_ has no threads
    Make make_; ///< what is felt; empty: nothing
    FlatScene felt_;
    Vec2 pointer_{0.0};
    std::uint64_t seen_from_ = 0;   ///< tick from which on the servo knows where the finger was set down
    std::uint64_t tour_number_ = 0; ///< of the scene that leads; 0: none
    double max_force_;              ///< N
    bool engaged_ = false;
    State state_ = State::awake;
    std::function<void()> stirred_;
};

} // namespace tp
