// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_ear.hpp"

#include "audio/guide/sonar_cue.hpp"
#include "core/guidance/tent_profile.hpp"

#include <optional>

namespace tp {

namespace {
constexpr double still_moving_s =
    1.0; ///< how long a hand that cannot be lifted (mouse, keys) is heard after a move
constexpr double quieter = 0.35; ///< the guide beside a force, outside the force's reach: −9 dB
} // namespace

ExploreEar::ExploreEar(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                       ExploreZoom& zoom, ExploreChoices& choices, ExploreWords& words, EarconPlayer& earcons,
                       SonifiedGuide& guide, const PageClock& now)
    : servo_(servo), view_(view), finger_(finger), tour_(tour), zoom_(zoom), choices_(choices), words_(words),
      earcons_(earcons), guide_(guide), now_(now) {
    connect(&view_, &ExploreView::replaced, this, &ExploreEar::lift);
    connect(&view_, &ExploreView::fresh, this, &ExploreEar::listen);
    connect(&tour_, &ExploreTour::changed, this, [this] {
        if (!tour_.touring())
            silence();
    });
    connect(&choices_, &ExploreChoices::changed, this, [this] {
        if (!choices_.beeps() && !choices_.speaks())
            silence();
    });
}

ExploreEar::~ExploreEar() { silence(); }

void ExploreEar::enter() { state_ = State::open; }

void ExploreEar::leave() {
    silence();
    state_ = State::away;
}

void ExploreEar::listen() {
    if (state_ == State::hushed)
        state_ = State::open;
}

void ExploreEar::hush() {
    silence();
    if (state_ == State::open)
        state_ = State::hushed;
}

void ExploreEar::lift() {
    silence();
    way_.lift();
    clock_guide_.lift();
    finger_.forget_stay();
}

void ExploreEar::hear() {
    const double now = now_();
    const Vec2 place = finger_.felt_place();
    if (!finger_.lifted())
        tell_feature(now);
    if (state_ == State::away)
        return;
    if (!tour_.touring() && !finger_.lifted())
        tell_way(place, now);
    guide(place, now);
}

void ExploreEar::tell_feature(double now) {
    finger_.follow();
    if (tour_.touring())
        return finger_.settle();
    if (zoom_.tells(now))
        return;
    if (const int stayed = finger_.stays(now); stayed >= 0)
        words_.murmur(view_.label_of(stayed));
}

void ExploreEar::tell_way(Vec2 place, double now) {
    const std::optional<Earcon> earcon = way_.follow(view_.felt(), view_.face_places(), place, now);
    if (!earcon || (*earcon == Earcon::contour_crossed && ticks()))
        return;
    earcons_.play(*earcon);
}

/// A line under the finger is felt as a tick: it is not told by sound as well.
bool ExploreEar::ticks() const { return servo_.by_touch() && servo_.engaged(); }

/// A hand is there that wants to hear where the lines are.
bool ExploreEar::present(double now) const {
    const bool moves = now - finger_.moved_at() < still_moving_s;
    if (servo_.real())
        return moves && servo_.held();
    switch (finger_.hand().is()) {
    case HandState::Is::touching:
        return true;
    case HandState::Is::pointing:
        return moves;
    case HandState::Is::gesturing:
    case HandState::Is::lifted:
    case HandState::Is::away:
        return false;
    }
    return false;
}

/// How loud the guide is: beside a force that is felt it only leads to where the force begins, and softly;
/// within the force's reach it is silent, because the hand knows better and a tone would cover the words.
double ExploreEar::level(double distance) const {
    if (ticks())
        return distance <= on_line_mm ? 0.0 : 1.0;
    if (!servo_.real() || !servo_.engaged())
        return 1.0;
    return distance < TentProfile{}.band() ? 0.0 : quieter;
}

void ExploreEar::guide(Vec2 place, double now) {
    if (tour_.touring())
        return lead_by_sound(place);
    if (!present(now) || state_ == State::hushed || (!choices_.beeps() && !choices_.speaks()))
        return silence();
    const Guidance guidance = view_.nearest(place);
    const double loud = guidance.contour < 0 ? 0.0 : level(guidance.distance);
    if (loud <= 0.0)
        return silence();
    const Vec2 way = guidance.nearest - place;
    if (choices_.beeps()) {
        SonarCue cue = sonar_cue(guidance.distance, way.x, way.y);
        cue.gain *= loud;
        guide_.sound(cue);
    }
    if (!choices_.speaks())
        return;
    clock_guide_.busy_until(words_.busy_until());
    if (const auto word = clock_guide_.follow(place, guidance.distance, way, now))
        words_.murmur(tr("%1 o'clock, %n millimetre(s)", nullptr, word->millimetres).arg(word->hour));
}

/// A tour of a finger that is only drawn is heard; so is where ticks lead to.
void ExploreEar::lead_by_sound(Vec2 place) {
    if (servo_.by_touch())
        place = servo_.leader();
    if (!choices_.beeps() || (servo_.real() && !servo_.by_touch()) ||
        tour_.state() != ExploreTour::State::Leading)
        return silence();
    const SheetFrame& frame = view_.frame();
    guide_.sound(tour_cue(0.5 + place.x / frame.width_mm, 0.5 + place.y / frame.height_mm));
}

} // namespace tp
