// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/participant/force_sense.hpp"
#include "core/participant/person.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp {

/// A place that the finger passed along a line, and which way it was going.
struct FeltPlace {
    Vec2 place{0.0};   ///< mm
    Vec2 heading{0.0}; ///< unit vector
};

/// A hand without eyes that follows the line it feels. It knows where it meant to be, where the finger is, and what is felt of the
/// force; nothing of the scene. Deterministic.
///
/// It goes on along its heading, which turns across the felt pull and leans towards it; gives way to the pull; stops where the pull is
/// against it; turns round where it finds itself on the way back. What is felt is late, and is compared with the heading of that time
/// (Miall, Weir, Wolpert, Stein, "Is the cerebellum a Smith predictor?", J Mot Behav 25, 1993). A strong pull that is suddenly gone is a
/// line that was left, and the hand goes back; one that fades is a line that was reached. Where nothing was felt for a while it sways,
/// then circles wider and wider round where it felt the line last. It goes slower after it lost the line and where the pull is strong,
/// and faster where there is little. Before anything is felt it goes straight on until the surface ends.
class StudyHand {
public:
    /// It begins at `start`; `area` is the surface; mm. `dt_s` > 0 passes between two steps. `on_line`: it is told that it begins on
    /// a line.
    StudyHand(const Person& person, const Rect& area, Vec2 start, bool on_line, double dt_s,
              std::uint64_t seed);

    /// Where the hand means to be, mm; `finger` (mm) and `force` (N) are what acts on it.
    Vec2 step(Vec2 finger, Vec2 force);

    /// It is following a line, or swaying for one that it had.
    bool following() const { return mode_ != Mode::search; }
    /// Places along the line, a few millimetres apart, since it was first found.
    const std::vector<FeltPlace>& trail() const { return trail_; }
    std::size_t times_lost() const { return times_lost_; }

private:
    enum class Mode { search, go_back, follow, sway, circle };
    void search(Vec2 felt);
    void follow(Vec2 felt);
    void find(Vec2 felt);
    bool slipped_off() const;
    void lose();
    void go_back();
    void turn_across(Vec2 felt);
    void remember(Vec2 finger);
    double bend_factor() const;
    void sway();
    void circle();
    void begin(Mode mode, Vec2 from);
    void go_towards(Vec2 place, double speed);
    bool known(Vec2 place) const;

    Person person_;
    Rect area_;
    double dt_s_;
    Chance chance_;
    ForceSense sense_;
    SlowNoise along_noise_, across_noise_;
    Mode mode_;
    bool on_line_;                  ///< it came to the line, and has not left it since
    std::vector<FeltPlace> places_; ///< ring, of the finger, as old as what is felt
    std::size_t next_place_ = 0;
    Vec2 felt_heading_{1.0, 0.0}; ///< of the hand, when what is felt now acted
    Vec2 felt_at_{0.0};           ///< mm, where the finger was when what is felt now acted
    Vec2 found_at_{0.0};          ///< mm, where a line was felt again
    Vec2 last_felt_{0.0};         ///< N, the last pull that was felt clearly
    Vec2 last_felt_at_{0.0};      ///< mm, where
    Vec2 line_at_{0.0};           ///< mm, the last place where the line was felt for sure
    double recent_n_ = 0.0;       ///< N, the strongest pull of a moment ago, fading
    double strongest_n_ = 0.0;    ///< N, the strongest pull that it has learned to expect
    Vec2 slipped_at_{1e9};        ///< mm, where it slipped off last
    Vec2 hand_;
    Vec2 heading_;
    double side_;           ///< ±1: where the hand tries first at a corner
    double speed_ = 0.0;    ///< mm/s
    double trust_;          ///< share of the preferred speed
    double unfelt_s_ = 0.0; ///< since something was felt
    double swayed_s_ = 0.0;
    double swayed_turns_ = 0.0; ///< to and fro
    Vec2 sway_from_{0.0};
    double turn_rate_ = 0.0; ///< rad/s, smoothed
    double way_back_mm_ = 0.0;
    std::vector<FeltPlace> trail_;
    std::size_t trail_sure_ = 0; ///< so many places of the trail lie on the line for sure
    std::size_t times_lost_ = 0;
};

} // namespace tp
