// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/chance.hpp"
#include "core/participant/force_sense.hpp"
#include "core/participant/person.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp {

/// What a bare finger meets on a surface that cannot pull it.
struct BareTouch {
    double friction = 0.0; ///< level, 0 … 1
    bool ticked = false;   ///< since the step before
};

/// A hand without eyes that follows a line of which it feels only that the finger is on it (friction) or passes it (ticks): nothing
/// says on which side the line lies or which way it runs. It goes straight on until it meets a line, goes back there and round it in a
/// circle until it meets the line again. Then it goes across the line to and fro, remembers where the last places of the line were
/// felt, each with an error, and goes on along them; where it meets nothing it sways wider, and at last circles where it had the line.
/// It knows how late a person feels, not how late a device is. Deterministic.
class TouchHand {
public:
    /// It begins at `start`; `area` is the surface; mm. `on_line`: it is told that it begins on a line. `dt_s` > 0 passes between two
    /// steps.
    TouchHand(const Person& person, const Rect& area, Vec2 start, bool on_line, double dt_s,
              std::uint64_t seed);

    /// Where the hand means to be, mm; `finger` (mm) and `touch` are what it meets.
    Vec2 step(Vec2 finger, const BareTouch& touch);

    /// It has met a line, and goes along it or looks for it there.
    bool following() const { return mode_ != Mode::search; }
    std::size_t times_lost() const { return times_lost_; }

private:
    enum class Mode { search, circle, sway };
    struct Felt {
        Vec2 place{0.0};
        BareTouch touch;
    };
    void feel(const Felt& felt);
    void meet_line(Vec2 place);
    void search();
    void sway();
    void circle();
    void begin_circle();
    bool known(Vec2 place) const;
    void go_towards(Vec2 place, double speed);

    Person person_;
    Rect area_;
    double dt_s_;
    Chance chance_;
    SlowNoise along_noise_, across_noise_;
    std::vector<Felt> on_its_way_; ///< ring: what was met, until it is felt
    std::size_t next_ = 0;
    bool on_ridge_ = false;
    Vec2 ridge_from_{0.0};    ///< mm, where friction began
    Vec2 ridge_to_{0.0};      ///< mm, where it was felt last
    double gap_s_ = 0.0;      ///< it is not felt for so long
    std::vector<Vec2> trail_; ///< mm, places of the line
    Vec2 hand_;
    Vec2 base_;    ///< mm, about which it sways or circles
    Vec2 heading_; ///< unit vector
    double side_;  ///< ±1: which way it goes round
    Mode mode_;
    double phase_ = 0.0;     ///< rad
    double wide_;            ///< mm, to either side, or of the circle
    double unmet_rad_ = 0.0; ///< of phase since the line was met
    std::size_t times_lost_ = 0;
};

} // namespace tp
