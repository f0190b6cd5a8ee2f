// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/face_tracks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tp {

namespace {

constexpr double farthest_step = 1.0;    ///< of its own size, that a face moves from one frame to the next
constexpr double largest_growth = 1.8;   ///< from one frame to the next
constexpr double longest_course_s = 0.3; ///< that an unseen face is thought to go on as it went

bool is_face(const AimFace& face) {
    return is_finite(face.box.min) && is_finite(face.box.max) && face.confidence >= least_face_confidence &&
           face.box.width() > 0.0 && face.box.height() > 0.0 && size_of(face.box) < 4.0 &&
           face.box.max.x > 0.0 && face.box.max.y > 0.0 && face.box.min.x < 1.0 && face.box.min.y < 1.0;
}

/// Clockwise turn of the line through both eyes, degrees in -90 … 90.
std::optional<double> tilt_of(const AimFace& face, double aspect) {
    if (!face.eyes)
        return std::nullopt;
    auto [left, right] = *face.eyes;
    if (right.x < left.x)
        std::swap(left, right);
    const Vec2 way{(right.x - left.x) * aspect, right.y - left.y};
    if (!is_finite(way) || length(way) < 1e-6)
        return std::nullopt;
    return std::atan2(way.y, way.x) * 180.0 / std::numbers::pi;
}

std::optional<double> known(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// How unlike two boxes are: 0 the same, 1 and more another face.
double unlikeness(const TrackedFace& track, const AimFace& face, double now_s) {
    const double before = size_of(track.box);
    const double now = size_of(face.box);
    const double growth = std::max(before, now) / std::min(before, now);
    const Vec2 expected = track.box.centre() + std::min(now_s - track.seen_s, longest_course_s) * track.speed;
    const double step = length(expected - face.box.centre()) / std::max(before, now);
    if (!track.name.empty() && track.name == face.name)
        return 0.25 * std::min(step, 1.0);
    return std::max(step / farthest_step, std::log(growth) / std::log(largest_growth));
}

void follow(TrackedFace& track, const AimFace& face, double now_s, double aspect) {
    const double dt = std::max(0.0, now_s - track.seen_s);
    const double share = track.sightings == 0 ? 1.0 : 1.0 - std::exp(-dt / smoothing_s);
    const Vec2 before = track.box.centre();
    track.box.min += share * (face.box.min - track.box.min);
    track.box.max += share * (face.box.max - track.box.max);
    if (track.sightings > 0 && dt > 1e-3)
        track.speed += share * ((track.box.centre() - before) / dt - track.speed);
    if (const auto tilt = tilt_of(face, aspect))
        track.tilt_deg = track.tilt_deg ? *track.tilt_deg + share * (*tilt - *track.tilt_deg) : *tilt;
    if (!face.name.empty())
        track.name = face.name;
    if (const auto brightness = known(face.brightness))
        track.brightness = brightness;
    track.eyes_shut = face.eyes_shut;
    ++track.sightings;
    track.seen_s = now_s;
}

/// A camera that is swung takes the only face along, however far.
bool may_be_swung(const TrackedFace& track, const AimFace& face) {
    const double growth = size_of(face.box) / size_of(track.box);
    return growth < largest_growth && growth > 1.0 / largest_growth &&
           (track.name.empty() || face.name.empty() || track.name == face.name);
}

struct Match {
    double unlike;
    std::size_t track;
    std::size_t face;
};

} // namespace

std::vector<std::string> names_of(const std::vector<TrackedFace>& faces) {
    std::vector<const TrackedFace*> known;
    for (const TrackedFace& face : faces)
        if (!face.name.empty())
            known.push_back(&face);
    std::sort(known.begin(), known.end(),
              [](const TrackedFace* a, const TrackedFace* b) { return a->id < b->id; });
    std::vector<std::string> names;
    for (const TrackedFace* const face : known)
        if (std::find(names.begin(), names.end(), face->name) == names.end())
            names.push_back(face->name);
    return names;
}

void FaceTracks::forget() {
    all_.clear();
    counted_.clear();
    last_s_.reset();
}

void FaceTracks::see(const AimFrame& frame) {
    if (!std::isfinite(frame.time_s) || !std::isfinite(frame.aspect) || frame.aspect <= 0.0)
        return;
    if (last_s_ && (frame.time_s < *last_s_ || frame.time_s - *last_s_ > longest_gap_s)) {
        forget();
        ++breaks_;
    }
    last_s_ = frame.time_s;

    std::vector<const AimFace*> faces;
    for (const AimFace& face : frame.faces)
        if (is_face(face))
            faces.push_back(&face);
    std::stable_sort(faces.begin(), faces.end(),
                     [](const AimFace* a, const AimFace* b) { return size_of(a->box) > size_of(b->box); });
    faces.resize(std::min(faces.size(), most_faces));

    std::vector<Match> matches;
    for (std::size_t t = 0; t < all_.size(); ++t)
        for (std::size_t f = 0; f < faces.size(); ++f)
            if (const double unlike = unlikeness(all_[t], *faces[f], frame.time_s); unlike < 1.0)
                matches.push_back({unlike, t, f});
    std::stable_sort(matches.begin(), matches.end(),
                     [](const Match& a, const Match& b) { return a.unlike < b.unlike; });
    std::vector<bool> found(all_.size(), false);
    std::vector<bool> taken(faces.size(), false);
    for (const Match& match : matches) {
        if (found[match.track] || taken[match.face])
            continue;
        found[match.track] = taken[match.face] = true;
        follow(all_[match.track], *faces[match.face], frame.time_s, frame.aspect);
    }
    if (all_.size() == 1 && faces.size() == 1 && !taken[0] && may_be_swung(all_[0], *faces[0])) {
        taken[0] = true;
        follow(all_[0], *faces[0], frame.time_s, frame.aspect);
    }
    std::erase_if(all_,
                  [&frame](const TrackedFace& track) { return frame.time_s - track.seen_s > face_stays_s; });
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (!taken[f] && all_.size() < most_faces) {
            TrackedFace track;
            track.id = next_id_++;
            track.box = faces[f]->box;
            track.seen_s = frame.time_s;
            follow(track, *faces[f], frame.time_s, frame.aspect);
            all_.push_back(std::move(track));
        }

    counted_.clear();
    for (const TrackedFace& track : all_)
        if (track.sightings >= sightings_to_count)
            counted_.push_back(track);
    std::stable_sort(counted_.begin(), counted_.end(), [](const TrackedFace& a, const TrackedFace& b) {
        return size_of(a.box) > size_of(b.box);
    });
}

} // namespace tp
