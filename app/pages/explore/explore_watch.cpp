// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_watch.hpp"

namespace tp {

namespace {
constexpr int poll_ms = 16;
}

ExploreWatch::ExploreWatch(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                           ExploreEar& ear, ExploreDevice& device, ExploreTouch& touch, const PageClock& now)
    : servo_(servo), view_(view), finger_(finger), tour_(tour), ear_(ear), device_(device), touch_(touch),
      now_(now) {
    timer_.setInterval(poll_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &ExploreWatch::poll);
    connect(&view_, &ExploreView::replaced, this, &ExploreWatch::stir);
    connect(&tour_, &ExploreTour::changed, this, [this] { servo_.stir(); }); // its names are told by the poll
    servo_.when_stirred([this] { stir(); });
}

ExploreWatch::~ExploreWatch() { servo_.when_stirred({}); }

void ExploreWatch::enter() {
    state_ = State::watching;
    servo_.wake();
    stir();
}

void ExploreWatch::leave() {
    state_ = State::away;
    timer_.stop();
    servo_.rest();
}

/// Something was done: the quiet begins anew.
void ExploreWatch::stir() {
    quiet_.stir();
    if (state_ == State::away)
        return;
    state_ = State::watching;
    view_.ready() ? timer_.start() : timer_.stop();
}

void ExploreWatch::rest_where_quiet(Fault fault, double now) {
    const bool quiet = finger_.up() && !tour_.touring() && device_.shows(fault);
    if (!quiet_.due(quiet, now) || !servo_.park())
        return;
    state_ = State::resting;
    timer_.stop();
    device_.watch(servo_.snapshot().fault, now); // of its last tick
}

void ExploreWatch::poll() {
    const ServoSnapshot seen = servo_.snapshot();
    const double now = now_();
    finger_.poll(seen, now);
    device_.watch(seen.fault, now);
    touch_.watch();
    tour_.follow(seen.tour_progress, now);
    ear_.hear();
    rest_where_quiet(seen.fault, now);
}

} // namespace tp
