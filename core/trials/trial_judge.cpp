// SPDX-License-Identifier: Apache-2.0
#include "core/trials/trial_judge.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {
constexpr double once_round = 0.9; ///< share of a closed path after which being back at the start is its end
} // namespace

TrialJudge::TrialJudge(const StudyTrial& trial)
    : task_(trial.task), longest_s_(trial.longest_s), reach_mm_(trial.reach_mm), closed_(trial.path.closed),
      end_(trial.path.closed || trial.path.points.empty() ? trial.start : trial.path.points.back()) {
    for (const Vec2 place : trial.knots)
        knots_.push_back({place});
    if (trial.path.points.empty())
        return;
    index_.emplace(FlatScene{{"path"}, {trial.path}}, study_reach_mm);
    arcs_.push_back(0.0);
    for (std::size_t i = 0; i < trial.path.segment_count(); ++i) {
        starts_.push_back(trial.path.segment_start(i));
        arcs_.push_back(arcs_.back() + length(trial.path.segment_end(i) - trial.path.segment_start(i)));
    }
}

void TrialJudge::feed(double time_s, Vec2 finger_mm) {
    if (state_ != TrialState::going)
        return;
    if (!begun_s_)
        begun_s_ = time_s;
    time_s_ = std::max(time_s_, time_s - *begun_s_);
    if (index_ && is_finite(finger_mm)) {
        const Nearest nearest = index_->nearest(finger_mm);
        sum_mm_ += nearest.distance;
        ++samples_;
        follow(nearest, finger_mm);
    }
    if (state_ == TrialState::going && longest_s_ && time_s_ >= *longest_s_)
        state_ = TrialState::out_of_time;
}

void TrialJudge::follow(const Nearest& nearest, Vec2 finger) {
    if (task_ != StudyTask::follow)
        return;
    const double whole = arcs_.back();
    const double arc = arcs_[nearest.segment] + length(nearest.point - starts_[nearest.segment]);
    if (samples_ > 1) {
        const double way = arc - arc_;
        round_ += closed_ ? way - whole * std::round(way / whole) : way;
    }
    arc_ = arc;
    for (Knot& knot : knots_)
        knot.passed = knot.passed || length(finger - knot.place) <= reach_mm_;
    if (length(finger - end_) > reach_mm_)
        return;
    if (knots_passed() == knots_.size())
        state_ = TrialState::done;
    else if (!closed_ || std::abs(round_) >= once_round * whole)
        state_ = TrialState::missed;
}

std::optional<double> TrialJudge::error_mm() const {
    return samples_ > 0 ? std::optional(sum_mm_ / static_cast<double>(samples_)) : std::nullopt;
}

std::size_t TrialJudge::knots_passed() const {
    return static_cast<std::size_t>(std::ranges::count(knots_, true, &Knot::passed));
}

} // namespace tp
