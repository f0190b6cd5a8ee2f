// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/passage_earcons.hpp"

namespace tp {

namespace {

/// Both ends of each lie on different sides of the other; a line's own end counts to one side.
bool segments_cross(Vec2 a, Vec2 b, Vec2 p, Vec2 q) {
    const auto left_of = [](Vec2 from, Vec2 to, Vec2 place) { return cross(to - from, place - from) >= 0.0; };
    return left_of(a, b, p) != left_of(a, b, q) && left_of(p, q, a) != left_of(p, q, b);
}

bool line_crossed(const Polyline& line, Vec2 from, Vec2 to) {
    for (std::size_t i = 0; i < line.segment_count(); ++i)
        if (segments_cross(line.segment_start(i), line.segment_end(i), from, to))
            return true;
    return false;
}

bool within(const Rect& box, Vec2 place, double margin) {
    return Rect{box.min - Vec2(margin), box.max + Vec2(margin)}.contains(place);
}

} // namespace

int face_at(const std::vector<Rect>& faces, Vec2 place, int before) {
    if (before >= 0 && before < static_cast<int>(faces.size()) &&
        within(faces[static_cast<std::size_t>(before)], place, PassageEarcons::leave_mm))
        return before;
    int nearest = -1;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool nearer =
            nearest < 0 || length(faces[i].centre() - place) <
                               length(faces[static_cast<std::size_t>(nearest)].centre() - place);
        if (within(faces[i], place, 0.0) && nearer)
            nearest = static_cast<int>(i);
    }
    return nearest;
}

bool PassageEarcons::crosses(const FlatScene& scene, Vec2 place) {
    if (!before_)
        return false;
    if (crossed_ >= 0 && crossed_ < static_cast<int>(scene.lines.size()) &&
        distance_to(scene.lines[static_cast<std::size_t>(crossed_)], place) >= rearm_mm)
        crossed_ = -1;
    for (std::size_t i = 0; i < scene.lines.size(); ++i)
        if (static_cast<int>(i) != crossed_ && line_crossed(scene.lines[i], *before_, place)) {
            crossed_ = distance_to(scene.lines[i], place) < rearm_mm ? static_cast<int>(i) : -1;
            return true;
        }
    return false;
}

std::optional<Earcon> PassageEarcons::follow(const FlatScene& scene, const std::vector<Rect>& faces,
                                             Vec2 place, double now) {
    if (!is_finite(place))
        return std::nullopt;
    face_ = face_at(faces, place, face_);
    const bool crossed = crosses(scene, place);
    before_ = place;
    if (face_ != told_face_ && now - face_told_at_ >= between_faces_s) {
        told_face_ = face_;
        face_told_at_ = now;
        return face_ < 0 ? Earcon::face_left : Earcon::face_entered;
    }
    if (!crossed || now - line_told_at_ < between_lines_s)
        return std::nullopt;
    line_told_at_ = now;
    return Earcon::contour_crossed;
}

void PassageEarcons::lift() {
    before_.reset();
    face_ = told_face_ = crossed_ = -1;
}

} // namespace tp
