// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/closed_eyes.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/judge/covered.hpp"
#include "faces/judge/face_problem.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace covered_test {

using namespace tp;

namespace {

/// Signs of a sharp face that our nets and the mesh see in the same place.
QualitySigns signs_of_a_seen_face() {
    QualitySigns signs;
    signs.unit_px = 200.0;
    signs.has_second_opinion = true;
    signs.between_mirrors.fill(0.5);
    signs.between_nets.fill(0.8);
    signs.between_models.fill(0.8);
    signs.between_close.fill(0.8);
    signs.eye_openness = {0.3, 0.3};
    for (EdgeReports::Pair* pair :
         {&signs.edges.right_eye, &signs.edges.left_eye, &signs.edges.outer_lip, &signs.edges.inner_lip})
        *pair = {{0.4, 0.8}, {0.4, 0.8}};
    return signs;
}

/// Ours see the features elsewhere at each look, and there is no edge.
QualitySigns with_cover(std::initializer_list<FeatureIndex> features,
                        std::initializer_list<EdgeReports::Pair EdgeReports::*> edges) {
    QualitySigns signs = signs_of_a_seen_face();
    for (const FeatureIndex feature : features) {
        signs.between_models[feature] = 9.0;
        signs.between_close[feature] = 6.0;
        signs.between_nets[feature] = 5.0;
        signs.between_mirrors[feature] = 2.5;
    }
    for (const auto pair : edges)
        signs.edges.*pair = {{1.0, 0.0}, {1.0, 0.0}};
    return signs;
}

QualitySigns signs_of_a_covered_left_eye() { return with_cover({at_left_eye}, {&EdgeReports::left_eye}); }
QualitySigns signs_of_a_covered_mouth() {
    return with_cover({at_outer_lip, at_inner_lip}, {&EdgeReports::outer_lip, &EdgeReports::inner_lip});
}

bool is_said_covered(const Face& face, std::size_t contour) {
    return std::ranges::count(face.quality[contour].reasons, "may be covered") > 0;
}

struct Told {
    int covered = 0, said = 0, wrongly = 0;
    double error_sum = 0.0; ///< of those that are said, percent

    void note(bool is_covered, bool is_said, double error) {
        covered += is_covered;
        said += is_covered && is_said;
        wrongly += !is_covered && is_said;
        error_sum += is_covered && is_said ? error : 0.0;
    }
};

} // namespace

class CoveredTest : public QObject {
    Q_OBJECT

private slots:
    void what_the_models_see_elsewhere_without_edges_is_covered() {
        for (const FeatureIndex feature : {at_right_eye, at_left_eye, at_outer_lip, at_inner_lip, at_outline})
            QVERIFY(!is_covered(signs_of_a_seen_face(), feature));
        QVERIFY(is_covered(signs_of_a_covered_left_eye(), at_left_eye));
        QVERIFY(!is_covered(signs_of_a_covered_left_eye(), at_right_eye));
        QVERIFY(!is_covered(signs_of_a_covered_left_eye(), at_outer_lip));
        QVERIFY(is_covered(signs_of_a_covered_mouth(), at_outer_lip));
        QVERIFY(is_covered(signs_of_a_covered_mouth(), at_inner_lip));
        QVERIFY(!is_covered(signs_of_a_covered_mouth(), at_left_eye));
    }
    /// In shadow, behind glasses, or in a beard: edges are faint, and yet all see the feature in one place.
    void what_all_see_in_one_place_is_not() {
        QualitySigns shadow = signs_of_a_covered_left_eye(), beard = signs_of_a_covered_mouth();
        for (QualitySigns* signs : {&shadow, &beard}) {
            signs->between_models.fill(1.0);
            signs->between_close.fill(1.0);
            signs->between_nets.fill(1.0);
            signs->between_mirrors.fill(0.6);
        }
        QVERIFY(!is_covered(shadow, at_left_eye));
        QVERIFY(!is_covered(beard, at_outer_lip));
    }
    void an_eye_is_not_covered_by_its_lids() {
        QualitySigns shut = signs_of_a_covered_left_eye();
        shut.between_models[at_left_eye] = 3.0;
        shut.between_close[at_left_eye] = 2.5;
        shut.between_nets[at_left_eye] = 3.0;
        QVERIFY(is_covered(shut, at_left_eye));
        shut.eye_openness[at_left_eye] = 0.1;
        QVERIFY(!is_covered(shut, at_left_eye));
    }
    void dark_glasses_hide_both_eyes_and_nothing_else() {
        QualitySigns signs = signs_of_a_seen_face();
        signs.dark_glasses = true;
        for (const FeatureIndex feature : {at_outer_lip, at_inner_lip, at_outline})
            QVERIFY(!is_covered(signs, feature) && quality_of(signs, feature).reasons.empty());
        signs.unit_px = 20.0; // hard to see, and yet these are why
        for (const FeatureIndex eye : {at_right_eye, at_left_eye}) {
            signs.eye_openness[eye] = 0.05;
            QVERIFY(is_covered(signs, eye));
            QCOMPARE(quality_of(signs, eye).expected_error_percent, covered_eye_error_percent);
            QCOMPARE(quality_of(signs, eye).reasons, std::vector<std::string>{"dark glasses hide it"});
            QVERIFY(is_said_hidden(quality_of(signs, eye)));
        }
        signs.unit_px = 200.0;
        QCOMPARE(problem_of(signs),
                 std::string("Dark glasses hide the eyes, so their contours are a guess."));
        QVERIFY(!is_sure(signs));
    }
    void nothing_is_told_where_nothing_can_be() {
        QualitySigns small = signs_of_a_covered_left_eye(), one_opinion = small;
        small.unit_px = 20.0;
        one_opinion.has_second_opinion = false;
        for (const QualitySigns& signs : {small, one_opinion})
            QVERIFY(!can_tell_cover(signs, at_left_eye) && !is_covered(signs, at_left_eye));
        QVERIFY(!is_covered({}, at_left_eye));
    }
    void what_is_covered_is_said_with_its_error() {
        const ContourQuality eye = quality_of(signs_of_a_covered_left_eye(), at_left_eye);
        QCOMPARE(eye.expected_error_percent, covered_eye_error_percent);
        QCOMPARE(eye.reasons, std::vector<std::string>{"may be covered"});
        QCOMPARE(problem_of(signs_of_a_covered_left_eye()),
                 std::string("The left eye may be covered, so its contour may be wrong."));
        for (const FeatureIndex lip : {at_outer_lip, at_inner_lip}) {
            const ContourQuality quality = quality_of(signs_of_a_covered_mouth(), lip);
            QCOMPARE(quality.expected_error_percent, covered_mouth_error_percent);
            QCOMPARE(quality.reasons, std::vector<std::string>{"may be covered"});
        }
        QCOMPARE(problem_of(signs_of_a_covered_mouth()),
                 std::string("The mouth may be covered, so its contour may be wrong."));
    }

