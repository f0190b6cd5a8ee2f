// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/calibration_steps.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace calibration_steps_test {

using namespace tp;

namespace {

const Rect area{{10.0, -150.0}, {250.0, -10.0}};
/// A device that lies turned and mirrored on the screen.
const Affine device_to_screen{glm::dmat2(0.0, 1.0, 1.0, 0.0), {130.0, -80.0}};

Vec2 in_device(Vec2 touched) { return device_to_screen.inverse()->direction(touched - device_to_screen.offset); }

struct Finger {
    CalibrationSteps steps{area};
    double time = 0.0;

    /// Rests there for so long, asked 60 times a second; how many marks that has reached.
    int rest(Vec2 touched, double seconds, Vec2 slip = Vec2(0.0)) {
        int reached = 0;
        for (const double end = time + seconds; time < end; time += 1.0 / 60.0)
            reached += steps.sample(touched, in_device(touched + slip), time) ? 1 : 0;
        return reached;
    }
    void stroke(Vec2 from, Vec2 to, double mm_s, double late_s = 0.0) {
        const double length_mm = length(to - from);
        for (double at = 0.0; at < length_mm; at += mm_s / 60.0, time += 1.0 / 60.0)
            steps.sample(from + at / length_mm * (to - from),
                         in_device(from + std::min(length_mm, at + late_s * mm_s) / length_mm * (to - from)), time);
    }
};

constexpr Vec2 corners[] = {{30.0, -30.0}, {230.0, -30.0}, {230.0, -130.0}, {30.0, -130.0}};

} // namespace

class CalibrationStepsTest : public QObject {
    Q_OBJECT
private slots:
    void four_corners_that_are_held_give_the_map() {
        Finger finger;
        for (const Vec2 corner : corners) {
            QCOMPARE(finger.rest(corner, 1.0), 1);
            finger.steps.lift();
        }
        QCOMPARE(finger.steps.mark(), CalibrationSteps::all_touched);
        const auto found = finger.steps.calibration();
        QVERIFY2(found.ok(), found.error().c_str());
        QVERIFY(found->residual_mm < 1e-9);
        QVERIFY(length(found->device_to_surface({12.0, 34.0}) - device_to_screen({12.0, 34.0})) < 1e-9);
        QCOMPARE(finger.rest(corners[0], 2.0), 0);
    }

    void a_mark_counts_only_where_it_was_asked_for_and_when_it_is_held() {
        Finger finger;
        QCOMPARE(finger.rest(corners[1], 2.0), 0);
        QCOMPARE(finger.rest(area.centre(), 2.0), 0);
        finger.steps.lift();
        QCOMPARE(finger.rest(corners[0], 0.6), 0);
        finger.steps.lift(); // lifted too early it begins anew
        QCOMPARE(finger.rest(corners[0], 0.6), 0);
        QCOMPARE(finger.rest(corners[0], 0.3), 1);
        finger.stroke(corners[0], corners[1], 20.0); // 10 s through the next quadrant, never at rest
        QCOMPARE(finger.steps.mark(), CalibrationSteps::top_right);
    }

    void what_is_stroked_slowly_counts_and_what_is_stroked_fast_does_not() {
        Finger finger;
        finger.rest(corners[0], 1.0);
        const std::size_t rested = finger.steps.pairs().size();
        finger.stroke(corners[0], corners[1], 200.0, 0.03); // 6 mm late
        QVERIFY(finger.steps.pairs().size() <= rested + 1);
        finger.stroke(corners[1], corners[0], 20.0, 0.02); // 0.4 mm late
        QVERIFY(finger.steps.pairs().size() > rested + 100);
        for (const FramePair& pair : finger.steps.pairs())
            QVERIFY(length(device_to_screen(pair.device) - pair.surface) < 1.0);
    }

    /// Any three corners fit a map without a residual; the fourth tells that the device has slipped.
    void a_device_that_slips_at_one_corner_is_a_miss() {
        for (std::size_t slipped = 0; slipped < 4; ++slipped) {
            Finger finger;
            for (std::size_t i = 0; i < 4; ++i) {
                QCOMPARE(finger.rest(corners[i], i == slipped ? 0.78 : 1.5, i == slipped ? Vec2(6.0, 0.0) : Vec2(0.0)), 1);
                finger.steps.lift();
            }
            const auto found = finger.steps.calibration();
            QVERIFY(!found.ok() || found->residual_mm > most_residual_mm);
        }
    }
};

} // namespace calibration_steps_test

TP_TEST(calibration_steps_test, CalibrationStepsTest, event_loop)
#include "calibration_steps_test.moc"
