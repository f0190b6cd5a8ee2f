// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/aim.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr double takes_over = 1.4; ///< a face so many times larger becomes the subject
constexpr double other_third =
    0.08; ///< share of the picture beyond the middle at which the other line is nearer
constexpr double group_widest = 0.9; ///< of the picture, that everybody may fill
constexpr double group_roomy = 0.55; ///< below it there is room to come closer
constexpr double size_slope = 0.2;   ///< of the picture, within which a group's size becomes one limit worse

/// Height over the shorter side.
double height_of(const Rect& box, double aspect) { return box.height() / std::min(1.0, aspect); }

/// The size of one face: how far it is off, and the factor that brings it halfway in, for at the limit it would not stay.
void note_size(Framing& framing, double size, const AimLimits& limits) {
    const double good = std::sqrt(limits.smallest * limits.largest);
    framing.face = size;
    framing.size_off = std::log(size / good) / std::log(limits.largest / good);
    framing.grow = std::sqrt((size < good ? limits.smallest : limits.largest) * good) / size;
}

Rect round(const std::vector<TrackedFace>& faces) {
    Rect all = faces.front().box;
    for (const TrackedFace& face : faces) {
        all.min = glm::min(all.min, face.box.min);
        all.max = glm::max(all.max, face.box.max);
    }
    return all;
}

void note_cut(Framing& framing, double margin) {
    const auto over = [&framing, margin](double low, double high) {
        const double below = std::max(0.0, margin - low);
        const double above = std::max(0.0, high - (1.0 - margin));
        framing.cut_both = framing.cut_both || (below > 0.0 && above > 0.0);
        return above > below ? above : -below;
    };
    framing.cut.x = over(framing.box.min.x, framing.box.max.x);
    framing.cut.y = over(framing.box.min.y, framing.box.max.y);
}

std::optional<double> mean_tilt(const std::vector<TrackedFace>& faces) {
    double sum = 0.0;
    int count = 0;
    for (const TrackedFace& face : faces)
        if (face.tilt_deg) {
            sum += *face.tilt_deg;
            ++count;
        }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// The size of several: all of them fit in, and where there is room the smallest is not too small.
void note_group_size(Framing& framing, const std::vector<TrackedFace>& faces, const AimLimits& limits,
                     double aspect) {
    const double widest = std::max(framing.box.width(), framing.box.height());
    const double largest = height_of(faces.front().box, aspect);
    double smallest = largest;
    framing.face = largest;
    for (const TrackedFace& face : faces)
        smallest = std::min(smallest, height_of(face.box, aspect));
    const double too_large = 1.0 + std::max(widest - group_widest, largest - limits.largest) / size_slope;
    const double too_small = std::min(limits.smallest / smallest, 1.0 + (group_roomy - widest) / size_slope);
    if (too_large >= std::max(0.0, too_small)) {
        framing.size_off = std::max(0.0, too_large);
        framing.grow = 0.9 * std::min(group_widest / widest, limits.largest / largest);
    } else {
        framing.size_off = -std::max(0.0, too_small);
        framing.grow = std::min(1.2 * limits.smallest / smallest, group_widest / widest);
    }
}

Framing of_one(const TrackedFace& face, const AimLimits& limits, double aspect) {
    Framing framing;
    framing.subjects = {face.id};
    framing.box = face.box;
    framing.off = face.box.centre() - limits.place;
    framing.tolerance = limits.tolerance;
    note_size(framing, height_of(face.box, aspect), limits);
    framing.tilt_deg = face.tilt_deg;
    note_cut(framing, limits.margin);
    return framing;
}

Framing of_all(const std::vector<TrackedFace>& faces, const AimLimits& limits, double aspect) {
    Framing framing;
    for (const TrackedFace& face : faces)
        framing.subjects.push_back(face.id);
    framing.box = round(faces);
    framing.off = framing.box.centre() - limits.place;
    framing.tolerance = limits.tolerance;
    note_group_size(framing, faces, limits, aspect);
    framing.tilt_deg = mean_tilt(faces);
    note_cut(framing, limits.margin);
    return framing;
}

} // namespace

AimLimits limits_of(Aim aim) {
    switch (aim) {
    case Aim::middle:
        return {};
    case Aim::thirds:
        return {{1.0 / 3.0, 0.4}, {0.08, 0.12}, 0.15, 0.45, 0.02};
    case Aim::head_and_shoulders:
        return {{0.5, 0.4}, {0.1, 0.1}, 0.28, 0.5, 0.02};
    case Aim::everybody:
        return {{0.5, 0.45}, {0.15, 0.15}, 0.08, 0.5, 0.02};
    }
    return {};
}

void Framer::aim_at(Aim aim) {
    aim_ = aim;
    third_chosen_ = false;
}

const TrackedFace& Framer::subject(const std::vector<TrackedFace>& faces) {
    const TrackedFace& largest = faces.front();
    const auto last = std::find_if(faces.begin(), faces.end(),
                                   [this](const TrackedFace& face) { return face.id == subject_; });
    const bool stays = last != faces.end() && size_of(largest.box) < takes_over * size_of(last->box);
    const TrackedFace& chosen = stays ? *last : largest;
    if (chosen.id != subject_)
        third_chosen_ = false;
    subject_ = chosen.id;
    return chosen;
}

double Framer::third(double x) {
    if (!third_chosen_)
        right_third_ = x > 0.5;
    else if (right_third_ ? x < 0.5 - other_third : x > 0.5 + other_third)
        right_third_ = !right_third_;
    third_chosen_ = true;
    return right_third_ ? 2.0 / 3.0 : 1.0 / 3.0;
}

std::optional<Framing> Framer::frame(const std::vector<TrackedFace>& faces, double aspect) {
    if (faces.empty())
        return std::nullopt;
    AimLimits limits = limits_of(aim_);
    if (aim_ == Aim::everybody) {
        Framing all = of_all(faces, limits, aspect);
        all.missing = std::max(0, expected_ - static_cast<int>(faces.size()));
        return all;
    }
    const TrackedFace& face = subject(faces);
    if (aim_ == Aim::thirds)
        limits.place.x = third(face.box.centre().x);
    return of_one(face, limits, aspect);
}

} // namespace tp
