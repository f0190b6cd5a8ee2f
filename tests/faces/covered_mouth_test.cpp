// SPDX-License-Identifier: Apache-2.0
#include "faces/covered_mouth.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/face_extractor.hpp"
#include "faces/face_problem.hpp"
#include "faces/net_points.hpp"
#include "portraits.hpp"

#include <QTest>

#include <cmath>

using namespace tp;

namespace {

/// A frontal face whose eyes' outer corners are 100 px apart, its lips where they cannot be.
Landmarks frontal_face() {
    Landmarks points;
    points.right_eye.assign(16, Vec2(100.0, 100.0));
    points.left_eye.assign(16, Vec2(200.0, 100.0));
    points.outer_lip.assign(20, Vec2(0.0));
    points.inner_lip.assign(20, Vec2(0.0));
    for (int i = 0; i <= 32; ++i) {
        const double angle = 3.14159265358979 * i / 32.0;
        points.outline.emplace_back(150.0 - 80.0 * std::cos(angle), 110.0 + 120.0 * std::sin(angle));
    }
    return points;
}

/// Signs of a sharp face that two nets and two looks see in the same place.
QualitySigns signs_of_a_seen_mouth() {
    QualitySigns signs;
    signs.unit_px = 200.0;
    signs.between_mirrors.fill(0.5);
    signs.between_nets.fill(1.5);
    for (EdgeReports::Pair* pair :
         {&signs.edges.right_eye, &signs.edges.left_eye, &signs.edges.outer_lip, &signs.edges.inner_lip})
        *pair = {{0.4, 0.8}, {0.4, 0.8}};
    return signs;
}

QualitySigns signs_of_a_covered_mouth() {
    QualitySigns signs = signs_of_a_seen_mouth();
    for (FeatureIndex lip : {at_outer_lip, at_inner_lip}) {
        signs.between_mirrors[lip] = 2.6;
        signs.between_nets[lip] = 3.8;
    }
    signs.edges.inner_lip = {{1.0, 0.0}, {1.0, 0.3}};
    signs.edges.outer_lip = {{1.0, 0.1}, {1.0, 0.1}};
    return signs;
}

} // namespace

class CoveredMouthTest : public QObject {
    Q_OBJECT

private slots:
    void looks_that_differ_where_no_edge_is_tell_a_cover() {
        QVERIFY(!is_mouth_covered(signs_of_a_seen_mouth()));
        QVERIFY(is_mouth_covered(signs_of_a_covered_mouth()));
        QualitySigns agreeing = signs_of_a_covered_mouth();
        agreeing.between_mirrors.fill(0.5); // a mouth wide open: its edges are strange, where it is is known
        agreeing.between_nets.fill(1.5);
        QVERIFY(!is_mouth_covered(agreeing));
    }
    /// Small and blurred faces are said to be that, and a model without a mirror knows too little.
    void nothing_is_told_where_nothing_can_be() {
        QualitySigns small = signs_of_a_covered_mouth(), blurred = small, one_look = small;
        small.unit_px = 20.0;
        blurred.edges.right_eye = blurred.edges.left_eye = {{0.0, 0.1}, {0.0, 0.1}};
        one_look.between_mirrors.fill(0.0);
        for (const QualitySigns& signs : {small, blurred, one_look})
            QVERIFY(!can_tell_cover(signs) && !is_mouth_covered(signs));
        QVERIFY(!is_mouth_covered({}));
    }
    void a_covered_mouth_is_said_with_the_error_of_the_guess() {
        const QualitySigns signs = signs_of_a_covered_mouth();
        for (FeatureIndex lip : {at_outer_lip, at_inner_lip}) {
            const ContourQuality quality = quality_of(signs, lip);
            QCOMPARE(quality.expected_error_percent, guessed_lips_error_percent);
            QCOMPARE(quality.reasons, std::vector<std::string>{"may be covered"});
        }
        QCOMPARE(problem_of(signs), std::string("The mouth may be covered, so its contour may be wrong."));
    }

