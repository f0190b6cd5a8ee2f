// SPDX-License-Identifier: Apache-2.0
#include "faces/base/face.hpp"
#include "faces/edges/edge_fit.hpp"
#include "faces/edges/edge_profile.hpp"
#include "faces/evaluation/edge_lessons.hpp"
#include "faces/evaluation/edge_table.hpp"
#include "faces/evaluation/training_half.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cstdio>
#include <fstream>

namespace edge_lessons_test {

using namespace tp;

namespace {

const Vec2 down(0.0, 1.0);
constexpr double unit = 200.0;

/// A line of `count` points from x = 20 to 80 at this height.
std::vector<Vec2> level(double y, std::size_t count = edge_points) {
    std::vector<Vec2> line;
    for (std::size_t i = 0; i < count; ++i)
        line.emplace_back(20.0 + 60.0 * static_cast<double>(i) / static_cast<double>(count - 1), y);
    return line;
}

/// Skin above, red below `edge`, grainy.
cv::Mat lip(double edge) {
    cv::Mat picture(80, 100, CV_8UC3, cv::Scalar(120, 140, 170));
    for (int y = 0; y < picture.rows; ++y) {
        const double t = std::clamp(y + 1.0 - edge, 0.0, 1.0);
        picture.row(y).setTo(cv::Scalar(120 - 40 * t, 140 - 60 * t, 170));
    }
    cv::RNG random(1);
    cv::Mat grain(picture.size(), CV_16SC3), noisy;
    random.fill(grain, cv::RNG::NORMAL, 0.0, 4.0);
    cv::add(picture, grain, noisy, cv::noArray(), CV_8U);
    return noisy;
}

std::vector<std::string> table_lines() {
    std::ifstream file(tp::test::in_source("faces/edges/edge_look_weights.inc"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("    {"))
            lines.push_back(line);
    return lines;
}

} // namespace

class EdgeLessonsTest : public QObject {
    Q_OBJECT

private slots:
    void weights_and_looks_are_the_same_thing() {
        for (const EdgeLook& look : edge_looks) {
            const cv::Mat1d weights = weights_of(look);
            QCOMPARE(weights.rows, edge_features);
            QCOMPARE(weights(5), look.redness.fine_bend);
            QCOMPARE(cv::norm(weights_of(look_with(weights, 1.0, 2.0)), weights), 0.0);
            QCOMPARE(look_with(weights, 1.0, 2.0).bend, 2.0);
        }
    }
    /// What is learned from is what the fit goes by: features times weights are its evidence.
    void features_add_up_to_the_evidence() {
        const cv::Mat picture = lip(40.3);
        const Opening start{level(42.0), level(30.0)};
        EdgeLessons lessons;
        learn(lessons, picture, start, {level(40.3), level(31.0)}, down, unit, at_outer_lower_lip,
              at_outer_upper_lip);
        const auto& lower = lessons[at_outer_lower_lip];
        QCOMPARE(lower.size(), edge_points - 2);
        const EdgeProfile profile =
            edge_profile(picture, start.lower, down, unit, edge_grain_percent[at_outer_lower_lip]);
        const Evidence evidence = evidence_in(profile, outer_lower_lip);
        for (std::size_t i = 0; i < lower.size(); ++i) {
            const cv::Mat1d sums(lower[i].seen * weights_of(outer_lower_lip));
            QCOMPARE(static_cast<std::size_t>(sums.rows), evidence.offsets);
            for (std::size_t k = 0; k < evidence.offsets; ++k)
                QVERIFY(std::abs(sums(static_cast<int>(k)) - evidence.at(i + 1, k)) < 1e-9);
        }
    }
    /// 1.7 px above a line that looks downwards, 1 px below one that looks upwards, in steps of 0.4 px.
    void true_lines_are_taken_where_they_cross() {
        EdgeLessons lessons;
        learn(lessons, lip(40.3), {level(42.0), level(30.0)}, {level(40.3, 3), level(31.0, 3)}, down, unit,
              at_lower_lid, at_upper_lid);
        QVERIFY(!lessons[at_lower_lid].empty() && !lessons[at_upper_lid].empty());
        for (const PlaceChoice& choice : lessons[at_lower_lid])
            QVERIFY(std::abs(choice.taken - (25.0 - 1.7 / 0.4)) < 1e-9);
        for (const PlaceChoice& choice : lessons[at_upper_lid])
            QVERIFY(std::abs(choice.taken - (25.0 - 1.0 / 0.4)) < 1e-9);
    }
    void true_lines_out_of_reach_teach_nothing() {
        EdgeLessons lessons;
        learn(lessons, lip(40.0), {level(42.0), level(30.0)}, {level(55.0), {}}, down, unit, at_lower_lid,
              at_upper_lid);
        QVERIFY(lessons[at_lower_lid].empty() && lessons[at_upper_lid].empty());
    }
    /// Learned where an edge is, found where it is in another picture.
    void learned_looks_find_their_edge() {
        EdgeLessons lessons;
        for (double edge : {38.2, 40.3, 41.6})
            learn(lessons, lip(edge), {level(40.0), level(30.0)}, {level(edge), level(30.0)}, down, unit,
                  at_lower_lid, at_upper_lid);
        const cv::Mat1d weights = likeliest_weights(lessons[at_lower_lid], edge_features, 1.0);
        for (Vec2 p : on_edge(lip(37.4), level(40.0), down, unit, look_with(weights, 0.02, 2.0)))
            QVERIFY2(std::abs(p.y - 37.4) < 0.3, qPrintable(QString::number(p.y)));
    }

