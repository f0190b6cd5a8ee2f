// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/accuracy_bench.hpp"

#include "app/figures/bench/bench_clock.hpp"
#include "app/figures/bench/bench_scene.hpp"
#include "app/figures/bench/nearest_method.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/guidance/haptic_scene.hpp"

#include <random>

namespace tp {

namespace {

/// The tent towards what a method says is nearest.
class MethodLaw final : public GuidanceLaw {
public:
    MethodLaw(std::unique_ptr<NearestMethod> method, TentProfile profile)
        : method_(std::move(method)), profile_(profile) {}
    Guidance at(Vec2 finger) const noexcept override {
        Nearest nearest = method_->nearest(finger);
        nearest.towards = nearest.point - finger;
        Guidance guidance = pull_towards(nearest, profile_);
        if (!is_finite(guidance.force)) // the published division by the distance
            guidance.force = Vec2(0.0);
        return guidance;
    }

private:
    std::unique_ptr<NearestMethod> method_;
    TentProfile profile_;
};

struct Candidate {
    const char* law;
    const char* index;
    Continuity continuity; ///< of a law of ours that is not the plain tent
    bool looks_at_all = false;
};

constexpr double blend_mm = 0.4;
const std::vector<Candidate>& candidates() {
    static const std::vector<Candidate> all{
        {"exact", "ours", {}},
        {"blended", "ours", {0.0, blend_mm, false}},
        {"with_corner_cue", "ours", {0.0, 0.0, true}},
        {"exact", "boost_rtree", {}},
        {"exact", "plain_loop", {}, true},
        {"nearest_vertex", "nanoflann", {}},
        {"published", "published_kdtree", {}},
        {"published", "published_scan", {}, true},
    };
    return all;
}

std::unique_ptr<const GuidanceLaw> built(const Candidate& candidate, const FlatScene& flat,
                                         const TentProfile& profile, AccuracyRow& row) {
    const BusyClock clock;
    std::unique_ptr<const GuidanceLaw> law;
    if (candidate.continuity.off())
        law = std::make_unique<MethodLaw>(NearestMethod::make(candidate.index, flat), profile);
    else
        law = make_law(flat, profile, LawKind::exact, candidate.continuity);
    row.build_ms = 1e-6 * clock.ns();
    return law;
}

double ns_per_force(const GuidanceLaw& law, const std::vector<Vec2>& path, const AccuracyPlan& plan) {
    std::size_t batch = 16;
    for (double took = 0.0; batch < path.size(); batch *= 2) {
        const BusyClock clock;
        for (std::size_t i = 0; i < batch; ++i)
            keep(law.at(path[i]).force.x);
        took = clock.ns();
        if (took > 1e6 * plan.batch_ms)
            break;
    }
    batch = std::min(batch, path.size());
    std::vector<double> ns;
    for (int round = 0; round < plan.rounds; ++round) {
        const std::size_t from =
            batch < path.size() ? static_cast<std::size_t>(round) * batch % (path.size() - batch) : 0;
        const BusyClock clock;
        for (std::size_t i = from; i < from + batch; ++i)
            keep(law.at(path[i]).force.x);
        ns.push_back(clock.ns() / static_cast<double>(batch));
    }
    return quantile(std::move(ns), 0.5);
}

/// Places within the band, where there is a force, and what it is there.
struct Truth {
    std::vector<Vec2> places;
    std::vector<Vec2> forces;
};

Truth truth_of(const AccuracyScene& scene, const TentProfile& profile, const AccuracyPlan& plan) {
    const ExactLaw law(flatten(scene.scene, {plan.truth_mm, 90.0, 24}), profile);
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> along(-bench_half_side_mm, bench_half_side_mm);
    Truth truth;
    for (int tried = 0; tried < 100 * plan.places && std::ssize(truth.places) < plan.places; ++tried) {
        const double x = along(random);
        const Vec2 place(x, along(random));
        const Guidance there = law.at(place);
        if (there.distance < profile.band()) {
            truth.places.push_back(place);
            truth.forces.push_back(there.force);
        }
    }
    return truth;
}

void weigh(const GuidanceLaw& law, const Truth& truth, AccuracyRow& row) {
    std::vector<double> errors;
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.places.size(); ++i) {
        errors.push_back(length(law.at(truth.places[i]).force - truth.forces[i]));
        sum += errors.back();
        row.max_error_n = std::max(row.max_error_n, errors.back());
    }
    row.mean_error_n = sum / static_cast<double>(errors.size());
    row.p99_error_n = quantile(std::move(errors), 0.99);
}

std::size_t segments_of(const FlatScene& flat) {
    std::size_t count = 0;
    for (const Polyline& line : flat.lines)
        count += line.segment_count();
    return count;
}

} // namespace

std::vector<AccuracyRow> run_accuracy_bench(const AccuracyScene& scene, const AccuracyPlan& plan,
                                            const std::function<void(const std::string&)>& progress) {
    const TentProfile profile;
    progress(scene.name + ": the curves to " + std::to_string(plan.truth_mm) + " mm");
    const Truth truth = truth_of(scene, profile, plan);
    const std::vector<Vec2> path = hand_path(100'000);
    std::vector<FlattenTolerance> tolerances;
    for (const double chord : plan.tolerances_mm)
        tolerances.push_back({chord, 90.0, 24});
    tolerances.push_back({});
    std::vector<AccuracyRow> rows;
    for (const FlattenTolerance& tolerance : tolerances) {
        const FlatScene flat = flatten(scene.scene, tolerance);
        const std::size_t segments = segments_of(flat);
        progress(scene.name + ": " + std::to_string(segments) + " segments");
        for (const Candidate& candidate : candidates()) {
            if (candidate.looks_at_all && segments > plan.most_scanned)
                continue;
            AccuracyRow row{scene.name,      candidate.law,           candidate.index,
                            tolerance.chord, tolerance.facet_degrees, segments};
            const auto law = built(candidate, flat, profile, row);
            row.ns_median = ns_per_force(*law, path, plan);
            weigh(*law, truth, row);
            rows.push_back(row);
        }
    }
    return rows;
}

} // namespace tp
