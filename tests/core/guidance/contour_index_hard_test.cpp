// SPDX-License-Identifier: Apache-2.0
// What the index must keep on scenes made to break it.
#include "brute_force.hpp"
#include "core/guidance/contour_index.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <functional>

namespace contour_index_hard_test {

using namespace tp;
using namespace tp::testing;

namespace {

struct HardScene {
    const char* name;
    std::function<FlatScene(std::mt19937&)> make;
    double reach;     ///< mm; questions are asked this far round the scene's points
    int rounds;       ///< scenes
    double tolerance; ///< mm; a few ulp of the coordinates where they are so large that 1e-9 is none
};

FlatScene one_line(std::vector<Vec2> points, bool closed = false) {
    FlatScene scene;
    scene.names = {"line"};
    scene.lines = {{std::move(points), closed}};
    return scene;
}

FlatScene moved(FlatScene scene, double scale, Vec2 by) {
    for (Polyline& line : scene.lines)
        for (Vec2& p : line.points)
            p = scale * p + by;
    return scene;
}

FlatScene walk(std::mt19937& random, int points, double step_x, double step_y) {
    std::normal_distribution<double> step;
    std::vector<Vec2> line{Vec2(0.0)};
    for (int i = 1; i < points; ++i)
        line.push_back(line.back() + Vec2(step_x * step(random), step_y * step(random)));
    return one_line(std::move(line));
}

FlatScene clusters(std::mt19937& random) {
    FlatScene scene;
    for (int k = 0; k < 6; ++k) {
        const Vec2 centre = random_point(random, 80.0);
        scene.names.push_back("cluster " + std::to_string(k));
        scene.lines.push_back(moved(walk(random, 60, 0.01, 0.01), 1.0, centre).lines.front());
    }
    return scene;
}

FlatScene specks(std::mt19937& random) {
    FlatScene scene;
    for (int k = 0; k < 40; ++k) {
        const Vec2 p = random_point(random, 20.0);
        scene.names.push_back("speck " + std::to_string(k));
        scene.lines.push_back({{p, p + (k % 3 == 0 ? Vec2(0.0) : Vec2(1e-12, -1e-12))}, false});
    }
    return scene;
}

const std::vector<HardScene> hard_scenes{
    {"small", [](auto& r) { return random_scene(r); }, 30.0, 40, 1e-9},
    {"face", [](auto&) { return face_scene(); }, 40.0, 1, 1e-9},
    {"clustered", clusters, 30.0, 3, 1e-9},
    {"random_walk", [](auto& r) { return walk(r, 3000, 1.0, 1.0); }, 15.0, 1, 1e-9},
    {"long_and_thin", [](auto& r) { return walk(r, 400, 30.0, 0.001); }, 12.0, 3, 1e-9},
    {"long_chords", [](auto& r) { return walk(r, 300, 2000.0, 2000.0); }, 500.0, 3, 1e-9},
    {"segments_of_length_0_and_1e_minus_12", specks, 20.0, 5, 1e-9},
    {"a_micrometre_wide",
     [](auto& r) {
         return moved(random_scene(r), 1e-5, {3, 4});
     },
     1e-3, 10, 1e-9},
    {"coordinates_of_1e9",
     [](auto& r) {
         return moved(random_scene(r), 1.0, {1e9, -1e9});
     },
     60.0, 20, 1e-9},
    {"a_kilometre_wide",
     [](auto& r) {
         return moved(random_scene(r), 2e4, {0, 0});
     },
     1e6, 20, 1e-9},
    {"segments_of_1e9",
     [](auto& r) {
         return moved(random_scene(r), 2e7, {0, 0});
     },
     1e9, 20, 1e-9},
    {"coordinates_of_1e200",
     [](auto& r) {
         return moved(random_scene(r), 1e198, {0, 0});
     },
     1e200, 20, 1e186},
    {"coordinates_of_1e_minus_200",
     [](auto& r) {
         return moved(random_scene(r), 1e-202, {0, 0});
     },
     1e-199, 20, 1e-9},
};

/// Points near the scene, far round it, on its vertices and beside them.
std::vector<Vec2> questions(const FlatScene& scene, double reach, std::mt19937& random, int count) {
    std::vector<Vec2> all;
    for (const Polyline& line : scene.lines)
        all.insert(all.end(), line.points.begin(), line.points.end());
    std::uniform_int_distribution<std::size_t> any(0, all.size() - 1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Vec2> result;
    for (int k = 0; k < count; ++k) {
        const double how_far = k % 4 == 0 ? 0.0 : k % 4 == 1 ? 1e-6 : k % 4 == 2 ? 0.1 : 1.0;
        const Vec2 offset(unit(random), unit(random));
        result.push_back(all[any(random)] + how_far * reach * offset);
    }
    return result;
}

void add_hard_scenes() {
    QTest::addColumn<int>("which");
    for (std::size_t i = 0; i < hard_scenes.size(); ++i)
        QTest::newRow(hard_scenes[i].name) << int(i);
}

} // namespace

class ContourIndexHardTest : public QObject {
    Q_OBJECT
private slots:
    void equals_brute_force_data() { add_hard_scenes(); }
    void equals_brute_force() {
        QFETCH(int, which);
        const HardScene& hard = hard_scenes[std::size_t(which)];
        std::mt19937 random(11);
        for (int round = 0; round < hard.rounds; ++round) {
            const FlatScene scene = hard.make(random);
            const ContourIndex index(scene);
            for (const Vec2 p : questions(scene, hard.reach, random, 600)) {
                const long double truth = true_distance(scene, p);
                const Nearest nearest = index.nearest(p);
                QVERIFY(nearest.found());
                QVERIFY2(std::abs(nearest.distance - truth) <= hard.tolerance + 2e-16L * truth,
                         qPrintable(QString("%1 instead of %2 at %3, %4")
                                        .arg(nearest.distance, 0, 'g', 17)
                                        .arg(double(truth), 0, 'g', 17)
                                        .arg(p.x, 0, 'g', 17)
                                        .arg(p.y, 0, 'g', 17)));
            }
        }
    }

