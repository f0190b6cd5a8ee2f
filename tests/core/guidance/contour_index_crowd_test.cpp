// SPDX-License-Identifier: Apache-2.0
// What the index must keep where very many segments are about equally near.
#include "brute_force.hpp"
#include "core/guidance/contour_index.hpp"
#include "crowded_scenes.hpp"
#include "index_parts.hpp"

#include <QTest>

using namespace tp;
using namespace tp::testing;

namespace {

/// At the hub, closer to it than doubles tell the segments apart, and farther away.
std::vector<Vec2> places_round(Vec2 hub, int each) {
    std::mt19937 random(51);
    std::vector<Vec2> places{hub};
    for (const double reach : {1e-14, 1e-12, 1e-10, 1e-9, 1e-8, 1e-6, 1e-4, 1e-2, 1.0, 30.0, 120.0})
        for (int k = 0; k < each; ++k)
            places.push_back(hub + random_point(random, reach));
    return places;
}

void add_crowded_scenes() {
    QTest::addColumn<int>("which");
    for (std::size_t i = 0; i < crowded_scenes().size(); ++i)
        QTest::newRow(crowded_scenes()[i].name) << int(i);
}

} // namespace

class ContourIndexCrowdTest : public QObject {
    Q_OBJECT
private slots:
    void equals_brute_force_data() { add_crowded_scenes(); }
    void equals_brute_force() {
        QFETCH(int, which);
        const CrowdedScene& crowded = crowded_scenes()[std::size_t(which)];
        const FlatScene scene = crowded.make(6000);
        const ContourIndex index(scene);
        for (const Vec2 p : places_round(crowded.hub, 6)) {
            const long double truth = true_distance(scene, p);
            const Nearest nearest = index.nearest(p);
            QVERIFY2(std::abs(nearest.distance - truth) <= 1e-9L,
                     qPrintable(QString("off by %1 at %2, %3")
                                    .arg(double(nearest.distance - truth))
                                    .arg(p.x, 0, 'g', 17)
                                    .arg(p.y, 0, 'g', 17)));
            QVERIFY(std::abs(length(nearest.towards) - nearest.distance) <= 1e-15 * nearest.distance);
            QVERIFY(length(p + nearest.towards - nearest.point) < 1e-12);
            const Polyline& line = scene.lines[std::size_t(nearest.contour)];
            QVERIFY(length(nearest_on_segment(line.segment_start(nearest.segment),
                                              line.segment_end(nearest.segment), nearest.point) -
                           nearest.point) < 1e-12);
        }
    }

    /// Which of those that are equally near it is, no order decides.
    void order_and_direction_change_nothing_data() { add_crowded_scenes(); }
    void order_and_direction_change_nothing() {
        QFETCH(int, which);
        const CrowdedScene& crowded = crowded_scenes()[std::size_t(which)];
        std::mt19937 random(52);
        const FlatScene scene = crowded.make(6000);
        const ContourIndex index(scene);
        const ContourIndex other(shuffled(scene, random));
        for (const Vec2 p : places_round(crowded.hub, 40)) {
            const Nearest a = index.nearest(p);
            const Nearest b = other.nearest(p);
            QVERIFY(a.distance == b.distance && a.point == b.point && a.towards == b.towards);
        }
    }

    /// So that the servo keeps its time: no place needs more than a small part of a crowd.
    void few_of_a_crowd_are_asked_data() { add_crowded_scenes(); }
    void few_of_a_crowd_are_asked() {
        QFETCH(int, which);
        const CrowdedScene& crowded = crowded_scenes()[std::size_t(which)];
        const SegmentSet set = set_of(crowded.make(60'000));
        SegmentTree tree(set);
        tree.expect_crowds(set);
        std::uint32_t most = 0;
        for (const Vec2 p : places_round(crowded.hub, 40)) {
            Closest<double> closest;
            most = std::max(most, tree.search(set, p, closest));
        }
        qInfo("%u of %zu segments at most", most, set.size());
        QVERIFY(most < 8'000);
    }
};

QTEST_APPLESS_MAIN(ContourIndexCrowdTest)
#include "contour_index_crowd_test.moc"