    void crossings_are_the_nearest_and_signed() {
        const std::vector<Vec2> zigzag{{0, 4}, {10, 4}, {10, 9}, {0, 9}, {0, -3}, {10, -3}};
        QCOMPARE(*crossing(zigzag, {5, 0}, {0, 1}), -3.0);
        QCOMPARE(*crossing(zigzag, {5, 2}, {0, 1}), 2.0);
        QCOMPARE(*crossing(zigzag, {5, 2}, {0, -1}), -2.0);
        QVERIFY(!crossing(zigzag, {11, 0}, {0, 1}));
        QVERIFY(!crossing({}, {0, 0}, {0, 1}) && !crossing({{1, 1}}, {1, 0}, {0, 1}));
        QVERIFY(!crossing({{1, 1}, {1, 1}}, {1, 0}, {0, 1}));
        QVERIFY(!crossing(zigzag, {NAN, 0}, {0, 1}) && !crossing(zigzag, {5, 0}, {0, 0}));
    }
    void placed_contours_have_two_edges() {
        const Opening eye = placed_opening(contour_through(
            feature::right_eye, {{0, 10}, {10, 5}, {20, 5}, {30, 10}, {20, 14}, {10, 14}}, true));
        for (const auto& line : {eye.lower, eye.upper}) {
            QCOMPARE(line.front(), Vec2(0, 10));
            QCOMPARE(line.back(), Vec2(30, 10));
        }
        QCOMPARE(*crossing(eye.upper, {15, 10}, {0, 1}), -5.0);
        QCOMPARE(*crossing(eye.lower, {15, 10}, {0, 1}), 4.0);
    }

    /// The table that is compiled in, read as text, is what its numbers print as.
    void the_table_is_printed_as_it_is_read() {
        const auto lines = table_lines();
        QCOMPARE(lines.size(), static_cast<std::size_t>(edge_kind_count));
        for (std::size_t kind = 0; kind < edge_kind_count; ++kind) {
            const std::string comment = lines[kind].substr(lines[kind].find("// ") + 3);
            QCOMPARE(edge_table_row(edge_looks[kind], comment), lines[kind]);
            double w[8], stray = 0.0, bend = 0.0;
            QCOMPARE(std::sscanf(lines[kind].c_str(),
                                 " {{%lf, %lf, %lf, %lf}, {%lf, %lf, %lf, %lf}, %lf, %lf}", w, w + 1, w + 2,
                                 w + 3, w + 4, w + 5, w + 6, w + 7, &stray, &bend),
                     10);
            const EdgeLook read = look_with(cv::Mat1d(edge_features, 1, w), stray, bend);
            QCOMPARE(cv::norm(weights_of(read), weights_of(edge_looks[kind])), 0.0);
            QVERIFY(read.stray == edge_looks[kind].stray && read.bend == edge_looks[kind].bend);
        }
    }
    void nothing_is_printed_as_minus_nothing() {
        const EdgeLook look{{-0.001, 0.0, 1.005, -1.0}, {}, 0.04, 2.0};
        QCOMPARE(edge_table_row(look, "x"),
                 std::string("    {{0.00, 0.00, 1.00, -1.00}, {0.00, 0.00, 0.00, 0.00}, 0.04, 2.00}, // x"));
    }

    void who_is_held_out_is_read_or_refused() {
        const auto people = held_out_people(tp::test::in_source("faces/training/holdout.txt"));
        QVERIFY(people.ok());
        QCOMPARE(people->size(), std::size_t{34});
        QVERIFY(people->contains("003") && !people->contains("002"));
        QCOMPARE(person_in("photos/london/003_08.jpg"), std::string("003"));
        QTemporaryDir folder;
        const std::string file = (folder.path() + "/nobody.txt").toStdString();
        std::ofstream(file) << "# nobody\n\n";
        QVERIFY(!held_out_people(file).ok());
        QVERIFY(!held_out_people("/nowhere/holdout.txt").ok());
    }
};

} // namespace edge_lessons_test

TP_TEST(edge_lessons_test, EdgeLessonsTest, event_loop)
#include "edge_lessons_test.moc"
