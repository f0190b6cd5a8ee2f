// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/clock.hpp"
#include "core/touch/touch_loop.hpp"
#include "device/touch_output/drawn/drawn_touch.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// Pad frame → surface frame (size in mm, origin in the middle): the pad true in shape, as large as the surface holds.
Affine pad_on_surface(const Rect& pad, Vec2 surface);

/// An output for a bare finger that is open, and the loop that serves it on a thread of its own once it is started. Called from
/// the page's thread. Where it ends, on any thread, nothing is felt first.
class TouchDrive {
public:
    /// `surface`: width and height, mm. `settings` but for the map of a pad. `clock` must outlive it; null: the machine's own.
    TouchDrive(std::unique_ptr<TouchOutput> output, const TouchCapabilities& can, Vec2 surface,
               TouchSettings settings, Clock* clock = nullptr);

    TouchLoop& loop() { return loop_; }
    const TouchLoop& loop() const { return loop_; }
    const TouchOutput& output() const { return *output_; }

    /// The finger lies on a pad of its own, which tells its place; neither mouse nor screen does.
    bool is_pad() const { return !reach_.empty(); }
    /// Polygon of the places that a pad reaches, surface frame, mm; empty where it is none.
    const std::vector<Vec2>& reach() const { return reach_; }

    /// These lines are felt from now on, and the finger is led along `tour`, where there is one; number of that scene. Without
    /// a line nothing is felt.
    std::uint64_t show(FlatScene scene, std::optional<Polyline> tour = {});
    /// The hand draws the finger there; sets it down there; lifts it. Nothing where it is a pad.
    void move(Vec2 place);
    void set_down(Vec2 place);
    void lift();

private:
    SteadyClock own_clock_;
    std::unique_ptr<TouchOutput> output_;
    DrawnTouch* drawn_; ///< output_, where it is that
    std::vector<Vec2> reach_;
    double scale_;   ///< of the surface, in terms of the finger's own way
    TouchLoop loop_; ///< after what it uses
};

} // namespace tp
