// SPDX-License-Identifier: Apache-2.0
// The hand of an ExploreSession: where it is, what it means, what it hears.
#include "app/pages/explore/explore_session.hpp"
#include "app/pages/explore/place_words.hpp"
#include "audio/guide/sonar_cue.hpp"
#include "core/guidance/tent_profile.hpp"

namespace tp {

namespace {
constexpr double grab_mm = 5.0;       ///< a hand that moves farther during a tour wants to lead itself
constexpr double still_moving_s = 1.0; ///< how long a hand that cannot be lifted (mouse, keys) is heard after a move
constexpr double device_moved_mm = 0.3; ///< a device's finger that moves by more is not at rest
constexpr double quieter = 0.35;      ///< the guide beside a force, outside the force's reach: −9 dB
} // namespace

// --- where it is ---

void ExploreSession::touchDown(double x, double y) {
    if (state_ != State::Ready || touring())
        return;
    if (!finger_down_)
        hand_kind_ = Hand::pointing;
    hand_ = frame_.to_surface({x, y});
    moved_at_ = now();
    servo_.place(*hand_);
}

void ExploreSession::moveTo(double x, double y) {
    const Vec2 to = frame_.to_surface({x, y});
    if (state_ != State::Ready || hand_ == to)
        return;
    if (!finger_down_)
        hand_kind_ = Hand::pointing;
    hand_ = to;
    if (servo_.real()) // whose handle says where the finger is, on a tour too
        return;
    moved_at_ = now();
    if (!touring() || grabs(to))
        servo_.move(to);
}

void ExploreSession::handGone() {
    if (servo_.real() || finger_down_)
        return;
    hand_kind_ = Hand::away;
    moved_at_ = -1e9;
    lift();
}

bool ExploreSession::grabs(Vec2 to) {
    if (!grab_from_)
        grab_from_ = to;
    if (length(to - *grab_from_) <= grab_mm)
        return false;
    end_tour(tr("Tour ended."));
    return true;
}

void ExploreSession::nudge(double dx, double dy) {
    if (state_ != State::Ready)
        return;
    if (touring())
        end_tour(tr("Tour ended."));
    if (servo_.real())
        return tell(tr("Move the finger with the device."), Priority::touch);
    hand_kind_ = Hand::pointing;
    moved_at_ = now();
    servo_.move(servo_.pointer() + Vec2(dx, -dy));
}

/// A fingertip on a touchscreen is where it is, whatever the drawn finger does; a device's finger and a mouse's are
/// where the force has drawn them.
Vec2 ExploreSession::felt_place() const {
    const bool fingertip = hand_kind_ == Hand::touching && !servo_.real() && !servo_.leads();
    return fingertip ? servo_.pointer() : servo_.finger();
}

// --- fingers on a touchscreen ---

void ExploreSession::fingerDown(int id, double x, double y) {
    gestures_.press(id, frame_.to_surface({x, y}), now());
    if (!gestures_.explores()) {
        guide_.silence();
        return;
    }
    hand_kind_ = Hand::touching;
    finger_down_ = true;
    hushed_ = false;
    touchDown(x, y);
    if (state_ == State::Ready)
        hear(felt_place(), now());
}

void ExploreSession::fingerMoved(int id, double x, double y) {
    gestures_.move(id, frame_.to_surface({x, y}));
    if (!gestures_.explores())
        return;
    moveTo(x, y);
    if (state_ == State::Ready)
        hear(felt_place(), now()); // at once: the next poll would be late by up to its interval
}

void ExploreSession::fingerUp(int id) {
    const TouchGestures::Gesture gesture = gestures_.release(id, now());
    if (!gestures_.explores()) {
        finger_down_ = false;
        lift();
    }
    perform(gesture);
}

void ExploreSession::fingersCancelled() {
    gestures_.cancel();
    finger_down_ = false;
    lift();
}

void ExploreSession::lift() {
    guide_.silence();
    way_.lift();
    clock_guide_.lift();
    dwell_ = Dwell(settings_.dwell_s);
}

void ExploreSession::perform(TouchGestures::Gesture gesture) {
    using enum TouchGestures::Gesture;
    switch (gesture) {
    case none:
        return;
    case double_tap:
    case three_finger_tap:
        return whereAmI();
    case double_tap_and_hold: {
        const QPointF place = frame_.from_surface(felt_place());
        return zoomHere(place.x(), place.y());
    }
    case two_finger_tap:
        toured_before_tap_ = touring();
        return stopOrStart();
    case two_finger_double_tap: // its first tap has stopped or started the force already
        if (toured_before_tap_)
            return;
        if (!engaged())
            engage();
        return toggleTour();
    }
}

// --- features ---

bool ExploreSession::stepFeature(int step) {
    if (state_ != State::Ready)
        return false;
    const int next = last_feature_ < 0 ? (step > 0 ? 0 : featureCount() - 1) : last_feature_ + step;
    if (next < 0 || next >= featureCount()) {
        last_feature_ = -1;
        return false;
    }
    goToFeature(next);
    return true;
}

void ExploreSession::goToFeature(int index) {
    if (state_ != State::Ready || index < 0 || index >= featureCount())
        return;
    if (touring())
        end_tour({});
    if (servo_.real()) { // nobody's finger is set down elsewhere: it is told the way
        last_feature_ = index;
        const Polyline& line = servo_.felt().lines[static_cast<std::size_t>(index)];
        const Vec2 way = point_along(line, nearest_arc(line, felt_place())) - felt_place();
        return tell(tr("%1: %2 o'clock, %n millimetre(s).", nullptr, static_cast<int>(std::lround(length(way))))
                        .arg(at_the_start(label_of(index)))
                        .arg(clock_direction(way)),
                    Priority::touch);
    }
    hand_kind_ = Hand::pointing;
    moved_at_ = now();
    servo_.place(landing_place(servo_.felt().lines[static_cast<std::size_t>(index)]));
    set_feature(index);
    emit modeChanged();
    tell(label_of(index), Priority::touch);
}

void ExploreSession::set_feature(int index) {
    if (index >= 0)
        last_feature_ = index;
    dwell_.settle(index);
    if (tracker_.current() == index && index >= 0)
        return;
    tracker_.set(index);
    emit featureChanged();
}

// --- what the servo says and the finger hears ---

void ExploreSession::poll() {
    const ServoSnapshot seen = servo_.snapshot();
    const double time = now();
    const QPointF finger = frame_.from_surface(servo_.finger());
    const QPointF force(seen.fx, -seen.fy);
    const QPointF pointer = servo_.leads() ? finger : frame_.from_surface(servo_.pointer());
    const double progress = servo_.leads() ? seen.tour_progress : 0.0;
    if (finger != finger_ || force != force_ || pointer != pointer_ || progress != tour_progress_) {
        finger_ = finger;
        force_ = force;
        pointer_ = pointer;
        tour_progress_ = progress;
        emit handMoved();
    }
    if (servo_.real() && length(servo_.finger() - device_was_at_) > device_moved_mm) {
        device_was_at_ = servo_.finger();
        moved_at_ = time;
    }
    watch_faults(seen.fault, time);
    lead_on(time);
    hear(felt_place(), time);
}

void ExploreSession::hear(Vec2 place, double now) {
    follow_finger(place, now);
    if (!here_)
        return;
    if (!touring() && !lifted())
        if (const std::optional<Earcon> earcon = way_.follow(servo_.felt(), face_rects_, place, now)) {
            earcons_.play(*earcon);
            if (*earcon == Earcon::contour_crossed)
                guide_.bump();
        }
    guide_finger(place, now);
}

void ExploreSession::follow_finger(Vec2 place, double now) {
    if (lifted())
        return;
    const int before = tracker_.current();
    const int feature = tracker_.follow(servo_.felt(), place);
    if (feature != before) {
        if (feature >= 0)
            last_feature_ = feature;
        emit featureChanged();
    }
    if (touring())
        dwell_.settle(feature);
    else if (tells_a_zoom(now))
        return;
    else if (const int stayed = dwell_.follow(feature, now); stayed >= 0 && here_)
        murmur(label_of(stayed));
}

bool ExploreSession::guides() const { return preferences_.choices().guide != Choices::Guide::none; }

/// How loud the guide is: beside a force that is felt it only leads to where the force begins, and softly; within the
/// force's reach it is silent, because the hand knows better and a tone would cover the words.
double ExploreSession::guide_level(double distance) const {
    if (!servo_.real() || !engaged())
        return 1.0;
    return distance < TentProfile{}.band() ? 0.0 : quieter;
}

void ExploreSession::guide_finger(Vec2 place, double now) {

    const Choices::Guide kind = preferences_.choices().guide;
    const bool beeps = kind == Choices::Guide::sonar || kind == Choices::Guide::both;
    if (touring()) {
        if (!beeps || servo_.real() || !servo_.leads())
            return guide_.silence();
        return guide_.sound(tour_cue(0.5 + place.x / frame_.width_mm, 0.5 + place.y / frame_.height_mm));
    }
    const bool moves = now - moved_at_ < still_moving_s;
    const bool present = servo_.real()  ? moves
                         : finger_down_ ? gestures_.explores()
                                        : hand_kind_ == Hand::pointing && moves;
    if (!present || hushed_ || kind == Choices::Guide::none)
        return guide_.silence();
    const Guidance guidance = law_->at(place);
    const double level = guidance.contour < 0 ? 0.0 : guide_level(guidance.distance);
    if (level <= 0.0)
        return guide_.silence();
    const Vec2 way = guidance.nearest - place;
    if (beeps) {
        SonarCue cue = sonar_cue(guidance.distance, way.x, way.y);
        cue.gain *= level;
        guide_.sound(cue);
    }
    if (kind == Choices::Guide::clock_voice || kind == Choices::Guide::both)
        if (const auto word = clock_guide_.follow(place, guidance.distance, way, now))
            say_clock(*word);
}

void ExploreSession::say_clock(const ClockGuide::Word& word) {
    murmur(tr("%1 o'clock, %n millimetre(s)", nullptr, word.millimetres).arg(word.hour));
}

void ExploreSession::watch_faults(Fault fault, double now) {
    const Fault shown = faults_.shown();
    const bool must_tell = faults_.must_tell(fault, now);
    if (disables(fault) && engaged())
        stop_everything();
    if (must_tell) {
        earcons_.play(Earcon::fault);
        tell(faultSentence(), Priority::fault);
    }
    if (faults_.must_tell_ready(now))
        tell(engaged() ? tr("The device is ready. Its force is on.")
                       : tr("The device is ready. Its force is off. Press Enter to switch it on."),
             Priority::message);
    if (faults_.shown() != shown)
        emit modeChanged();
    if (fault == Fault::device_lost && servo_.real())
        device_gone();
}

} // namespace tp
