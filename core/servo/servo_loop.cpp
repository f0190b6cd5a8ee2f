// SPDX-License-Identifier: Apache-2.0
#include "core/servo/servo_loop.hpp"

#include "core/servo/real_time.hpp"

#include <algorithm>

namespace tp {

namespace {

/// s by which a device that does not tell of its damping may be later than it tells.
constexpr double untold_lateness = 0.004;

/// The largest factor by which a map lengthens a step.
double stretch(const glm::dmat2& m) {
    const double squares = glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]);
    const double area = glm::determinant(m);
    return std::sqrt(0.5 * (squares + std::sqrt(std::max(0.0, squares * squares - 4.0 * area * area))));
}

} // namespace

ServoLoop::ServoLoop(ForceDevice& device, const Capabilities& capabilities, Clock& clock,
                     ServoSettings settings)
    : device_(device), guard_(device), clock_(clock), settings_(settings), period_(1.0 / settings.rate),
      stretch_(stretch(settings.device_to_surface.linear)),
      lag_(0.5 * period_ + std::max(0.0, capabilities.delay)),
      device_damping_(std::max(0.0, capabilities.damping) / (stretch_ * stretch_)),
      most_damping_(0.5 * settings.handle_mass / (stretch_ * stretch_) / (lag_ + period_)),
      max_force_(settings.limits.max_force),
      watchdog_(device, {(1.0 + settings.limits.late_periods) / settings.rate, settings.limits.stall,
                         settings.limits.ramp_down}),
      chain_(settings.limits, capabilities, 1.0 / settings.rate), readings_(settings.limits.stale_after),
      forecast_(period_, capabilities.delay, capabilities.resolution * stretch_),
      observer_(static_cast<std::size_t>(std::lround(std::max(0.0, capabilities.delay) * settings.rate)),
                {std::min(ObserverLimits{}.max_damping, most_damping_), ObserverLimits{}.min_speed,
                 device_damping_}) {
    last_tick_ = clock_.now();
}

ServoLoop::~ServoLoop() { stop(); }

std::uint64_t ServoLoop::render(std::unique_ptr<const HapticScene> scene) {
    return scenes_.offer(std::move(scene));
}

void ServoLoop::start() {
    if (running())
        return;
    quit_.store(false);
    thread_ = std::thread([this] { run(); });
    watch_thread_ = std::thread([this] { watch(); });
}

void ServoLoop::stop() noexcept {
    quit_.store(true);
    if (thread_.joinable())
        thread_.join();
    if (watch_thread_.joinable())
        watch_thread_.join();
    device_.write(SafeForce{});
    device_.stop();
    forget_force();
}

/// What the next tick must not go on from; while no thread runs.
void ServoLoop::forget_force() noexcept {
    watchdog_.rest();
    chain_.rest();
    readings_ = FreshReadings(settings_.limits.stale_after);
    velocity_ = VelocityFilter{};
    forecast_.reset();
    fade_left_ = 0.0;
    rendered_ = Vec2(0.0);
    engaged_before_ = engaged_before_ && disables(chain_.fault());
    ServoSnapshot view = snapshot_.latest();
    view.fx = view.fy = 0.0;
    view.gain = 0.0;
    view.fault = chain_.fault();
    view.engaged = false;
    snapshot_.publish(view);
}

void ServoLoop::run() noexcept {
    real_time_.store(prefer_real_time(20));
    memory_locked_.store(lock_memory(this, sizeof *this));
    double due = clock_.now();
    last_tick_ = due;
    while (!quit_.load(std::memory_order_relaxed)) {
        const double begun = clock_.now();
        lateness_.record(begun - due);
        tick();
        const double now = clock_.now();
        compute_.record(now - begun);
        due += period_;
        if (now >
            due) { // a late loop goes on with the next whole period: ticks are not made up for in a burst
            const double missed = std::floor((now - due) / period_) + 1.0;
            missed_periods_.fetch_add(static_cast<std::uint64_t>(missed), std::memory_order_relaxed);
            due += missed * period_;
        }
        clock_.sleep_until(due);
    }
    forget_memory(this, sizeof *this);
}

