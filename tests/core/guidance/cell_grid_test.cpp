// SPDX-License-Identifier: Apache-2.0
// The grid alone: its lists lack nothing, hold little more than they must, and stay within their memory.
#include "core/guidance/cell_grid.hpp"
#include "crowded_scenes.hpp"
#include "index_parts.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <set>

namespace cell_grid_test {

using namespace tp;
using namespace tp::testing;

namespace {

constexpr std::size_t usual_bytes = std::size_t(512) << 10;

struct Gridded {
    SegmentSet set;
    SegmentTree tree;
    CellGrid grid;

    explicit Gridded(const FlatScene& scene, double band = 8.0, std::size_t most_bytes = usual_bytes)
        : set(set_of(scene)), tree(set), grid(set, tree, band, most_bytes) {}
};

/// Twenty lines beside one another, and twenty that meet in a point.
FlatScene combs_and_stars() {
    FlatScene scene;
    for (int i = 0; i < 20; ++i) {
        const double angle = 0.3 * i;
        scene.names.insert(scene.names.end(), {"tooth", "ray"});
        scene.lines.push_back({{{-40.0, 0.4 * i}, {-5.0, 0.4 * i}}, false});
        scene.lines.push_back({{{20, 0}, {20.0 + 15.0 * std::cos(angle), 15.0 * std::sin(angle)}}, false});
    }
    return scene;
}

std::vector<FlatScene> scenes() {
    std::mt19937 random(41);
    std::vector<FlatScene> all{face_scene(60), combs_and_stars(), many_curves(3000, 40.0)};
    for (int i = 0; i < 20; ++i)
        all.push_back(random_scene(random));
    return all;
}

/// All over the scene, on its lines, beside them and outside its bounds.
std::vector<Vec2> fingers(const SegmentSet& set, std::mt19937& random, int count) {
    std::uniform_int_distribution<std::size_t> any(0, set.size() - 1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Vec2> all;
    for (int k = 0; k < count; ++k) {
        const Vec2 on = point_on(set.segments[any(random)], unit(random));
        for (const double beside : {0.0, 0.05, 2.0, 9.0})
            all.push_back(on + random_point(random, beside));
        all.push_back(random_point(random, 90.0));
    }
    return all;
}

} // namespace

class CellGridTest : public QObject {
    Q_OBJECT
private slots:
    void no_list_lacks_what_is_nearest_and_no_band_is_missed() {
        std::mt19937 random(42);
        for (const FlatScene& scene : scenes())
            for (const double band : {0.5, 8.0}) {
                const Gridded all(scene, band);
                for (const Vec2 p : fingers(all.set, random, 60)) {
                    const double truth = std::sqrt(closest_of_all(all.set, p).squared);
                    const CellGrid::Cell cell = all.grid.at(p);
                    QVERIFY(!cell.beyond_band || truth > band);
                    QCOMPARE(cell.candidates.size() % 2, std::size_t(0));
                    if (!cell.candidates.empty())
                        QVERIFY(std::abs(std::sqrt(closest_of(all.set, cell.candidates, p).squared) - truth) <
                                1e-12);
                }
            }
    }

    /// A tick asks for one place or, blended, for 24: each is to cost a handful of segments, on every side of
    /// a line.
    void in_the_band_of_a_face_a_handful_of_segments_is_in_question() {
        const Gridded face(face_scene(200));
        std::mt19937 random(43);
        std::size_t asked = 0, without = 0, listed = 0, needed = 0;
        const double half = 0.5 * face.grid.cell_size_mm();
        for (const Vec2 p : fingers(face.set, random, 300)) {
            if (!(std::sqrt(closest_of_all(face.set, p).squared) < 8.0))
                continue;
            const CellGrid::Cell cell = face.grid.at(p);
            QVERIFY(cell.candidates.size() <= 30);
            without += cell.candidates.empty() ? 1 : 0;
            std::set<std::uint32_t> nearest;
            for (const double x : {-half, 0.0, half})
                for (const double y : {-half, 0.0, half})
                    nearest.insert(closest_of_all(face.set, p + Vec2(x, y)).segment);
            ++asked;
            listed += cell.candidates.size();
            needed += nearest.size();
        }
        qInfo("%.2f segments in a list, %.2f of which can be nearest; %zu of %zu cells without one",
              double(listed) / double(asked), double(needed) / double(asked), without, asked);
        QVERIFY(asked > 800);
        QVERIFY(without * 100 < asked);
        QVERIFY(double(listed) < 1.42 * double(needed));
    }

