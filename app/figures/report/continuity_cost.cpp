// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/continuity_cost.hpp"

#include "app/figures/report/hand_path.hpp"
#include "app/figures/report/test_scenes.hpp"
#include "core/guidance/branch_hold.hpp"
#include "core/guidance/haptic_scene.hpp"

#include <algorithm>
#include <numbers>
#include <random>

namespace tp {

namespace {

/// A law as one finger feels it, with what the finger remembers.
class Felt {
public:
    Felt(const FlatScene& flat, TentProfile profile, const Continuity& continuity)
        : law_(make_law(flat, profile, LawKind::exact, continuity)), hold_(flat, profile, continuity.hold_mm),
          holds_(continuity.hold_mm > 0.0), flat_(flat), profile_(profile), margin_(continuity.hold_mm) {}
    Guidance at(Vec2 finger) {
        const Guidance guidance = law_->at(finger);
        return holds_ ? hold_.hold(finger, guidance) : guidance;
    }
    void forget() { hold_ = BranchHold(flat_, profile_, margin_); }

private:
    std::unique_ptr<const GuidanceLaw> law_;
    BranchHold hold_;
    bool holds_;
    const FlatScene& flat_;
    TentProfile profile_;
    double margin_;
};

void walk(const FlatScene& flat, const Continuity& continuity, const TentProfile& profile,
          std::size_t samples, ContinuityCost& cost) {
    Felt felt(flat, profile, continuity);
    const auto exact = make_law(flat, profile, LawKind::exact);
    const std::vector<Vec2> path = hand_path(samples);
    std::vector<double> errors;
    double sum = 0.0;
    std::size_t wrong = 0;
    std::size_t clicks = 0;
    Vec2 last(0.0);
    for (std::size_t i = 0; i < samples; ++i) {
        const Vec2 finger = path[i];
        const Vec2 force = felt.at(finger).force;
        const double step = length(force - last);
        last = force;
        if (i > 0) {
            cost.largest_step_n = std::max(cost.largest_step_n, step);
            clicks += step > 0.25 * profile.peak() ? 1 : 0;
        }
        const Guidance truth = exact->at(finger);
        if (!(truth.distance < profile.band()))
            continue;
        const double error = length(force - truth.force);
        errors.push_back(error);
        sum += error;
        wrong += error > 0.1 * profile.peak() ? 1 : 0;
    }
    cost.clicks_per_m =
        static_cast<double>(clicks) / (1e-3 * hand_path_step_mm * static_cast<double>(samples));
    const auto count = static_cast<double>(errors.size());
    cost.mean_error_n = sum / count;
    cost.wrong_fraction = static_cast<double>(wrong) / count;
    const auto p99 = errors.begin() + static_cast<std::ptrdiff_t>(0.99 * count);
    std::nth_element(errors.begin(), p99, errors.end());
    cost.p99_error_n = *p99;
    cost.max_error_n = *std::max_element(errors.begin(), errors.end());
}

void go_round(const FlatScene& flat, const Continuity& continuity, const TentProfile& profile, int loops,
              ContinuityCost& cost) {
    constexpr int steps = 1885; // 0.01 mm apart
    constexpr double radius = 3.0;
    constexpr double step = 2.0 * std::numbers::pi / steps;
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> along(radius - hand_half_side_mm, hand_half_side_mm - radius);
    Felt felt(flat, profile, continuity);
    for (int loop = 0; loop < loops; ++loop) {
        felt.forget();
        const double x = along(random);
        const Vec2 centre(x, along(random));
        double work = 0.0;
        for (int i = -steps; i < steps; ++i) { // once round to arrive at a branch, once to measure
            const double angle = step * (i + 0.5);
            const Vec2 out(std::cos(angle), std::sin(angle));
            const Vec2 force = felt.at(centre + radius * out).force;
            if (i >= 0)
                work += glm::dot(force, Vec2(-out.y, out.x)) * radius * step;
        }
        cost.work_given_mj = std::max(cost.work_given_mj, work);
    }
}

void tremble(const Continuity& continuity, const TentProfile& profile, double seconds, ContinuityCost& cost) {
    FlatScene lines{{"upper", "lower"}, {{{{-50, 3}, {50, 3}}, false}, {{{-50, -3}, {50, -3}}, false}}};
    Felt felt(lines, profile, continuity);
    std::mt19937_64 random(4);
    std::normal_distribution<double> tremor(0.0, 0.05);
    const auto ticks = static_cast<int>(1000.0 * seconds);
    int switches = 0;
    Vec2 last = felt.at({1.0, 0.0}).force;
    for (int i = 0; i < ticks; ++i) {
        const Vec2 force = felt.at({1.0, tremor(random)}).force;
        switches += length(force - last) > 0.25 * profile.peak() ? 1 : 0;
        last = force;
    }
    cost.tremor_clicks_per_s = switches / seconds;
}

} // namespace

std::vector<ContinuityCost> measure_continuity(const ContinuityEffort& effort) {
    const FlatScene flat = flatten(reference_face());
    const TentProfile profile;
    struct Manner {
        const char* name;
        double width;
        Continuity continuity;
    };
    const Manner manners[] = {
        {"exact", 0.0, {}},
        {"hold", 0.3, {0.3, 0.0, false}},
        {"hold", 0.5, {0.5, 0.0, false}},
        {"blend", 0.3, {0.0, 0.3, false}},
        {"blend", 0.5, {0.0, 0.5, false}},
        {"blend", 1.0, {0.0, 1.0, false}},
        {"corner_cue", 0.5 * profile.range, {0.0, 0.0, true}},
        {"blend_and_corner_cue", 0.3, {0.0, 0.3, true}},
    };
    std::vector<ContinuityCost> costs;
    for (const Manner& manner : manners) {
        ContinuityCost cost;
        cost.manner = manner.name;
        cost.width_mm = manner.width;
        walk(flat, manner.continuity, profile, effort.samples, cost);
        go_round(flat, manner.continuity, profile, effort.loops, cost);
        tremble(manner.continuity, profile, effort.tremor_seconds, cost);
        costs.push_back(cost);
    }
    return costs;
}

} // namespace tp
