// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/exact_law.hpp"
#include "core/guidance/published_law.hpp"
#include "scenes.hpp"

#include <QTest>

#include <algorithm>

using namespace tp;
using namespace tp::testing;

namespace {

/// The listing, line by line, with nothing shared with the code under test.
///   1  sort the vertices of all contours by their distance from the HIP
///   2  v1 ← the nearest, v2 ← the second nearest
///   3  project the HIP on the line through v1 and v2
///   4  r ← the distance from the HIP to its projection
///   5  n ← (projection − HIP) / r
///   6  r ≤ d: F ← K r n;   d < r < 2d: F ← K (2d − r) n;   otherwise F ← 0
Vec2 listing(std::vector<Vec2> vertices, double K, double d, Vec2 hip) {
    std::stable_sort(vertices.begin(), vertices.end(), [&](Vec2 a, Vec2 b) {
        return std::hypot(a.x - hip.x, a.y - hip.y) < std::hypot(b.x - hip.x, b.y - hip.y);
    });
    const Vec2 v1 = vertices[0], v2 = vertices[1];
    const double ux = v2.x - v1.x, uy = v2.y - v1.y;
    const double t = ((hip.x - v1.x) * ux + (hip.y - v1.y) * uy) / (ux * ux + uy * uy);
    const double px = v1.x + t * ux, py = v1.y + t * uy;
    const double r = std::hypot(px - hip.x, py - hip.y);
    const double nx = (px - hip.x) / r, ny = (py - hip.y) / r;
    const double magnitude = r <= d ? K * r : r < 2 * d ? K * (2 * d - r) : 0.0;
    return {magnitude * nx, magnitude * ny};
}

const std::vector<Vec2> corner{{0, 0}, {10, 0}, {10, 10}};

} // namespace

class PublishedLawTest : public QObject {
    Q_OBJECT
private slots:
    void hand_computed_points() {
        const TentProfile tent{0.2, 4.0};
        // v1 = (0,0), v2 = (10,0): the line y = 0; r = 2, F = 0.4 N down.
        Vec2 force = published_algorithm_1(corner, tent, {3, 2});
        QVERIFY(length(force - Vec2(0, -0.4)) < 1e-12);
        // r = 6: the outer branch, K (8 − 6) = 0.4 N.
        force = published_algorithm_1(corner, tent, {2, -6});
        QVERIFY(length(force - Vec2(0, 0.4)) < 1e-12);
        // v1 = (10,10), v2 = (10,0): the line x = 10; r = 3, F = 0.6 N to the right.
        force = published_algorithm_1(corner, tent, {7, 9});
        QVERIFY(length(force - Vec2(0.6, 0)) < 1e-12);
        // Beyond the end of the contour the endless line still pulls: the true nearest point is (0,0), 5 mm
        // away.
        force = published_algorithm_1(corner, tent, {-4, 3});
        QVERIFY(length(force - Vec2(0, -0.6)) < 1e-12);
        // r ≥ 2d
        QVERIFY(published_algorithm_1(corner, tent, {3, -8.5}) == Vec2(0.0));
    }

    void equals_the_listing_on_random_points() {
        std::mt19937 random(6);
        for (int round = 0; round < 200; ++round) {
            std::vector<Vec2> vertices;
            for (int i = 0; i < 20; ++i)
                vertices.push_back(random_point(random, 20.0));
            for (int k = 0; k < 50; ++k) {
                const Vec2 hip = random_point(random, 25.0);
                QVERIFY(length(published_algorithm_1(vertices, {0.2, 4.0}, hip) -
                               listing(vertices, 0.2, 4.0, hip)) < 1e-9);
            }
        }
    }