void ServoLoop::watch() noexcept {
    prefer_real_time(21); // above the loop that it watches
    while (!quit_.load(std::memory_order_relaxed)) {
        check();
        clock_.sleep_until(clock_.now() + 0.001);
    }
}

void ServoLoop::take_new_scene(Vec2 finger) noexcept {
    const auto* const offered = scenes_.take();
    if (offered == current_)
        return;
    current_ = offered;
    fade_from_ = rendered_;
    fade_left_ = settings_.scene_fade;
    far_look_.reset();
    tour_.reset();
    if (current_->value && current_->value->tour && !current_->value->tour->points.empty())
        tour_.emplace(*current_->value->tour, finger, current_->value->tour_manner);
    hold_.reset();
    if (current_->value && current_->value->hold_mm > 0.0)
        hold_.emplace(current_->value->flat, current_->value->profile, current_->value->hold_mm);
}

Guidance ServoLoop::wanted(Vec2 finger, double dt) noexcept {
    if (current_ == nullptr || current_->value == nullptr)
        return {};
    Guidance guidance = far_look_.at(*current_->value->law, finger);
    if (hold_)
        guidance = hold_->hold(finger, guidance);
    if (tour_)
        guidance.force = tour_->step(finger, chain_.engaged() ? dt : 0.0);
    return guidance;
}

double ServoLoop::stiffness() const noexcept {
    if (current_ == nullptr || current_->value == nullptr)
        return 0.0;
    return tour_ ? current_->value->tour_manner.stiffness : current_->value->stiffness;
}

/// mm/s, surface frame, when a force written now acts; as little of it as the filter leaves where readings are overdue.
Vec2 ServoLoop::velocity_ahead() const noexcept { return velocity_.share_left() * forecast_.velocity(); }

Vec2 ServoLoop::damping(const Guidance& guidance, Vec2 finger) const noexcept {
    if (guidance.contour < 0 || !(guidance.distance > 0.0) || !(settings_.line_damping_ratio > 0.0))
        return Vec2(0.0);
    const TentProfile& profile = current_->value->profile;
    const double near = 1.0 - guidance.distance / profile.range;
    if (!(near > 0.0))
        return Vec2(0.0);
    const double steepest = std::max(profile.stiffness, current_->value->stiffness);
    const double stiffness = 1e3 * steepest; // N/m; √(kg · N/m) is N·s/m
    // A quarter more, and a quarter of a period for what jitters: what just balances the leak lets a handle swing.
    const double unsure = device_damping_ > 0.0 ? 0.25 * period_ : 0.25 * period_ + untold_lateness;
    // Where a corner pulls too, it is along a line that a handle swings, and the pull changes faster.
    const bool along_too = steepest > profile.stiffness;
    const double missing = (along_too ? 2.25 : 1.25) * stiffness * (lag_ + unsure) - device_damping_;
    const double settling =
        2.0 * settings_.line_damping_ratio * std::sqrt(settings_.handle_mass * stiffness) / stretch_;
    const double at_any_speed = std::clamp(missing, 0.0, most_damping_);
    const double when_slow = std::clamp(missing + settling, 0.0, most_damping_);
    const Vec2 normal = (guidance.nearest - finger) / guidance.distance;
    const Vec2 ahead = velocity_ahead();
    const Vec2 velocity = along_too ? ahead : glm::dot(ahead, normal) * normal;
    const double speed = length(velocity);
    const double slow = speed > settings_.settling_speed ? settings_.settling_speed / speed : 1.0;
    const double drag = at_any_speed * std::min(1.0, 2.0 * near) + (when_slow - at_any_speed) * near * slow;
    return -1e-3 * forecast_.worth() * drag * velocity;
}