    void order_and_direction_change_nothing_data() { add_hard_scenes(); }
    void order_and_direction_change_nothing() {
        QFETCH(int, which);
        const HardScene& hard = hard_scenes[std::size_t(which)];
        std::mt19937 random(12);
        FlatScene scene = hard.make(random);
        scene.names.push_back("a twin");
        scene.lines.push_back(scene.lines.front());
        const FlatScene other = shuffled(scene, random);
        const ContourIndex index(scene);
        const ContourIndex other_index(other);
        for (const Vec2 p : questions(scene, hard.reach, random, 2000)) {
            const Nearest a = index.nearest(p);
            const Nearest b = other_index.nearest(p);
            QVERIFY(a.distance == b.distance && a.point == b.point);
            QCOMPARE(scene.names[std::size_t(a.contour)], other.names[std::size_t(b.contour)]);
        }
    }

    void the_band_changes_no_answer_data() { add_hard_scenes(); }
    void the_band_changes_no_answer() {
        QFETCH(int, which);
        const HardScene& hard = hard_scenes[std::size_t(which)];
        std::mt19937 random(13);
        const FlatScene scene = hard.make(random);
        const ContourIndex usual(scene);
        for (const double band : {0.5, 4.0, 20.0, 1e3}) {
            const ContourIndex index(scene, band);
            for (const Vec2 p : questions(scene, hard.reach, random, 500)) {
                const Nearest all = usual.nearest(p);
                QVERIFY(std::abs(index.nearest(p).distance - all.distance) <= hard.tolerance);
                for (const double reach : {0.5 * band, band, 3.0 * band}) {
                    const Nearest within = index.nearest_within(p, reach);
                    if (within.found()) {
                        QVERIFY(within.distance <= reach);
                        QVERIFY(std::abs(within.distance - all.distance) <= hard.tolerance);
                    } else {
                        QVERIFY(all.distance > reach - hard.tolerance);
                    }
                }
            }
        }
    }

