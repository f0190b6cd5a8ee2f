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
    for (int i = 0; i < points; ++i) {
        const Vec2 place = random_place(random, half_side_mm);
        const double error = length(law.force_at(place) - truth.force_at(place));
        row.max_force_error_n = std::max(row.max_force_error_n, error);
        wrong += error > 0.1 * peak ? 1 : 0;
    }
    row.wrong_fraction = static_cast<double>(wrong) / points;
}

void walk_loops(const GuidanceLaw& law, const LoopWorkEffort& effort, LoopWork& row) {
    std::mt19937_64 random(2);
    const double step = 2.0 * std::numbers::pi / effort.steps_per_loop;
    for (int loop = 0; loop < effort.loops; ++loop) {
        const Vec2 centre = random_place(random, half_side_mm - loop_radius_mm);
        double work = 0.0;
        Vec2 last(0.0);
        for (int i = 0; i < effort.steps_per_loop; ++i) {
            const Vec2 out(std::cos(i * step), std::sin(i * step));
            const Vec2 force = law.force_at(centre + loop_radius_mm * out);
            work += glm::dot(force, Vec2(-out.y, out.x)) * loop_radius_mm * step;
            if (i > 0)
                row.max_force_step_n = std::max(row.max_force_step_n, length(force - last));
            last = force;
        }
        row.max_loop_work_mj = std::max(row.max_loop_work_mj, std::abs(work));
    }
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
            walk_loops(*law, effort, row);
            rows.push_back(row);
        }
    }
    return rows;
}

} // namespace tp
