// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/plausibility.hpp"
#include "test_program.hpp"

#include <QTest>

namespace plausibility_test {

using namespace tp;

namespace {

/// Points that stand as in a face, 100 px between the eyes' outer corners.
Landmarks well_placed() {
    Landmarks face;
    face.right_eye.assign(16, Vec2(100.0, 100.0));
    face.left_eye.assign(16, Vec2(200.0, 100.0));
    face.right_eye[eye_corner] = {130.0, 100.0};
    face.left_eye[eye_corner] = {170.0, 100.0};
    face.outer_lip.assign(20, Vec2(125.0, 180.0));
    face.outer_lip[mouth_corner] = {175.0, 180.0};
    face.outline = {{70.0, 100.0}, {150.0, 240.0}, {230.0, 100.0}};
    return face;
}

} // namespace

/// A face is refused as soon as it must be, and never sooner.
class PlausibilityTest : public QObject {
    Q_OBJECT

private slots:
    void what_is_refused_early_would_be_refused_late() {
        const Landmarks face = well_placed();
        int early = 0, believed = 0;
        for (double passes = 0.0; passes < 0.15; passes += 0.004)
            for (double mirrors = 0.0; mirrors < 0.05; mirrors += 0.002) {
                const Steadiness so_far{.between_passes = passes, .between_mirrors = mirrors};
                const double at_best = confidence_of(face, so_far);
                QCOMPARE(is_unsteady(so_far), at_best < 0.5);
                early += is_unsteady(so_far);
                for (const double nets : {0.0, 0.01, 0.1}) {
                    Steadiness all = so_far;
                    all.between_nets = nets;
                    QVERIFY(confidence_of(face, all) <= at_best);
                    believed += confidence_of(face, all) >= 0.5;
                }
            }
        QVERIFY(early > 100 && believed > 100);
    }

    void features_that_do_not_stand_as_in_a_face_are_none_however_steady() {
        QVERIFY(confidence_of(well_placed(), {}) > 0.99);
        Landmarks face = well_placed();
        face.outer_lip.assign(20, Vec2(150.0, 60.0));
        QCOMPARE(confidence_of(face, {}), 0.0);
        face = well_placed();
        face.left_eye.assign(16, face.right_eye[0]);
        QCOMPARE(confidence_of(face, {}), 0.0);
        face = well_placed();
        face.outline.back() = {110.0, 100.0};
        QCOMPARE(confidence_of(face, {}), 0.0);
    }
};

} // namespace plausibility_test

TP_TEST(plausibility_test, PlausibilityTest, nothing)
#include "plausibility_test.moc"