    void exact_ties_follow_the_rule() {
        // Axis-parallel lines between small whole numbers, their lengths powers of two: everything is
        // computed without rounding, so ties are true ones.
        std::mt19937 random(14);
        std::uniform_int_distribution<int> place(-6, 6);
        int ties = 0;
        for (int round = 0; round < 200; ++round) {
            FlatScene scene;
            for (int k = 0; k < 12; ++k) {
                const Vec2 a(place(random), place(random));
                const double reach = place(random) < 0 ? 0.0 : std::exp2(std::abs(place(random)) / 2);
                const Vec2 b = a + (k % 2 == 0 ? Vec2(0.0, reach) : Vec2(-reach, 0.0));
                scene.names.push_back(std::string("line ") + char('l' - k));
                scene.lines.push_back({{a, b}, false});
            }
            const ContourIndex index(scene);
            for (int k = 0; k < 60; ++k) {
                const Vec2 p(0.5 * place(random), 0.5 * place(random));
                const auto key = [&](std::size_t c) {
                    const Polyline& line = scene.lines[c];
                    const Vec2 low = glm::min(line.points[0], line.points[1]);
                    const Vec2 q = glm::clamp(p, low, glm::max(line.points[0], line.points[1]));
                    return std::tuple(glm::dot(p - q, p - q), q.x, q.y, scene.names[c]);
                };
                std::size_t best = 0;
                int equal = 0;
                for (std::size_t c = 1; c < scene.lines.size(); ++c)
                    best = key(c) < key(best) ? c : best;
                for (std::size_t c = 0; c < scene.lines.size(); ++c)
                    equal += std::get<0>(key(c)) == std::get<0>(key(best)) ? 1 : 0;
                ties += equal > 1 ? 1 : 0;
                const Nearest nearest = index.nearest(p);
                QCOMPARE(nearest.contour, int(best));
                QVERIFY(nearest.point == Vec2(std::get<1>(key(best)), std::get<2>(key(best))));
            }
        }
        QVERIFY(ties > 1000);
    }

    void range_edge_give_or_take_an_ulp() {
        const ContourIndex index(one_line({{-50, 0}, {50, 0}}));
        const double band = ContourIndex::usual_band_mm;
        const double below = std::nextafter(band, 0.0);
        const double above = std::nextafter(band, 1e9);
        QVERIFY(index.nearest_within({1, band}, band).found());
        QVERIFY(index.nearest_within({1, below}, band).found());
        QVERIFY(!index.nearest_within({1, above}, band).found());
        QVERIFY(!index.nearest_within({1, band}, below).found());
        QVERIFY(index.nearest_within({1, above}, above).found());
        QCOMPARE(index.nearest({1, above}).distance, above);
        QVERIFY(!index.nearest_within({1, 0}, -1.0).found());
        QVERIFY(!index.nearest_within({1, 0}, std::nan("")).found());
        QVERIFY(index.nearest_within({1, 0}, 0.0).found());
    }

    /// Where the tree answers: far from the cells, and in extended precision where lines are long.
    void far_from_the_cells_the_edge_of_the_reach_is_found_too() {
        for (const double half : {50.0, 2e5})
            for (const double away : {200.0, 3e5}) {
                const ContourIndex index(one_line({{-half, 0}, {half, 0}}));
                for (const double y : {away, -away}) {
                    QVERIFY(index.nearest_within({1, y}, away).found());
                    QVERIFY(!index.nearest_within({1, y}, std::nextafter(away, 0.0)).found());
                    QCOMPARE(index.nearest_within({1, y}, 2.0 * away).distance, away);
                    QCOMPARE(index.nearest({1, y}).distance, away);
                    QVERIFY(!index.nearest_within({1, y}, 0.5 * away).found());
                }
            }
    }

    void hostile_questions_end_well() {
        const double values[] = {0.0,     -0.0,         1e-300,
                                 1e154,   1e155,        -1e308,
                                 1.7e308, std::nan(""), std::numeric_limits<double>::infinity()};
        for (const double scale : {1.0, 1e154, 1e300}) {
            const ContourIndex index(moved(face_scene(20), scale, {0, 0}));
            for (const double x : values)
                for (const double y : values) {
                    QCOMPARE(index.nearest({x, y}).found(), is_finite(Vec2(x, y)));
                    const Nearest near = index.nearest_within({x, y}, 8.0);
                    QVERIFY(!near.found() || near.distance <= 8.0);
                }
        }
        QVERIFY(!ContourIndex(FlatScene{}).nearest_within({0, 0}, 8.0).found());
    }

    void repeated_segments_are_kept_once() {
        FlatScene scene = face_scene(50);
        const std::size_t count = ContourIndex(scene).segment_count();
        for (int k = 0; k < 5; ++k) {
            scene.names.push_back("copy");
            scene.lines.push_back(scene.lines[0]);
        }
        const ContourIndex index(scene);
        QCOMPARE(index.segment_count(), count);
        QCOMPARE(scene.names[std::size_t(index.nearest({-32, 36}).contour)], std::string("copy"));
    }
};

} // namespace contour_index_hard_test

TP_TEST(contour_index_hard_test, ContourIndexHardTest, nothing)
#include "contour_index_hard_test.moc"