    void what_it_passes_over_changes_no_answer() {
        std::mt19937 random(8);
        const FlatScene scene = with_vertex_spacing(face_scene(2000), 1.0);
        std::vector<Vec2> vertices;
        for (const Polyline& line : scene.lines)
            vertices.insert(vertices.end(), line.points.begin(), line.points.end());
        for (const std::size_t together : {1U, 7U, 16U, 100'000U}) {
            const PublishedLaw law(scene, {}, together);
            for (int k = 0; k < 2000; ++k) {
                const Vec2 hip =
                    k % 2 == 0 ? random_point(random, 100.0) : vertices[random() % vertices.size()];
                const Vec2 listed = published_algorithm_1(vertices, {}, hip);
                QVERIFY(law.at(hip).force == (is_finite(listed) ? listed : Vec2(0.0)));
            }
        }
    }

    void finger_exactly_on_line_divides_by_zero_and_the_law_withholds_it() {
        const Vec2 raw = published_algorithm_1(corner, {}, {3, 0});
        QVERIFY(std::isnan(raw.x) && std::isnan(raw.y));
        FlatScene scene{{"corner"}, {{corner, false}}};
        QVERIFY(PublishedLaw(scene, {}).at({3, 0}).force == Vec2(0.0));
    }

    void coincident_vertices_and_too_few_do_not_crash() {
        const std::vector<Vec2> twins{{1, 1}, {1, 1}};
        QVERIFY(!is_finite(published_algorithm_1(twins, {}, {2, 2})));
        QVERIFY(published_algorithm_1({{1, 1}}, {}, {2, 2}) == Vec2(0.0));
        QVERIFY(PublishedLaw(FlatScene{{"twins"}, {{twins, false}}}, {}).at({2, 2}).force == Vec2(0.0));
        QVERIFY(PublishedLaw(FlatScene{}, {}).at({2, 2}).contour == -1);
        QVERIFY(PublishedLaw(FlatScene{{"c"}, {{corner, false}}}, {}).at({std::nan(""), 2}).force ==
                Vec2(0.0));
    }

    void vertices_of_two_contours_make_a_line_that_is_not_there() {
        // Two horizontal lips 2 mm apart, vertices 5 mm apart: above a vertex v1 and v2 are of different
        // lips, the line between them is vertical and the force is sideways or nothing.
        FlatScene lips;
        lips.names = {"upper", "lower"};
        lips.lines = {{{{-5, 1}, {0, 1}, {5, 1}}, false}, {{{-5, -1}, {0, -1}, {5, -1}}, false}};
        const Guidance published = PublishedLaw(lips, {}).at({0.5, 2.5});
        const Guidance exact = ExactLaw(lips, {}).at({0.5, 2.5});
        QVERIFY(length(exact.force - Vec2(0, -0.3)) < 1e-12);
        QVERIFY(std::abs(published.force.y) < 1e-12);
        QVERIFY(length(published.force - Vec2(-0.1, 0)) < 1e-12);
    }

    void what_it_says_of_the_place_is_the_foot_on_its_line() {
        const FlatScene scene{{"other", "corner"}, {{{{90, 90}, {95, 90}}, false}, {corner, false}}};
        const PublishedLaw law(scene, {0.2, 4.0});
        const Guidance at = law.at({3, 2});
        QCOMPARE(at.contour, 1);
        QVERIFY(std::abs(at.distance - 2.0) < 1e-12 && length(at.nearest - Vec2(3, 0)) < 1e-12);
        QVERIFY(length(at.force - Vec2(0, -0.4)) < 1e-12);
        QVERIFY(std::isnan(at.energy)); // it has no potential
        QVERIFY(law.force_at({3, 2}) == at.force);
        QVERIFY(std::isnan(law.at({3, -20}).energy) && law.at({3, -20}).force == Vec2(0.0));
        const Guidance twin = PublishedLaw(FlatScene{{"twins"}, {{{{1, 1}, {1, 1}}, false}}}, {}).at({4, 5});
        QVERIFY(twin.contour == 0 && twin.distance == 5.0 && twin.nearest == Vec2(1, 1));
        const double nan = std::nan("");
        const FlatScene broken{{"a"}, {{{{nan, 0}, {0, 0}, {0, nan}, {10, 0}}, false}}};
        QVERIFY(length(PublishedLaw(broken, {0.2, 4.0}).at({3, 2}).force - Vec2(0, -0.4)) < 1e-12);
    }

    void cut_into_vertices_a_line_stays_where_it_is() {
        FlatScene scene;
        scene.names = {"ring", "line", "short", "nothing"};
        scene.lines = {ellipse({0, 0}, 30, 20, 400),
                       {{{0, 0}, {10, 0}, {10, 7}}, false},
                       {{{0, 0}, {0.1, 0}}, false},
                       {{}, true}};
        for (const double spacing : {0.5, 3.0, 4.25}) {
            const FlatScene cut = with_vertex_spacing(scene, spacing);
            QVERIFY(cut.names == scene.names && cut.lines.size() == 4);
            for (std::size_t c = 0; c < 3; ++c) {
                const Polyline& line = cut.lines[c];
                QCOMPARE(line.closed, scene.lines[c].closed);
                double longest = 0.0;
                for (std::size_t i = 0; i < line.segment_count(); ++i)
                    longest = std::max(longest, length(line.segment_end(i) - line.segment_start(i)));
                QVERIFY(longest <= spacing + 1e-9);
                QVERIFY(c == 2 || double(line.segment_count()) < length_of(scene.lines[c]) / spacing + 1.0);
                for (const Vec2 p : line.points)
                    QVERIFY(distance_to(scene.lines[c], p) < 1e-9);
            }
            QVERIFY(cut.lines[1].points.front() == Vec2(0, 0) && cut.lines[1].points.back() == Vec2(10, 7));
            QCOMPARE(cut.lines[2].points.size(), std::size_t(2));
            QVERIFY(cut.lines[3].points.empty());
        }
    }

    void its_error_grows_with_the_vertex_spacing() {
        std::mt19937 random(7);
        const FlatScene scene = face_scene(2000);
        const TentProfile tent;
        const ExactLaw exact(scene, tent);
        double last = -1.0;
        for (const double spacing : {0.5, 2.0, 5.0, 10.0}) {
            const PublishedLaw published(with_vertex_spacing(scene, spacing), tent);
            int wrong = 0;
            const int points = 20000;
            for (int k = 0; k < points; ++k) {
                const Vec2 p = random_point(random, 85.0);
                wrong += length(published.at(p).force - exact.at(p).force) > 0.1 * tent.peak() ? 1 : 0;
            }
            const double share = 100.0 * wrong / points;
            qInfo("spacing %4.1f mm: %.2f %% of the points wrong by more than a tenth of the peak", spacing,
                  share);
            QVERIFY(share > last);
            last = share;
        }
    }
};

QTEST_APPLESS_MAIN(PublishedLawTest)
#include "published_law_test.moc"