    void guessed_lips_lie_between_eyes_and_chin() {
        const Landmarks guess = with_guessed_lips(frontal_face());
        for (const auto* lip : {&guess.outer_lip, &guess.inner_lip}) {
            const Vec2 width = (*lip)[mouth_corner] - (*lip)[0];
            QVERIFY(width.x > 40.0 && width.x < 80.0 && std::abs(width.y) < 1e-6);
            for (Vec2 p : *lip)
                QVERIFY(p.y > 150.0 && p.y < 215.0);
        }
        QVERIFY(guess.outer_lip[5].y > guess.inner_lip[5].y);   // the lower edges
        QVERIFY(guess.outer_lip[15].y < guess.inner_lip[15].y); // the upper ones
        QVERIFY(guess.right_eye == frontal_face().right_eye && guess.outline == frontal_face().outline);
    }
    void turned_and_scaled_faces_have_turned_and_scaled_guesses() {
        const Landmarks face = frontal_face(), guess = with_guessed_lips(face);
        const auto moved = [](Vec2 p) {
            return Vec2(1.2 * p.x - 0.9 * p.y + 30.0, 0.9 * p.x + 1.2 * p.y - 7.0);
        };
        Landmarks other = face;
        for (auto* line : {&other.right_eye, &other.left_eye, &other.outline})
            for (Vec2& p : *line)
                p = moved(p);
        const Landmarks there = with_guessed_lips(other);
        for (std::size_t i = 0; i < guess.outer_lip.size(); ++i)
            QVERIFY(length(there.outer_lip[i] - moved(guess.outer_lip[i])) < 1e-6);
    }
    void mirrored_faces_have_mirrored_guesses() {
        Landmarks face = frontal_face();
        for (std::size_t i = 0; i < face.outline.size(); ++i)
            face.outline[i].x += 0.1 * static_cast<double>(i); // one cheek is larger
        Landmarks other = face;
        const auto across = [](Vec2 p) { return Vec2(300.0 - p.x, p.y); };
        for (std::size_t i = 0; i < face.outline.size(); ++i)
            other.outline[i] = across(face.outline[face.outline.size() - 1 - i]);
        const Landmarks guess = with_guessed_lips(face), there = with_guessed_lips(other);
        const std::size_t first = net_points::outer_lip.begin;
        for (std::size_t i = 0; i < guess.outer_lip.size(); ++i)
            QVERIFY(length(there.outer_lip[in_mirror(first + i) - first] - across(guess.outer_lip[i])) < 0.1);
    }
    void a_face_whose_eyes_are_in_one_place_stays() {
        Landmarks face = frontal_face();
        face.left_eye = face.right_eye;
        QVERIFY(with_guessed_lips(face).outer_lip == face.outer_lip);
    }
    /// Every fourth person, of whom nothing was learned and whom no training saw.
    void covered_mouths_are_said_and_guessed() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        const auto people = portraits::held_out();
        int covered = 0, said = 0, wrongly_said = 0;
        double sum = 0.0, guessed = 0.0;
        for (std::size_t i = 0; i < people.size(); i += 2)
            for (const Degraded& way :
                 degraded(*read_picture(people[i].photo), people[i].truth, static_cast<unsigned>(i))) {
                const bool is_covered = way.how == "mouth covered";
                if (!is_covered && way.how != "as it is")
                    continue;
                const Extraction found = faces.extract(way.picture);
                QCOMPARE(found.faces.size(), std::size_t{1});
                const bool told = found.problem == "The mouth may be covered, so its contour may be wrong.";
                covered += is_covered;
                said += is_covered && told;
                wrongly_said += !is_covered && told;
                if (!is_covered)
                    continue;
                const auto error_of = [&](const char* lip) {
                    return *contour_error_percent(way.truth, found.faces[0].contours, lip);
                };
                sum += error_of(feature::outer_lip);
                if (told)
                    guessed += 0.5 * (error_of(feature::outer_lip) + error_of(feature::inner_lip));
            }
        qInfo("%d of %d covered mouths are said to be so, and %d others; outer lip %.2f %%, both lips where guessed %.2f %%", said,
              covered, wrongly_said, sum / covered, guessed / said);
        QCOMPARE(covered, 17);
        QVERIFY(said >= 15);
        QCOMPARE(wrongly_said, 0);
        QVERIFY(sum / covered <= 2.9);
        QVERIFY(std::abs(guessed / said - guessed_lips_error_percent) < 0.3); // what a person is told
    }
};

QTEST_GUILESS_MAIN(CoveredMouthTest)
#include "covered_mouth_test.moc"
