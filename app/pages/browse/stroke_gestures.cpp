// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/stroke_gestures.hpp"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace tp {

namespace {
constexpr std::size_t most_track = 4096; ///< places; a finger that rests for an hour is none
} // namespace

std::optional<Gesture> StrokeGestures::fingers(const std::vector<QPointF>& places, std::int64_t now_ms) {
    now_ms_ = now_ms;
    if (places.empty()) {
        const std::optional<Gesture> gesture = most_ > 0 ? complete() : std::nullopt;
        most_ = 0;
        return gesture;
    }
    if (most_ == 0) { // the first of them
        began_ms_ = now_ms;
        from_.clear();
        track_.clear();
        wandered_ = false;
    }
    most_ = std::max(most_, places.size());
    for (std::size_t i = from_.size(); i < places.size(); ++i)
        from_.push_back(places[i]);
    if (places.size() == most_) // one that was lifted has left its place to another
        for (std::size_t i = 0; i < places.size(); ++i)
            wandered_ = wandered_ || QLineF(from_[i], places[i]).length() > sizes_.still_px;
    if (track_.size() < most_track && (track_.empty() || track_.back() != places.front()) &&
        places.size() == most_)
        track_.push_back(places.front());
    return std::nullopt;
}

void StrokeGestures::cancel() {
    most_ = 0;
    last_tap_.reset();
}

std::optional<Gesture> StrokeGestures::complete() {
    if (!wandered_) {
        if (most_ == 1)
            return taps(Gesture::tap, Gesture::double_tap);
        if (most_ == 2)
            return taps(Gesture::two_finger_tap, Gesture::two_finger_double_tap);
        last_tap_.reset();
        return most_ == 3 ? std::optional(Gesture::three_finger_tap) : std::nullopt;
    }
    last_tap_.reset();
    if (most_ == 2 && strokes_across() >= 3)
        return Gesture::two_finger_z;
    if (most_ != 1)
        return std::nullopt;
    const QPointF way = track_.back() - track_.front();
    const double across = std::abs(way.x()), along = std::abs(way.y());
    if (std::max(across, along) < sizes_.swipe_px || std::max(across, along) < 1.5 * std::min(across, along))
        return std::nullopt; // too short, or nobody knows which way
    if (across > along)
        return way.x() > 0.0 ? Gesture::swipe_right : Gesture::swipe_left;
    return way.y() > 0.0 ? Gesture::swipe_down : Gesture::swipe_up;
}

/// `once`, or `twice` where it follows one like it.
std::optional<Gesture> StrokeGestures::taps(Gesture once, Gesture twice) {
    const QPointF at = from_.front();
    if (last_tap_ && last_tap_->once == once && began_ms_ - last_tap_->ended_ms <= sizes_.again_ms &&
        QLineF(last_tap_->at, at).length() <= sizes_.near_px) {
        last_tap_.reset();
        return twice;
    }
    last_tap_ = Tap{once, at, now_ms_};
    return once;
}

/// How often the first finger went on across by a stroke's length, turning round each time.
int StrokeGestures::strokes_across() const {
    int strokes = 0;
    double way = 0.0; // of the stroke that is being drawn: its sign and length so far
    double turn = track_.front().x();
    for (const QPointF& place : track_) {
        const double from_turn = place.x() - turn;
        if (std::abs(from_turn) > std::abs(way) && (way == 0.0 || (from_turn > 0.0) == (way > 0.0))) {
            if (std::abs(way) < sizes_.swipe_px && std::abs(from_turn) >= sizes_.swipe_px)
                ++strokes;
            way = from_turn;
        } else if (const double back = turn + way - place.x(); std::abs(back) >= sizes_.still_px) {
            turn += way;
            way = place.x() - turn;
            if (std::abs(way) >= sizes_.swipe_px)
                ++strokes;
        }
    }
    return strokes;
}

} // namespace tp