Vec2 ServoLoop::paid_back(const Guidance& guidance, Vec2 finger, double dt) noexcept {
    // The potential is the field's own only while the whole field, and nothing else, is on the device.
    const bool whole = settings_.energy_observer && !tour_ && fade_left_ <= 0.0 && chain_.gain() == 1.0;
    if (!whole) {
        observer_.reset();
        reference_ = std::nan("");
        return Vec2(0.0);
    }
    // Where the force is cut at a limit, what it does to a finger without delay takes the potential's place.
    const double size = length(settings_.device_to_surface.pull_back_force(guidance.force));
    const bool cut = size > chain_.max_force();
    const Vec2 felt = cut ? (chain_.max_force() / size) * guidance.force : guidance.force;
    if (!std::isfinite(reference_))
        reference_ = 0.0;
    else if (cut || was_cut_)
        reference_ -= 0.5 * glm::dot(felt + last_felt_, finger - last_finger_);
    else
        reference_ += guidance.energy - last_energy_;
    was_cut_ = cut;
    last_felt_ = felt;
    last_finger_ = finger;
    last_energy_ = guidance.energy;
    return observer_.observe(finger, velocity_ahead(), reference_, dt, forecast_.worth());
}

void ServoLoop::tick() noexcept {
    const double now = clock_.now();
    const double dt = std::clamp(now - last_tick_, 0.0, 10.0 * period_);
    last_tick_ = now;

    const Watchdog::Reading reading = watchdog_.read(now);
    std::optional<double> taken;
    if (reading.state)
        taken = readings_.taken(reading.state->time, now);
    if (taken) {
        state_ = reading.state;
        velocity_.feed(*taken, state_->position);
    }
    velocity_.elapse(now);
    const Vec2 position = state_ ? state_->position : Vec2(0.0);
    const Vec2 finger = settings_.device_to_surface(position);
    if (taken)
        forecast_.feed(*taken, finger);

    take_new_scene(finger);
    const Guidance guidance = wanted(finger, dt);
    Vec2 force = guidance.force;
    if (!tour_)
        force += damping(guidance, finger);
    force += paid_back(guidance, finger, dt);
    if (fade_left_ > 0.0) {
        const double old_share = fade_left_ / settings_.scene_fade;
        force = old_share * fade_from_ + (1.0 - old_share) * force;
        fade_left_ -= dt;
    }
    rendered_ = is_finite(force) ? force : Vec2(0.0);

    const bool wants = wanted_engaged_.load(std::memory_order_relaxed);
    const double share_left = watchdog_.take_share_left();
    if (share_left < 1.0)
        chain_.lowered_to(share_left);
    if (wants && !engaged_before_) {
        watchdog_.rearm(now);
        chain_.engage(now);
    }
    if (!wants)
        chain_.disengage();
    engaged_before_ = wants;
    chain_.set_max_force(max_force_.load(std::memory_order_relaxed));

    SafetyInput input;
    input.now = now;
    input.fresh = taken.has_value();
    input.device_lost = reading.lost;
    input.halted = watchdog_.halted();
    input.motors_off = reading.motors_off;
    input.position = position;
    input.velocity = velocity_.velocity();
    input.force = settings_.device_to_surface.pull_back_force(force);
    input.stiffness = stretch_ * stretch_ * stiffness();
    SafeForce safe = chain_.pass(input);
    if (!watchdog_.write(safe, now)) {
        input.device_lost = true;
        safe = chain_.pass(input);
    }
    ++ticks_;

    const Affine& calibration = settings_.device_to_surface;
    const Vec2 delivered = glm::inverse(glm::transpose(calibration.linear)) * safe.newtons();
    observer_.wrote(delivered);
    ServoSnapshot view;
    view.time = now;
    view.x = finger.x;
    view.y = finger.y;
    view.fx = delivered.x;
    view.fy = delivered.y;
    view.distance = guidance.distance;
    view.nearest_x = guidance.nearest.x;
    view.nearest_y = guidance.nearest.y;
    view.gain = chain_.gain();
    view.tour_progress = tour_ ? tour_->progress() : 0.0;
    view.worst_lateness = lateness_.max();
    view.ticks = ticks_;
    view.scene = current_ ? current_->number : 0;
    view.contour = guidance.contour;
    view.fault = chain_.fault();
    view.buttons = state_ ? state_->buttons : 0;
    view.engaged = chain_.engaged();
    view.touring = tour_ && !tour_->finished();
    view.tour_finished = tour_ && tour_->finished();
    snapshot_.publish(view);
}

} // namespace tp
