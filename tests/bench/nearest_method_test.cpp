// SPDX-License-Identifier: Apache-2.0
// The methods that are timed against each other must answer the same question. No time is asserted.
#include "app/figures/bench/bench_scene.hpp"
#include "app/figures/bench/nearest_bench.hpp"
#include "app/figures/bench/nearest_method.hpp"

#include <QTest>

#include <set>

using namespace tp;

class NearestMethodTest : public QObject {
    Q_OBJECT
private slots:
    void exact_methods_agree() {
        for (const std::size_t size : {64u, 1000u, 10'000u}) {
            const BenchScene scene = bench_scene(size);
            const auto plain = NearestMethod::make("plain_loop", scene.flat);
            for (const char* name : {"ours", "ours_any_distance", "boost_rtree"}) {
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

    void the_published_algorithm_answers_the_same_from_a_tree() {
        const BenchScene scene = bench_scene(1000);
        const auto scan = NearestMethod::make("published_scan", scene.flat);
        const auto tree = NearestMethod::make("published_kdtree", scene.flat);
        int equal = 0;
        for (const Vec2 place : random_places(2000))
            equal += std::abs(scan->nearest(place).distance - tree->nearest(place).distance) < 1e-9 ? 1 : 0;
        QVERIFY(equal > 1990); // of equally near vertices the two may take different ones
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
            QVERIFY(row.ns_median > 0.0 && row.bytes > 0 && row.build_ms >= 0.0);
            QVERIFY(!row.method.starts_with("ours") || row.max_error_mm < 1e-9);
        }
        QCOMPARE(methods.size(), NearestMethod::names.size());
    }
};

QTEST_APPLESS_MAIN(NearestMethodTest)
#include "nearest_method_test.moc"
