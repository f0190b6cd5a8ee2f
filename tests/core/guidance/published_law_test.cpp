// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/exact_law.hpp"
#include "core/guidance/published_law.hpp"
#include "places.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace published_law_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// The listing of the paper, line by line, with nothing shared with the code under test.
///    2  v1 <- the vertex nearest to the HIP        3  v2 <- the second nearest
///    4  v <- the projection of the HIP on the endless line through v1 and v2
///    5  if v lies between v1 and v2:
///    6-12    F <- |v - HIP| up to d; 2d - |v - HIP| up to 2d; else 0        13  n <- (v - HIP) / |v - HIP|
///   14  else:
///   15-21    F <- |v1 - HIP| up to d; 2d - |v1 - HIP| up to 2d; else 0      22  n <- (v1 - HIP) / |v1 - HIP|
///   24  force <- K F n
Vec2 listing(std::vector<Vec2> vertices, double K, double d, Vec2 hip) {
    std::stable_sort(vertices.begin(), vertices.end(), [&](Vec2 a, Vec2 b) {
        return std::hypot(a.x - hip.x, a.y - hip.y) < std::hypot(b.x - hip.x, b.y - hip.y);
    });
    const Vec2 v1 = vertices[0], v2 = vertices[1];
    const double dx = v2.x - v1.x, dy = v2.y - v1.y;
    const bool a_line = dx != 0.0 || dy != 0.0;
    const double from_v1 = (hip.x - v1.x) * dx + (hip.y - v1.y) * dy;
    const double from_v2 = (v2.x - hip.x) * dx + (v2.y - hip.y) * dy;
    double F = 0.0, nx = 0.0, ny = 0.0;
    if (a_line && from_v1 >= 0.0 && from_v2 >= 0.0) {
        const double t = from_v1 / (dx * dx + dy * dy);
        const double vx = v1.x + t * dx, vy = v1.y + t * dy;
        const double to_v = std::hypot(vx - hip.x, vy - hip.y);
        if (to_v <= d)
            F = to_v;
        else if (to_v <= 2 * d)
            F = 2 * d - to_v;
        nx = (vx - hip.x) / to_v, ny = (vy - hip.y) / to_v;
    } else {
        const double to_v1 = std::hypot(v1.x - hip.x, v1.y - hip.y);
        if (to_v1 <= d)
            F = to_v1;
        else if (to_v1 <= 2 * d)
            F = 2 * d - to_v1;
        nx = (v1.x - hip.x) / to_v1, ny = (v1.y - hip.y) / to_v1;
    }
    return {K * F * nx, K * F * ny};
}

/// An answer of the listing that was worked out outside this program.
struct Answer {
    std::string name;
    TentProfile profile;
    std::vector<Vec2> vertices;
    Vec2 finger{0.0};
    Vec2 force{0.0}; ///< N; not a number where the listing divides 0 by 0
};

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream rest(text);
    for (std::string part; std::getline(rest, part, at);)
        parts.push_back(part);
    return parts;
}