    /// People of whom nothing was learned and whom no training saw.
    void covered_features_are_said() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        const auto people = portraits::held_out();
        Told eyes, mouths;
        for (std::size_t i = 0; i < people.size(); ++i)
            for (const Degraded& way :
                 degraded(*read_picture(people[i].photo), people[i].truth, static_cast<unsigned>(i))) {
                const bool eye = way.how.starts_with("eye covered"), mouth = way.how == "mouth covered";
                if (!eye && !mouth && way.how != "as it is" && way.how != "noise 45")
                    continue;
                const Extraction found = faces.extract(way.picture);
                QCOMPARE(found.faces.size(), std::size_t{1});
                const Face& face = found.faces[0];
                const auto error_of = [&](std::size_t contour) {
                    return *contour_error_percent(way.truth, face.contours, face.contours[contour].name);
                };
                // The eyes come first. A cover lies on one of them: the one that is farther off, if none is
                // said.
                const bool said = is_said_covered(face, 0) || is_said_covered(face, 1);
                eyes.note(eye, said, error_of(is_said_covered(face, 0) ? 0 : 1));
                mouths.note(mouth, is_said_covered(face, 2), 0.5 * (error_of(2) + error_of(3)));
            }
        qInfo("eyes: %d of %d covered ones said, %d others; off by %.2f %%", eyes.said, eyes.covered,
              eyes.wrongly, eyes.error_sum / eyes.said);
        qInfo("mouths: %d of %d covered ones said, %d others; off by %.2f %%", mouths.said, mouths.covered,
              mouths.wrongly, mouths.error_sum / mouths.said);
        QCOMPARE(eyes.covered, 68);
        QCOMPARE(mouths.covered, 34);
        QVERIFY(eyes.said >= 62 && mouths.said >= 31); // nine in ten
        QCOMPARE(eyes.wrongly + mouths.wrongly, 0);
        QVERIFY(std::abs(eyes.error_sum / eyes.said - covered_eye_error_percent) <
                0.2); // what a person is told
        QVERIFY(std::abs(mouths.error_sum / mouths.said - covered_mouth_error_percent) < 0.2);
    }
    /// Where the mesh sees them they would be open.
    void shut_eyes_are_drawn_shut() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        const auto people = portraits::held_out();
        for (const double shut : {0.5, 1.0}) {
            int eyes = 0;
            double sum = 0.0;
            for (std::size_t i = 0; i < people.size(); i += 2) {
                const Degraded closed = with_closed_eyes(*read_picture(people[i].photo), people[i].truth,
                                                         shut, static_cast<unsigned>(i));
                const Extraction found = faces.extract(closed.picture);
                QCOMPARE(found.faces.size(), std::size_t{1});
                const Face& face = found.faces[0];
                for (std::size_t eye = 0; eye < 2; ++eye, ++eyes) {
                    QVERIFY2(!is_said_covered(face, eye), people[i].photo.c_str());
                    sum += *contour_error_percent(closed.truth, face.contours, face.contours[eye].name);
                }
            }
            qInfo("%d eyes shut by %.0f %%: %.2f %%", eyes, 100.0 * shut, sum / eyes);
            QVERIFY(sum / eyes < 0.85);
        }
    }
};

} // namespace covered_test

TP_TEST(covered_test, CoveredTest, event_loop)
#include "covered_test.moc"