    void far_from_all_lines_a_cell_says_that_nothing_pulls() {
        const Gridded face(face_scene(60));
        std::mt19937 random(44);
        int said = 0, beyond = 0;
        for (int k = 0; k < 4000; ++k) {
            const Vec2 p = random_point(random, 90.0);
            const double distance = std::sqrt(closest_of_all(face.set, p).squared);
            const bool clearly = distance > 8.0 + 8.0 * face.grid.cell_size_mm();
            beyond += clearly ? 1 : 0;
            said += clearly && face.grid.at(p).beyond_band ? 1 : 0;
        }
        qInfo("%d of %d places say so", said, beyond);
        QVERIFY(beyond > 1000);
        QVERIFY(100 * said > 98 * beyond); // a large block of one candidate needs not be divided to say so
    }

    void lists_stay_within_their_memory_and_answer_less_where_it_is_scarce() {
        const FlatScene scene = many_curves(3000, 40.0);
        std::size_t last = 0;
        for (const std::size_t bytes : {std::size_t(2000), std::size_t(20'000), std::size_t(100'000),
                                        std::size_t(400'000), std::size_t(2'000'000)}) {
            const Gridded all(scene, 8.0, bytes);
            QVERIFY2(all.grid.bytes() <= bytes, qPrintable(QString::number(all.grid.bytes())));
            QVERIFY(all.grid.bytes() > last);
            last = all.grid.bytes();
        }
    }

    void cells_fill_their_share_of_the_surroundings() {
        for (const FlatScene& scene : scenes()) {
            const Gridded all(scene);
            const double cell = all.grid.cell_size_mm();
            const auto count = static_cast<double>(all.grid.cell_count());
            QVERIFY(cell > 0.0 && count >= 4000.0);
            const auto within = [&](Vec2 p) { // not outside the grid: cells of nothing hold lists too
                return !all.grid.at(p).candidates.empty() || !all.grid.at(p).beyond_band;
            };
            Vec2 min = all.set.segments.front().a, max = min;
            for (std::size_t i = 0; i < all.set.size(); ++i) {
                min = glm::min(min, glm::min(all.set.segments[i].a, all.set.segments[i].b));
                max = glm::max(max, glm::max(all.set.segments[i].a, all.set.segments[i].b));
            }
            const Vec2 pad = Vec2(8.0) + 0.3 * (max - min);
            const Vec2 extent = max - min + 2.0 * pad;
            QVERIFY(count * cell * cell >= extent.x * extent.y);
            QVERIFY(count * cell * cell < 1.2 * extent.x * extent.y);
            int inside = 0;
            for (const double x : {0.001, 0.25, 0.5, 0.75, 0.999})
                for (const double y : {0.001, 0.25, 0.5, 0.75, 0.999})
                    inside += within(min - pad + Vec2(x, y) * extent) ? 1 : 0;
            QVERIFY(inside >= 24); // a crowd in one cell may have no list
            for (const Vec2 p : {min - pad - Vec2(2 * cell, 0), min - pad - Vec2(0, 2 * cell),
                                 max + pad + Vec2(2 * cell, 0), max + pad + Vec2(0, 2 * cell)})
                QVERIFY(all.grid.at(p).candidates.empty() && all.grid.at(p).beyond_band);
        }
    }

    /// Cells as wide as a stray line is away would hold everything in a few.
    void a_stray_line_leaves_the_cells_as_they_are() {
        const FlatScene plain = many_curves(3000, 40.0);
        const Gridded without(plain);
        std::mt19937 random(45);
        for (const auto& [from, to] : {std::pair{Vec2(4000, 0), Vec2(4001, 1)},
                                       {Vec2(-9e5, 7e5), Vec2(-9e5, 7e5)},
                                       {Vec2(-1e5, -3e4), Vec2(1e5, 3e4)},
                                       {Vec2(0, 0), Vec2(2e5, 1e4)}}) {
            FlatScene scene = plain;
            scene.names.push_back("stray");
            scene.lines.push_back({{from, to}, false});
            const Gridded with(scene);
            QVERIFY(with.grid.cell_size_mm() < 1.01 * without.grid.cell_size_mm());
            int lists = 0, lists_without = 0;
            for (const Vec2 p : fingers(without.set, random, 300)) {
                lists += with.grid.at(p).candidates.empty() ? 0 : 1;
                lists_without += without.grid.at(p).candidates.empty() ? 0 : 1;
                const double truth = std::sqrt(closest_of_all(with.set, p).squared);
                const CellGrid::Cell cell = with.grid.at(p);
                QVERIFY(!cell.beyond_band || truth > 8.0);
                if (!cell.candidates.empty())
                    QVERIFY(std::abs(std::sqrt(closest_of(with.set, cell.candidates, p).squared) - truth) <
                            1e-9);
            }
            QVERIFY(lists >= 0.98 * lists_without);
            // Beyond the cells, the stray line may be near.
            QVERIFY(!with.grid.at(from + Vec2(1e3)).beyond_band);
        }
    }

    /// A list of everything in each cell would take long to make and hold, and be of no use.
    void where_crowds_meet_everywhere_there_are_no_cells() {
        for (const char* name : {"centre_of_a_circle", "crossing_of_diameters"})
            for (const CrowdedScene& crowded : crowded_scenes())
                if (crowded.name == std::string(name))
                    QVERIFY(Gridded(crowded.make(60'000)).grid.bytes() < usual_bytes);
    }

    void there_are_no_cells_where_they_would_not_be_right() {
        const auto line_of = [](Vec2 from, Vec2 to) { return FlatScene{{"line"}, {{{from, to}, false}}}; };
        QVERIFY(Gridded(line_of({0, 0}, {10, 10})).grid.cell_count() > 0);
        QVERIFY(Gridded(line_of({0, 0}, {3e4, 3e4})).grid.cell_count() > 0);
        for (const Gridded& none :
             {Gridded(FlatScene{}), Gridded(line_of({0, 0}, {6e4, 10})), Gridded(line_of({0, 0}, {10, 6e4})),
              Gridded(line_of({1e9, 0}, {1e9 + 1, 1})), Gridded(line_of({0, -1e9}, {1, 1 - 1e9})),
              Gridded(line_of({0, 0}, {10, 10}), 1e6), Gridded(line_of({0, 0}, {10, 10}), std::nan(""))}) {
            QCOMPARE(none.grid.cell_count(), std::size_t(0));
            QVERIFY(none.grid.at({0, 0}).candidates.empty() && !none.grid.at({0, 0}).beyond_band);
        }
        const Gridded some(line_of({0, 0}, {10, 10}));
        const double nan = std::nan("");
        for (const Vec2 p : {Vec2(nan, 0), Vec2(0, nan), Vec2(1e300, 0), Vec2(0, -1e300)})
            QVERIFY(some.grid.at(p).candidates.empty() && some.grid.at(p).beyond_band);
    }
};

} // namespace cell_grid_test

TP_TEST(cell_grid_test, CellGridTest, nothing)
#include "cell_grid_test.moc"
