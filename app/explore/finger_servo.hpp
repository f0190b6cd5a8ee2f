// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/scene/scene_builder.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <string>

namespace tp {

/// Settings for a finger that is only drawn: it hurts nobody, and an ordinary desktop is late by times at
/// which a real device must be switched off.
ServoSettings settings_for_a_drawn_finger();

/// The simulated device, the loop that serves it on a thread of its own, and the scene that is felt. Called
/// from the page's thread only. Places in the surface frame, mm.
class FingerServo {
public:
    FingerServo(const SurfaceSize& surface, const ServoSettings& settings, const SimulatedPlant& plant);

    /// Renders `scene` from now on; the sentence that says why not, or empty.
    std::string show(Scene scene);
    /// Nothing is felt any more.
    void clear();
    /// What is felt; empty where nothing is.
    const FlatScene& felt() const { return felt_; }

    /// The finger is lifted and set down there.
    void place(Vec2 pointer);
    /// The hand moves there.
    void move(Vec2 pointer);
    Vec2 pointer() const { return pointer_; }
    /// Where the finger is, mm; where it was set down until the servo has seen that.
    Vec2 finger() const;

    /// Leads the relaxed finger along that contour.
    void lead_along(std::size_t contour);
    /// The hand takes hold again where the finger is; the whole scene is felt again.
    void let_go();
    bool leads() const { return tour_number_ != 0; }
    /// The lead has come to its end; let_go() is due.
    bool has_led() const;

    void engage();
    void disengage();
    bool engaged() const { return engaged_; }
    void set_max_force(double newtons) { loop_.set_max_force(newtons); }

    ServoSnapshot snapshot() const { return loop_.snapshot(); }

private:
    Vec2 inside(Vec2 p) const;

    Rect surface_;
    SteadyClock clock_;
    SimulatedDevice device_;
    Capabilities capabilities_;
    ServoLoop loop_;
    Scene scene_;
    FlatScene felt_;
    Vec2 pointer_{0.0};
    std::uint64_t seen_from_ = 0;   ///< tick from which on the servo knows where the finger was set down
    std::uint64_t tour_number_ = 0; ///< of the scene that leads; 0: none
    bool engaged_ = false;
};

} // namespace tp
