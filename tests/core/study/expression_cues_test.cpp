// SPDX-License-Identifier: Apache-2.0
#include "core/study/expression_cues.hpp"
#include "drawn_face.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>

namespace expression_cues_test {

using namespace tp;
using tp::testing::DrawnFace;

namespace {

ExpressionCues cues_of(const DrawnFace& face) { return expression_cues(face.contours()).value(); }

template <typename Map>
std::vector<Contour> all_mapped(const std::vector<Contour>& contours, const Map& map) {
    std::vector<Contour> result;
    for (const Contour& contour : contours)
        result.push_back(mapped(contour, map));
    return result;
}

double largest_difference(const ExpressionCues& a, const ExpressionCues& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < cue_count; ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

Contour& named(std::vector<Contour>& contours, const char* name) {
    return *std::find_if(contours.begin(), contours.end(), [&](const Contour& c) { return c.name == name; });
}

DrawnFace lively_face() {
    DrawnFace face;
    face.opening = 6.0;
    face.corner_lift = 4.0;
    face.lid_slope = 1.5;
    face.eye_slant = 2.0;
    return face;
}

} // namespace

class ExpressionCuesTest : public QObject {
    Q_OBJECT
private slots:
    void cues_are_what_was_drawn() {
        const DrawnFace face = lively_face();
        const ExpressionCues cues = cues_of(face);
        // The middle and the corners are a stretch of a line, which makes a curved one a little flatter.
        const std::pair<Cue, double> drawn[] = {
            {Cue::mouth_width, face.mouth_width},       {Cue::mouth_opening, face.opening},
            {Cue::outer_corner_lift, face.corner_lift}, {Cue::inner_corner_lift, face.corner_lift},
            {Cue::lip_height, face.lip_height},         {Cue::eye_opening, face.eye_opening},
            {Cue::lid_slope, face.lid_slope},           {Cue::eye_slant, face.eye_slant},
            {Cue::chin_depth, face.chin_depth}};
        for (const auto& [cue, value] : drawn)
            QVERIFY2(std::abs(at(cues, cue) - value) < 0.1 + 0.1 * std::abs(value),
                     qPrintable(QStringLiteral("%1 %2, drawn %3")
                                    .arg(cue_kinds[static_cast<std::size_t>(cue)].name)
                                    .arg(at(cues, cue))
                                    .arg(value)));
    }

    /// The signs, as a person would say them.
    void a_smile_lifts_and_a_sad_mouth_drops_the_corners() {
        DrawnFace smiling, sad;
        smiling.corner_lift = 6.0;
        sad.corner_lift = -6.0;
        for (const Cue cue : {Cue::outer_corner_lift, Cue::inner_corner_lift}) {
            QVERIFY(at(cues_of(smiling), cue) > 5.0);
            QVERIFY(at(cues_of(sad), cue) < -5.0);
        }
        DrawnFace sagging;
        sagging.lid_slope = 2.0;
        QVERIFY(at(cues_of(sagging), Cue::lid_slope) > 1.5);
        DrawnFace slanted;
        slanted.eye_slant = 3.0;
        QVERIFY(at(cues_of(slanted), Cue::eye_slant) > 2.5);
    }

    void every_cue_grows_with_its_measure_and_leaves_the_other_half_of_the_face_alone() {
        struct Measure {
            double DrawnFace::*drawn;
            double from, to;
            std::vector<Cue> grow;
            bool of_mouth;
        };
        const Measure measures[] = {
            {&DrawnFace::mouth_width, 40, 75, {Cue::mouth_width}, true},
            {&DrawnFace::opening, 0, 20, {Cue::mouth_opening}, true},
            {&DrawnFace::corner_lift, -8, 12, {Cue::outer_corner_lift, Cue::inner_corner_lift}, true},
            {&DrawnFace::lip_height, 6, 26, {Cue::lip_height}, true},
            {&DrawnFace::eye_opening, 2, 16, {Cue::eye_opening}, false},
            {&DrawnFace::lid_slope, -2, 3, {Cue::lid_slope}, false},
            {&DrawnFace::eye_slant, -2, 6, {Cue::eye_slant}, false}};
        for (const Measure& measure : measures) {
            ExpressionCues before{};
            for (int i = 0; i <= 20; ++i) {
                DrawnFace face;
                face.*measure.drawn = measure.from + (measure.to - measure.from) * i / 20.0;
                const ExpressionCues cues = cues_of(face);
                if (i > 0) {
                    for (const Cue cue : measure.grow)
                        QVERIFY(at(cues, cue) > at(before, cue) + 0.3 * (measure.to - measure.from) / 20.0);
                    for (const Cue cue : {Cue::eye_opening, Cue::lid_slope, Cue::eye_slant})
                        QVERIFY(!measure.of_mouth || std::abs(at(cues, cue) - at(before, cue)) < 1e-6);
                    for (const Cue cue : {Cue::mouth_width, Cue::mouth_opening, Cue::lip_height})
                        QVERIFY(measure.of_mouth || std::abs(at(cues, cue) - at(before, cue)) < 0.02);
                }
                before = cues;
            }
        }
    }

    void place_size_roll_and_mirroring_change_nothing() {
        const std::vector<Contour> contours = lively_face().contours();
        const ExpressionCues cues = expression_cues(contours).value();
        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        for (int i = 0; i < 300; ++i) {
            const double angle = 4.0 * number(random);
            const double scale = std::pow(10.0, 3.0 * number(random));
            const Vec2 shift(1e3 * number(random), 1e3 * number(random));
            const double mirror = i % 2 == 0 ? 1.0 : -1.0;
            const auto moved = all_mapped(contours, [&](Vec2 p) {
                p.x *= mirror;
                return scale * Vec2(std::cos(angle) * p.x - std::sin(angle) * p.y,
                                    std::sin(angle) * p.x + std::cos(angle) * p.y) +
                       shift;
            });
            const auto found = expression_cues(moved);
            QVERIFY2(found.ok(), found.error().c_str());
            QVERIFY(largest_difference(cues, *found) < 1e-6);
        }
    }

