// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/face_tracks.hpp"
#include "core/geometry/vec.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// How the person wants the picture.
enum class Aim {
    middle,             ///< one face in the middle
    thirds,             ///< one face on a vertical line of thirds, whichever is nearer
    head_and_shoulders, ///< one face, large enough that head and shoulders fill the picture
    everybody           ///< all faces whole, together in the middle
};

/// What an aim asks for. Places and lengths are shares of the picture; a size is a height over the picture's
/// shorter side.
struct AimLimits {
    Vec2 place{0.5, 0.45};     ///< of the subject's middle
    Vec2 tolerance{0.1, 0.12}; ///< so far beside the place is still on it
    double smallest = 0.15;    ///< of a face
    double largest = 0.5;
    double margin = 0.02; ///< between a face and the edges
};
/// Of one face; of everybody, `smallest` is that of the smallest face and `largest` that of all together.
AimLimits limits_of(Aim aim);

/// What the picture is about, and how it lies to the aim. All ways are in the picture (x right, y down).
struct Framing {
    std::vector<std::uint32_t> subjects; ///< ids of the faces that count for the aim
    Rect box;                            ///< round them
    Vec2 off{0.0};                  ///< from the wished place to the subject's middle, shares of the picture
    Vec2 tolerance{0.1};            ///< half the width of the place
    double size_off = 0.0;          ///< 1 at the limit of what is too large, -1 of what is too small
    double grow = 1.0;              ///< factor by which it is to become larger where it is beyond that, > 0
    double face = 0.0;              ///< size of the largest face of the subject
    std::optional<double> tilt_deg; ///< clockwise
    Vec2 cut{0.0};   ///< how far a subject reaches over an edge: x < 0 left, > 0 right, y < 0 top, > 0 bottom
    int missing = 0; ///< people who should be there and are not seen
    bool cut_both = false; ///< over opposite edges: no way to either side helps
};

/// Chooses the subject and stays with it. Stateful so that two faces of one size do not take turns.
class Framer {
public:
    explicit Framer(Aim aim) : aim_(aim) {}
    void aim_at(Aim aim);
    Aim aim() const { return aim_; }
    /// So many people belong to everybody; 0: whoever is seen.
    void expect(int people) { expected_ = people; }

    /// Nothing where there is no face. `faces` the largest first; `aspect` width over height.
    std::optional<Framing> frame(const std::vector<TrackedFace>& faces, double aspect);

private:
    const TrackedFace& subject(const std::vector<TrackedFace>& faces);
    double third(double x);

    Aim aim_;
    int expected_ = 0;
    std::uint32_t subject_ = 0; ///< the id of the last one
    bool right_third_ = false;
    bool third_chosen_ = false;
};

} // namespace tp
