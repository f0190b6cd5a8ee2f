// SPDX-License-Identifier: Apache-2.0
#include "core/touch/touch_loop.hpp"

#include "core/servo/real_time.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

double bounded_latency(double seconds) {
    return seconds > 0.0 ? std::min(seconds, TouchSettings::longest_latency_s) : 0.0;
}

} // namespace

double touch_rate(double rate) noexcept { return rate > 500.0 ? std::min(rate, 1000.0) : 500.0; }

TouchLoop::TouchLoop(TouchOutput& output, const TouchCapabilities& can, Clock& clock,
                     const TouchSettings& settings)
    : output_(output), guard_(output), clock_(clock), pad_to_surface_(settings.pad_to_surface),
      quiet_s_(settings.quiet_s), has_friction_(can.means == TouchMeans::friction),
      is_pad_(can.pad.has_value()), period_(1.0 / touch_rate(can.rate)), last_period_(clock.now()) {
    choose(settings.choices);
    set_latency(settings.latency_s);
}

TouchLoop::~TouchLoop() { stop(); }

void TouchLoop::tell(Vec2 place) noexcept {
    last_told_ = {last_told_.number + 1, clock_.now(), true, place, last_told_.downs};
    told_.publish(last_told_);
}

void TouchLoop::tell_set_down(Vec2 place) noexcept {
    ++last_told_.downs;
    tell(place);
}

void TouchLoop::tell_lifted() noexcept {
    last_told_ = {last_told_.number + 1, clock_.now(), false, last_told_.place, last_told_.downs};
    told_.publish(last_told_);
}

void TouchLoop::set_latency(double seconds) noexcept { latency_.store(bounded_latency(seconds)); }

void TouchLoop::start() {
    if (running())
        return;
    quit_.store(false);
    thread_ = std::thread([this] { run(); });
}

void TouchLoop::stop() noexcept {
    quit_.store(true);
    if (thread_.joinable())
        thread_.join();
    output_.halt();
    output_.stop();
    on_ = false;
    view_.level = 0.0;
    view_.engaged = false;
    snapshot_.publish(view_);
}

void TouchLoop::run() noexcept {
    prefer_real_time(19); // below a force's loop
    lock_memory(this, sizeof *this);
    double due = clock_.now();
    last_period_ = due;
    while (!quit_.load(std::memory_order_relaxed)) {
        lateness_.record(clock_.now() - due);
        tick();
        due += period_;
        if (const double late = clock_.now() - due; late > 0.0) // periods are not made up for in a burst
            due += std::ceil(late / period_) * period_;
        clock_.sleep_until(due);
    }
    forget_memory(this, sizeof *this);
}

/// True where there is a newer place.
bool TouchLoop::take_place(double now) noexcept {
    Told newest = place_;
    if (!is_pad_) {
        newest = told_.latest();
    } else if (const std::optional<PadTouch> touch = output_.read(now)) {
        newest = {place_.number + 1, touch->time, touch->touched, pad_to_surface_(touch->place), 0};
        view_.buttons = touch->buttons;
    }
    if (!is_finite(newest.place) || newest.number == place_.number)
        return false;
    if (newest.touched && (!place_.touched || newest.downs != place_.downs)) { // it was set down elsewhere
        velocity_ = VelocityFilter{};
        if (finger_)
            finger_->lift();
    }
    place_ = newest;
    if (place_.touched)
        velocity_.feed(place_.time, place_.place);
    return true;
}

void TouchLoop::take_scene() noexcept {
    const auto* const offered = scenes_.take();
    if (offered == current_)
        return;
    current_ = offered;
    finger_.reset();
    lead_.reset();
    if (!current_->value)
        return;
    finger_.emplace(current_->value->friction);
    if (current_->value->tour && !current_->value->tour->points.empty())
        lead_.emplace(*current_->value->tour, place_.place);
}

/// Where the finger will be when what is commanded now is felt.
Vec2 TouchLoop::ahead(Vec2 velocity) const noexcept {
    const Vec2 way = latency_.load(std::memory_order_relaxed) * velocity;
    const double far = length(way);
    return place_.place +
           (far > TouchSettings::farthest_ahead_mm ? TouchSettings::farthest_ahead_mm / far : 1.0) * way;
}

void TouchLoop::note(const Friction& friction) noexcept {
    if (friction.events.empty())
        return;
    view_.events += friction.events.size();
    view_.event = friction.events.back().kind;
    view_.event_contour = friction.events.back().contour;
}

Tick TouchLoop::tick_under(Vec2 place, Vec2 velocity, double dt) noexcept {
    const Guidance exact = current_->value->exact.at(place);
    const Friction friction = finger_->step(place, velocity, exact);
    const TickChoices choices = choices_.latest();
    view_.distance = exact.distance;
    view_.level = choices.strength * friction.level;
    note(friction);
    return lead_ ? lead_->step(place_.place, dt, choices) : tick_of(friction, choices);
}

void TouchLoop::resist(double level) noexcept {
    if (has_friction_ && !output_.resist(level))
        ++view_.undelivered;
}

void TouchLoop::give(const Tick& tick, double now) noexcept {
    if (tick.empty())
        return;
    if (!output_.tick(tick)) {
        ++view_.undelivered;
        return;
    }
    ++view_.ticks;
    view_.tick_time = now;
    view_.tick_amplitude = tick.amplitude();
}

void TouchLoop::switch_off() noexcept {
    view_.level = 0.0;
    if (finger_)
        finger_->lift();
    if (on_)
        output_.halt();
    on_ = false;
}

void TouchLoop::tick() noexcept {
    const double now = clock_.now();
    const double dt = std::clamp(now - last_period_, 0.0, 10.0 * period_);
    last_period_ = now;

    const bool fresh = take_place(now);
    take_scene();
    if (place_.touched && now - place_.time > quiet_s_)
        velocity_ = VelocityFilter{};
    view_.engaged = wanted_engaged_.load(std::memory_order_relaxed);
    view_.lost = view_.lost || output_.lost();
    const bool silent = view_.lost || ExitGuard::leaving();
    const Asked asked = asked_.latest();

    if (silent || !view_.engaged || !place_.touched || !finger_) {
        switch_off();
    } else {
        on_ = true;
        const Tick tick = tick_under(ahead(velocity_.velocity()), velocity_.velocity(), dt);
        resist(view_.level);
        give(tick, now);
        if (fresh)
            place_to_command_.record(clock_.now() - place_.time);
    }
    if (asked.number != asked_done_ && !silent)
        give(asked.tick, now);
    asked_done_ = asked.number;

    view_.time = now;
    view_.x = place_.place.x;
    view_.y = place_.place.y;
    view_.touched = place_.touched;
    view_.scene = current_ != nullptr ? current_->number : 0;
    view_.touring = lead_ && !lead_->finished();
    view_.tour_finished = lead_ && lead_->finished();
    view_.tour_progress = lead_ ? lead_->progress() : 0.0;
    view_.leader_x = lead_ ? lead_->leader().x : 0.0;
    view_.leader_y = lead_ ? lead_->leader().y : 0.0;
    ++view_.periods;
    snapshot_.publish(view_);
}

} // namespace tp