/// The rows of algorithm1.csv.
std::vector<Answer> answers() {
    std::ifstream file(test::in_source("tests/core/guidance/algorithm1.csv"));
    std::vector<Answer> rows;
    std::string line;
    if (!std::getline(file, line) || line != "case,k_n_per_mm,d_mm,vertices_mm,x_mm,y_mm,fx_n,fy_n")
        return rows;
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = split(line, ',');
        if (cells.size() != 8)
            return {};
        const auto number = [&](std::size_t i) { return std::stod(cells[i]); };
        Answer row{cells[0], {number(1), number(2)}, {}, {number(4), number(5)}, {number(6), number(7)}};
        for (const std::string& vertex : split(cells[3], ' ')) {
            const std::vector<std::string> place = split(vertex, ':');
            row.vertices.emplace_back(std::stod(place.at(0)), std::stod(place.at(1)));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Both not a number, or equal but for rounding.
bool same_force(Vec2 force, Vec2 answer) {
    if (!is_finite(answer))
        return std::isnan(force.x) && std::isnan(force.y);
    return length(force - answer) < 1e-12;
}

/// What the listing answers, as every law must give it: zero where the listing has no number.
Vec2 withheld(Vec2 listed) { return is_finite(listed) ? listed : Vec2(0.0); }

FlatScene one_line(std::vector<Vec2> points) { return {{"line"}, {{std::move(points), false}}}; }

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
        // Beyond the end of the contour v is not between v1 and v2: the pull is to v1 = (0,0), 5 mm away.
        force = published_algorithm_1(corner, tent, {-4, 3});
        QVERIFY(length(force - Vec2(0.48, -0.36)) < 1e-12);
        // r ≥ 2d
        QVERIFY(published_algorithm_1(corner, tent, {3, -8.5}) == Vec2(0.0));
    }

    void answers_from_outside_are_met_row_by_row() {
        const std::vector<Answer> rows = answers();
        QCOMPARE(rows.size(), std::size_t(309));
        std::set<std::string> names;
        int without_a_number = 0;
        for (const Answer& row : rows) {
            names.insert(row.name);
            without_a_number += is_finite(row.force) ? 0 : 1;
            const Vec2 raw = published_algorithm_1(row.vertices, row.profile, row.finger);
            const std::string what = row.name + ": " + std::to_string(raw.x) + ' ' + std::to_string(raw.y);
            QVERIFY2(same_force(raw, row.force), what.c_str());
            const PublishedLaw law(one_line(row.vertices), row.profile);
            QVERIFY2(same_force(law.at(row.finger).force, withheld(row.force)), what.c_str());
        }
        QCOMPARE(without_a_number, 2);
        for (const char* name :
             {"beside_the_end", "on_the_line", "on_the_vertex", "two_vertices_at_one_place", "short_segment",
              "two_contours", "at_d", "at_two_d", "beyond"})
            QVERIFY2(names.contains(name), name);
    }

    void equals_the_listing_on_random_points() {
        std::mt19937 random(6);
        for (int round = 0; round < 200; ++round) {
            std::vector<Vec2> vertices;
            for (int i = 0; i < 20; ++i)
                vertices.push_back(random_point(random, 20.0));
            for (int k = 0; k < 50; ++k) {
                const Vec2 hip = random_point(random, 25.0);
                QVERIFY(same_force(published_algorithm_1(vertices, {0.2, 4.0}, hip),
                                   listing(vertices, 0.2, 4.0, hip)));
            }
        }
    }

    void equals_the_listing_round_polygons() {
        std::mt19937 random(16);
        int beyond_the_segment = 0;
        for (int round = 0; round < 300; ++round) {
            // A polygon of 3 to 40 corners, its sides cut into unevenly many parts, and a second one over it.
            FlatScene scene;
            std::vector<Vec2> vertices;
            for (int which = 0; which < 2; ++which) {
                const int corners = 3 + static_cast<int>(random() % 38);
                const double radius = 5.0 + random_point(random, 5.0).x + 20.0 * which;
                Polyline line = ellipse(random_point(random, 10.0), radius, 0.2 * radius + 3.0, corners);
                if (round % 3 == 0)
                    line = with_vertex_spacing({{"polygon"}, {line}}, 0.3 + 0.1 * (round % 80)).lines[0];
                vertices.insert(vertices.end(), line.points.begin(), line.points.end());
                scene.names.push_back("polygon");
                scene.lines.push_back(std::move(line));
            }
            const TentProfile profile{0.1 * (1 + round % 5), 2.0 * (1 + round % 5)};
            const PublishedLaw law(scene, profile);
            for (int k = 0; k < 100; ++k) {
                const Vec2 hip = random_point(random, 40.0);
                const Vec2 expected = listing(vertices, profile.stiffness, profile.range, hip);
                QVERIFY(same_force(published_algorithm_1(vertices, profile, hip), expected));
                const Guidance at = law.at(hip);
                QVERIFY(same_force(at.force, withheld(expected)));
                const bool at_v1 = std::find(vertices.begin(), vertices.end(), at.nearest) != vertices.end();
                beyond_the_segment += at_v1 && at.force != Vec2(0.0) ? 1 : 0;
            }
        }
        QVERIFY(beyond_the_segment > 1000); // lines 14 to 22 answer often
    }

    void equally_near_vertices_and_vertices_of_a_grid() {
        // Whole numbers, whose distances are exact: many are equally near, and the earlier one is taken.
        std::mt19937 random(26);
        for (int round = 0; round < 300; ++round) {
            std::vector<Vec2> vertices;
            for (int i = 0; i < 12; ++i)
                vertices.emplace_back(double(random() % 9), double(random() % 9));
            const PublishedLaw law(one_line(vertices), {0.5, 2.0}, 1 + random() % 16);
            for (int x = -2; x <= 10; ++x)
                for (int y = -2; y <= 10; ++y) {
                    // On a slanting line rounding decides whether there is a number, and then it is zero.
                    const Vec2 expected = withheld(listing(vertices, 0.5, 2.0, Vec2(x, y)));
                    const Vec2 raw = published_algorithm_1(vertices, {0.5, 2.0}, Vec2(x, y));
                    QVERIFY(same_force(withheld(raw), expected));
                    QVERIFY(same_force(law.at(Vec2(x, y)).force, expected));
                }
        }
    }

    void the_foot_lies_between_the_vertices_or_on_the_nearer() {
        QVERIFY(published_foot({0, 0}, {10, 0}, {4, 3}) == Vec2(4, 0));
        QVERIFY(published_foot({0, 0}, {10, 0}, {-1, 3}) == Vec2(0, 0));
        QVERIFY(published_foot({0, 0}, {10, 0}, {0, 3}) == Vec2(0, 0));
        QVERIFY(published_foot({0, 0}, {10, 0}, {10, 3}) == Vec2(10, 0));
        QVERIFY(published_foot({0, 0}, {10, 0}, {11, 3}) == Vec2(0, 0)); // v1 as it is given
        QVERIFY(published_foot({2, 1}, {2, 1}, {4, 3}) == Vec2(2, 1));
        // So near that the square of their distance is zero.
        QVERIFY(published_foot({0, 0}, {1e-170, 0}, {4, 3}) == Vec2(0, 0));
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
        // They make no line: the pull is to the place of both.
        QVERIFY(length(published_algorithm_1(twins, {0.2, 4.0}, {2, 2}) - Vec2(-0.2, -0.2)) < 1e-12);
        QVERIFY(!is_finite(published_algorithm_1(twins, {}, {1, 1})));
        QVERIFY(published_algorithm_1({{1, 1}}, {}, {2, 2}) == Vec2(0.0));
        const PublishedLaw law(one_line(twins), {0.2, 4.0});
        QVERIFY(length(law.at({2, 2}).force - Vec2(-0.2, -0.2)) < 1e-12);
        QVERIFY(law.at({1, 1}).force == Vec2(0.0));
        QVERIFY(law.at({1, 1}).distance == 0.0 && law.at({1, 1}).nearest == Vec2(1, 1));
        QVERIFY(PublishedLaw(FlatScene{}, {}).at({2, 2}).contour == -1);
        QVERIFY(PublishedLaw(FlatScene{{"c"}, {{corner, false}}}, {}).at({std::nan(""), 2}).force ==
                Vec2(0.0));
    }

    void vertices_of_two_contours_make_a_line_that_is_not_there() {
        // Two horizontal lips 2 mm apart, vertices 5 mm apart: between the lips and near a vertex v1 and v2
        // are of different lips, the line between them is vertical and the force is sideways.
        FlatScene lips;
        lips.names = {"upper", "lower"};
        lips.lines = {{{{-5, 1}, {0, 1}, {5, 1}}, false}, {{{-5, -1}, {0, -1}, {5, -1}}, false}};
        const Guidance published = PublishedLaw(lips, {}).at({0.5, 0.5});
        const Guidance exact = ExactLaw(lips, {}).at({0.5, 0.5});
        QVERIFY(length(exact.force - Vec2(0, 0.1)) < 1e-12);
        QVERIFY(length(published.force - Vec2(-0.1, 0)) < 1e-12);
        // Above both the projection is not between them, and v1 answers: nearly right.
        QVERIFY(length(PublishedLaw(lips, {}).at({0.5, 2.5}).force - Vec2(-0.1, -0.3)) < 1e-12);
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

} // namespace published_law_test

TP_TEST(published_law_test, PublishedLawTest, nothing)
#include "published_law_test.moc"
