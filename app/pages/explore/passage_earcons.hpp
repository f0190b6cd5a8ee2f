// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/earcons.hpp"
#include "core/guidance/scene.hpp"

#include <optional>
#include <vector>

namespace tp {

/// What a finger passes on its way, as earcons: a face entered or left, a line crossed. None comes faster than it
/// can be told from the next one: faces are told late rather than never, crossings that come too fast are dropped.
class PassageEarcons {
public:
    static constexpr double leave_mm = 3.0; ///< beyond a face's edge until it is left
    static constexpr double rearm_mm = 1.0; ///< from a line until crossing it again counts
    static constexpr double between_faces_s = 0.3;
    static constexpr double between_lines_s = 0.06;

    /// The finger is at `place` (mm) at `now` seconds; `faces` are where faces lie, on the same surface.
    std::optional<Earcon> follow(const FlatScene& scene, const std::vector<Rect>& faces, Vec2 place,
                                 double now);
    /// The finger is lifted, or the scene is another: the next place was not reached by moving.
    void lift();
    /// The face that the finger is in; -1 for none.
    int face() const { return face_; }

private:
    bool crosses(const FlatScene& scene, Vec2 place);

    std::optional<Vec2> before_;
    int face_ = -1;
    int told_face_ = -1;
    int crossed_ = -1; ///< the line that was crossed last and is not left yet
    double face_told_at_ = -1e9;
    double line_told_at_ = -1e9;
};

/// Which of the faces `place` is in; one that it was in is left only beyond the margin. -1 for none.
int face_at(const std::vector<Rect>& faces, Vec2 place, int before = -1);

} // namespace tp
