// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/loop_work.hpp"

#include "app/figures/report/test_scenes.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/guidance/published_law.hpp"

#include <algorithm>
#include <numbers>
#include <random>

namespace tp {

namespace {

constexpr double half_side_mm = 100.0;
constexpr double loop_radius_mm = 3.0;

Vec2 random_place(std::mt19937_64& random, double half_side) {
    std::uniform_real_distribution<double> place(-half_side, half_side);
    const double x = place(random);
    return {x, place(random)};
}

void compare_forces(const GuidanceLaw& law, const GuidanceLaw& truth, double peak, int points,
                    LoopWork& row) {
    std::mt19937_64 random(1);
    int wrong = 0;
    int pulled = 0;
    for (int i = 0; i < points; ++i) {
        const Vec2 place = random_place(random, half_side_mm);
        const Vec2 force = law.force_at(place);
        const Vec2 right = truth.force_at(place);
        const double error = length(force - right);
        pulled += force != Vec2(0.0) || right != Vec2(0.0) ? 1 : 0;
        row.max_force_error_n = std::max(row.max_force_error_n, error);
        wrong += error > 0.1 * peak ? 1 : 0;
    }
    row.wrong_fraction = static_cast<double>(wrong) / points;
    row.wrong_of_pulled = static_cast<double>(wrong) / std::max(pulled, 1);
}

struct LoopPlace {
    Vec2 place;
    Vec2 force;
};

/// Work on the straight way from one place to another, mJ: the trapezoid where the force changes no faster
/// than a spring's of `stiffness`, and halves of the way where it jumps, down to 1e-8 mm. With the jumps left
/// to the trapezoid alone, a law that does no work would seem to do 0.01 mJ a loop.
double work_between(const GuidanceLaw& law, double stiffness, const LoopPlace& from, const LoopPlace& to,
                    int halvings) {
    const Vec2 way = to.place - from.place;
    if (halvings == 0 || length(to.force - from.force) <= 1.1 * stiffness * length(way))
        return 0.5 * glm::dot(from.force + to.force, way);
    const Vec2 middle = from.place + 0.5 * way;
    const LoopPlace half{middle, law.force_at(middle)};
    return work_between(law, stiffness, from, half, halvings - 1) +
           work_between(law, stiffness, half, to, halvings - 1);
}

void walk_loops(const GuidanceLaw& law, double stiffness, const LoopWorkEffort& effort, LoopWork& row) {
    constexpr int halvings = 20;
    std::mt19937_64 random(2);
    const double step = 2.0 * std::numbers::pi / effort.steps_per_loop;
    std::vector<double> works;
    for (int loop = 0; loop < effort.loops; ++loop) {
        const Vec2 centre = random_place(random, half_side_mm - loop_radius_mm);
        const auto felt_at = [&](int i) {
            const double angle = (i % effort.steps_per_loop) * step; // the loop ends where it began
            const Vec2 place = centre + loop_radius_mm * Vec2(std::cos(angle), std::sin(angle));
            return LoopPlace{place, law.force_at(place)};
        };
        double work = 0.0;
        LoopPlace last = felt_at(0);
        for (int i = 1; i <= effort.steps_per_loop; ++i) {
            const LoopPlace next = felt_at(i);
            work += work_between(law, stiffness, last, next, halvings);
            row.max_force_step_n = std::max(row.max_force_step_n, length(next.force - last.force));
            last = next;
        }
        works.push_back(std::abs(work));
    }
    std::sort(works.begin(), works.end());
    row.max_loop_work_mj = works.back();
    row.p99_loop_work_mj = works[static_cast<std::size_t>(0.99 * static_cast<double>(works.size() - 1))];
}

} // namespace

std::vector<LoopWork> measure_loop_work(const std::vector<double>& spacings_mm,
                                        const LoopWorkEffort& effort) {
    const FlatScene curves = flatten(reference_face(), {1e-4, 0.1});
    const TentProfile profile;
    std::vector<LoopWork> rows;
    for (const double spacing : spacings_mm) {
        const FlatScene scene = with_vertex_spacing(curves, spacing);
        const ExactLaw exact(scene, profile);
        const PublishedLaw published(scene, profile);
        const std::pair<const char*, const GuidanceLaw*> laws[] = {{"exact", &exact},
                                                                   {"published", &published}};
        for (const auto& [name, law] : laws) {
            LoopWork row;
            row.law = name;
            row.vertex_spacing_mm = spacing;
            compare_forces(*law, exact, profile.peak(), effort.points, row);
            walk_loops(*law, profile.stiffness, effort, row);
            rows.push_back(row);
        }
    }
    return rows;
}

} // namespace tp
