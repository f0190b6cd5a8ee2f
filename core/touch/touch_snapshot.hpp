// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/friction/friction_finger.hpp"
#include "core/geometry/vec.hpp"

#include <cstdint>

namespace tp {

/// What the touch loop knows of itself, for a page or a test that polls.
struct TouchSnapshot {
    double time = 0.0;                     ///< s, the loop's clock
    double x = 0.0, y = 0.0;               ///< mm, finger, surface frame; the last place where it is lifted
    double leader_x = 0.0, leader_y = 0.0; ///< mm, the place that leads it on a tour
    double distance = 0.0;                 ///< mm, to the nearest contour; infinity for none
    double level = 0.0;                    ///< friction that was asked for, 0 … 1
    double tick_time = 0.0;                ///< s, when the last tick was given
    double tick_amplitude = 0.0;           ///< of the last tick, 0 … 1
    double tour_progress = 0.0;            ///< 0 … 1
    std::uint64_t periods = 0;             ///< that have passed
    std::uint64_t ticks = 0;               ///< given
    std::uint64_t undelivered = 0;         ///< calls that the output refused
    std::uint64_t events = 0;              ///< that there were
    std::uint64_t scene = 0;               ///< number of the scene that is felt; 0: none
    std::int32_t event_contour = -1;       ///< of the last event
    LineEventKind event = LineEventKind::crossed; ///< the last one; nothing while `events` is 0
    std::uint32_t buttons = 0;                    ///< of a pad
    bool touched = false;                         ///< a finger lies on the surface
    bool engaged = false;
    bool lost = false;
    bool touring = false;
    bool tour_finished = false;

    Vec2 finger() const { return {x, y}; }
    Vec2 leader() const { return {leader_x, leader_y}; }
};

} // namespace tp
