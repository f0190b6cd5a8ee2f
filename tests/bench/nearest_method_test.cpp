// SPDX-License-Identifier: Apache-2.0
// The methods that are timed against each other must answer the same question. No time is asserted.
#include "app/figures/bench/bench_scene.hpp"
#include "app/figures/bench/nearest_bench.hpp"
#include "app/figures/bench/nearest_method.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace tp;

class NearestMethodTest : public QObject {
    Q_OBJECT
private slots:
    void exact_methods_agree() {
        for (const std::size_t size : {64u, 1000u, 10'000u}) {
            const BenchScene scene = bench_scene(size);
            const auto plain = NearestMethod::make("plain_loop", scene.flat);
            for (const char* name : {"ours", "ours_any_distance", "boost_rtree", "boost_rtree_any"}) {
                const auto method = NearestMethod::make(name, scene.flat);
                for (const auto& places : {hand_path(500), random_places(500)})
                    for (const Vec2 place : places) {
                        const double truth = plain->nearest(place).distance;
                        const Nearest nearest = method->nearest(place);
                        if (truth > method->reach()) {
                            QVERIFY(std::isinf(nearest.distance));
                            continue;
                        }
                        QVERIFY(std::abs(nearest.distance - truth) < 1e-9);
                        QVERIFY(std::abs(length(nearest.point - place) - truth) < 1e-9);
                    }
            }
        }
    }

    void the_published_algorithm_answers_as_listed_from_a_tree_too() {
        for (const std::size_t size : {64u, 1000u}) {
            const BenchScene scene = bench_scene(size);
            const auto scan = NearestMethod::make("published_scan", scene.flat);
            const auto tree = NearestMethod::make("published_kdtree", scene.flat);
            std::vector<Vec2> vertices;
            for (const Polyline& line : scene.flat.lines)
                vertices.insert(vertices.end(), line.points.begin(), line.points.end());
            int from_scan = 0, from_tree = 0, to_v1 = 0;
            for (const Vec2 place : random_places(2000)) {
                std::partial_sort(vertices.begin(), vertices.begin() + 2, vertices.end(),
                                  [&](Vec2 a, Vec2 b) { return length(a - place) < length(b - place); });
                const Vec2 v1 = vertices[0];
                const Vec2 v2 = vertices[1];
                const double along = glm::dot(place - v1, v2 - v1);
                const double across = v1.x * v2.y - v1.y * v2.x - place.x * (v2.y - v1.y) +
                                      place.y * (v2.x - v1.x); // twice the triangle's area
                const double distance = along > 0.0 ? std::abs(across) / length(v2 - v1) : length(v1 - place);
                const auto as_listed = [&](const Nearest& answer) {
                    return std::abs(answer.distance - distance) < 1e-9 &&
                           std::abs(length(answer.point - place) - distance) < 1e-9;
                };
                from_scan += as_listed(scan->nearest(place)) ? 1 : 0;
                from_tree += as_listed(tree->nearest(place)) ? 1 : 0;
                to_v1 += along > 0.0 ? 0 : 1;
            }
            QVERIFY(from_scan > 1990 && from_tree > 1990); // equally near vertices leave a choice
            QVERIFY(to_v1 > 20);
        }
    }

    void scenes_have_as_many_segments_as_they_say() {
        for (const std::size_t size : {64u, 256u, 1000u, 10'000u, 100'000u}) {
            const BenchScene scene = bench_scene(size);
            std::size_t count = 0;
            for (const Polyline& line : scene.flat.lines) {
                QVERIFY(line.closed);
                count += line.segment_count();
            }
            QCOMPARE(count, size);
        }
    }

    void a_hand_moves_a_tenth_of_a_millimetre() {
        const auto path = hand_path(5000);
        for (std::size_t i = 1; i < path.size(); ++i)
            QVERIFY(std::abs(length(path[i] - path[i - 1]) - 0.1) < 1e-9);
    }

    void a_run_has_a_row_for_every_method() {
        BenchPlan plan = BenchPlan::quick();
        plan.sizes = {64};
        plan.rounds = 2;
        plan.batch_ms = 0.05;
        std::set<std::string> methods;
        for (const BenchRow& row : run_nearest_bench(plan, [](const std::string&) {})) {
            methods.insert(row.method);
            const bool is_bounded = row.method == "ours" || row.method == "boost_rtree";
            QCOMPARE(row.query, std::string(is_bounded ? "band" : "any"));
            QVERIFY(row.ns_median > 0.0 && row.bytes > 0 && row.build_ms >= 0.0);
            QVERIFY(!row.method.starts_with("ours") || row.max_error_mm < 1e-9);
        }
        QCOMPARE(methods.size(), NearestMethod::names.size());
    }
};

QTEST_APPLESS_MAIN(NearestMethodTest)
#include "nearest_method_test.moc"
