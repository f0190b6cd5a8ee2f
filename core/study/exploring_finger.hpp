// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <vector>

namespace tp {

/// How a finger without eyes goes about a surface.
struct ExplorerManner {
    double search_speed = 80.0;  ///< mm/s while nothing is felt
    double follow_speed = 40.0;  ///< mm/s along a line
    double lane = 10.0;          ///< mm between the lanes of the search
    double felt = 0.06;          ///< N, the smallest force that is noticed
    double lead = 3.0;           ///< mm that the hand is ahead of the finger
    double wiggle = 2.0;         ///< mm to either side of a line while following it, to keep feeling it
    double wiggle_rate = 2.0;    ///< Hz
    double turn_gain = 12.0;     ///< rad/(s·N): how quickly the hand turns towards the pull
    double lost_after = 0.8;     ///< s without a noticeable force before the line is given up
    double visited_radius = 5.0; ///< mm round places already followed that no longer tempt
    double again_after = 25.0;   ///< mm of way after which a place counts as met again
    double give_up_again = 15.0; ///< mm along known places after which the line is left
};

/// A hand that searches a surface lane by lane and follows every line it feels until it closes, ends or is
/// lost. It knows what a blind finger knows, the finger's place and the force on it, and nothing of the
/// scene. Deterministic.
class ExploringFinger {
public:
    /// `area` in mm, surface frame; width and height > 0.
    explicit ExploringFinger(const Rect& area, ExplorerManner manner = {});

    /// Where the hand holds the finger after `dt` seconds, mm; `finger` in mm and `force` in N are what it
    /// feels.
    Vec2 step(Vec2 finger, Vec2 force, double dt);
    /// The last lane has been searched.
    bool finished() const { return finished_; }
    bool following() const { return following_; }
    /// Where the first lane begins, mm.
    Vec2 start() const;

private:
    void search(Vec2 finger, Vec2 force, double dt);
    void follow(Vec2 finger, Vec2 force, double dt);
    void begin_following(Vec2 finger, Vec2 force);
    void go_back_to_search(Vec2 finger);
    std::size_t cell_of(Vec2 p) const;
    bool visited(Vec2 p) const;
    void visit(Vec2 p);

    Rect area_;
    ExplorerManner manner_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<float> first_visit_; ///< a cell: mm of way at which it was first passed, negative for never

    Vec2 hand_;
    int lane_ = 0;
    double along_lane_ = 0.0; ///< mm done of the present lane
    bool finished_ = false;

    bool following_ = false;
    Vec2 heading_{1.0, 0.0};
    Vec2 last_finger_{0.0};
    double followed_ = 0.0; ///< mm along all lines so far
    double again_ = 0.0;    ///< mm along places met again, without a break
    double unfelt_ = 0.0;   ///< s
    double clock_ = 0.0;    ///< s of following, for the wiggle
};

} // namespace tp