    /// A surface's y runs up, a mirrored face's left eye may still be called the left one.
    void neither_the_sense_of_y_nor_the_eyes_names_matter() {
        std::vector<Contour> contours = lively_face().contours();
        const ExpressionCues cues = expression_cues(contours).value();
        const auto flipped = all_mapped(contours, [](Vec2 p) { return Vec2(p.x, -p.y); });
        QVERIFY(largest_difference(cues, expression_cues(flipped).value()) < 1e-9);
        std::swap(named(contours, "left_eye").pieces, named(contours, "right_eye").pieces);
        QVERIFY(largest_difference(cues, expression_cues(contours).value()) < 1e-9);
    }

    void where_a_contour_begins_and_which_way_it_runs_do_not_matter() {
        std::vector<Contour> contours = lively_face().contours();
        const ExpressionCues cues = expression_cues(contours).value();
        for (Contour& contour : contours) {
            std::vector<Vec2> points;
            for (const Piece& piece : contour.pieces)
                points.push_back(start_of(piece));
            if (contour.closed)
                std::rotate(points.begin(), points.begin() + 37, points.end());
            else
                points.push_back(end_of(contour.pieces.back()));
            std::reverse(points.begin(), points.end());
            contour = contour_through(contour.name, points, contour.closed);
        }
        QVERIFY(largest_difference(cues, expression_cues(contours).value()) < 1e-6);
    }

    void lips_that_are_one_line_are_shut() {
        std::vector<Contour> contours = DrawnFace{}.contours();
        named(contours, "inner_lip") = contour_through("inner_lip", {{-25, 75}, {25, 75}}, false);
        const ExpressionCues cues = expression_cues(contours).value();
        QCOMPARE(at(cues, Cue::mouth_opening), 0.0);
        QCOMPARE(at(cues, Cue::inner_corner_lift), 0.0);
    }

    void what_is_no_face_is_said_in_a_sentence_data() {
        using Change = std::function<void(std::vector<Contour>&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<QByteArray>("says");
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        for (const char* name : {"left_eye", "right_eye", "outer_lip", "inner_lip", "outline"}) {
            const QByteArray quoted = '"' + QByteArray(name) + '"';
            QTest::addRow("no %s", name)
                << Change([name](auto& all) { named(all, name).name = "brow"; }) << quoted;
            QTest::addRow("%s without pieces", name)
                << Change([name](auto& all) { named(all, name).pieces.clear(); }) << quoted;
            QTest::addRow("%s nowhere", name) << Change([name](auto& all) {
                named(all, name) = contour_through(name, {{nan, 0}, {1, nan}}, true);
            }) << quoted;
            if (std::string_view(name) != "outline")
                QTest::addRow("%s in one point", name) << Change([name](auto& all) {
                    named(all, name) = contour_through(
                        name, {{10, std::string_view(name).ends_with("lip") ? 75.0 : 0.0}}, true);
                }) << quoted;
        }
        QTest::newRow("nothing") << Change([](auto& all) { all.clear(); }) << QByteArray("\"left_eye\"");
        QTest::newRow("both eyes in one place")
            << Change([](auto& all) { named(all, "left_eye").pieces = named(all, "right_eye").pieces; })
            << QByteArray("one place");
        QTest::newRow("mouth between the eyes") << Change([](auto& all) {
            named(all, "outer_lip") = mapped(named(all, "outer_lip"), [](Vec2 p) { return p - Vec2(0, 75); });
        }) << QByteArray("between its eyes");
        QTest::newRow("an upright lip") << Change([](auto& all) {
            named(all, "inner_lip") = contour_through("inner_lip", {{0, 70}, {0, 80}}, true);
        }) << QByteArray("\"inner_lip\"");
        QTest::newRow("beyond all numbers")
            << Change([](auto& all) { all = all_mapped(all, [](Vec2 p) { return 1e307 * p; }); })
            << QByteArray();
    }
    void what_is_no_face_is_said_in_a_sentence() {
        QFETCH(std::function<void(std::vector<Contour>&)>, change);
        QFETCH(QByteArray, says);
        std::vector<Contour> contours = DrawnFace{}.contours();
        change(contours);
        const auto found = expression_cues(contours);
        QVERIFY(!found.ok());
        QVERIFY2(found.error().ends_with('.') && QByteArray::fromStdString(found.error()).contains(says),
                 found.error().c_str());
    }

    void random_scribbles_give_finite_cues_or_a_sentence() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> place(-5.0, 5.0);
        std::uniform_int_distribution<int> count(0, 6);
        int measured = 0;
        for (int i = 0; i < 5000; ++i) {
            std::vector<Contour> contours;
            for (const char* name : {"left_eye", "right_eye", "outer_lip", "inner_lip", "outline"}) {
                std::vector<Vec2> points(static_cast<std::size_t>(count(random)));
                for (Vec2& p : points)
                    p = {std::round(place(random)), std::round(place(random))}; // coincide now and then
                if (!points.empty())
                    contours.push_back(contour_through(name, points, i % 2 == 0));
            }
            const auto found = expression_cues(contours);
            if (!found) {
                QVERIFY(found.error().ends_with('.'));
                continue;
            }
            ++measured;
            for (const double cue : *found)
                QVERIFY(std::isfinite(cue));
        }
        QVERIFY(measured > 500);
    }
};

} // namespace expression_cues_test

TP_TEST(expression_cues_test, ExpressionCuesTest, nothing)
#include "expression_cues_test.moc"
