// SPDX-License-Identifier: Apache-2.0
// Motion, sharpness and light of frames whose motion, blur and light are known.
#include "app/capture/frames/photo_view.hpp"
#include "app/capture/seeing/frame_light.hpp"
#include "app/capture/seeing/frame_motion.hpp"
#include "app/capture/seeing/frame_sharpness.hpp"
#include "core/handheld/held_pose.hpp"
#include "faces/decode/picture.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace frame_measures_test {

using namespace tp;

namespace {

constexpr Rect all{{0.0, 0.0}, {1.0, 1.0}};
constexpr Rect middle{{0.25, 0.25}, {0.75, 0.75}};

cv::Mat portrait() { return *read_picture(test::in_source("resources/samples/anna_smiling.jpg")); }

cv::Mat seen_from(const HeldPose& pose, const HeldPose& rate = {}, double wall_m = 2.0) {
    static const cv::Mat photo = portrait();
    return view_of(photo, {wall_m, 1.5, {0.5, 0.5}}, pose, rate, {}, {});
}

/// About as many pixels of the photograph as of the frame.
cv::Mat fine_frame(const HeldPose& rate = {}) { return seen_from({}, rate, 1.2); }

cv::Mat small_grey(const cv::Mat& frame) {
    cv::Mat small, grey;
    cv::resize(frame, small, {160, 90}, 0.0, 0.0, cv::INTER_AREA);
    cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
    return grey;
}

std::optional<double> motion_between(const HeldPose& before, const HeldPose& after, double dt) {
    FrameMotion motion;
    if (motion.see(small_grey(seen_from(before)), 5.0))
        return std::nullopt; // of one frame nothing is known
    return motion.see(small_grey(seen_from(after)), 5.0 + dt);
}

} // namespace

class FrameMeasuresTest : public QObject {
    Q_OBJECT
private slots:
    void motion_is_what_the_pose_moved_by() {
        const HeldPose start{.pan_deg = -2.0, .tilt_deg = 1.0};
        for (const HeldPose& end : {HeldPose{.pan_deg = -1.6, .tilt_deg = 1.0}, HeldPose{.pan_deg = -4.0},
                                    HeldPose{.pan_deg = 4.0, .tilt_deg = 3.0}})
            for (const double dt : {1.0 / 30.0, 0.1}) {
                const auto seen = motion_between(start, end, dt);
                const double truth = picture_motion(start, end, dt, {});
                QVERIFY(seen);
                QVERIFY2(std::abs(*seen - truth) < 0.1 * truth + 0.002 / dt,
                         qPrintable(QString("%1 instead of %2").arg(*seen).arg(truth)));
            }
    }

    void who_stands_still_does_not_move() { QVERIFY(*motion_between({}, {}, 0.1) < 0.01); }

    void another_light_is_no_motion() {
        FrameMotion motion;
        const cv::Mat frame = small_grey(seen_from({}));
        motion.see(frame, 0.0);
        cv::Mat darker;
        frame.convertTo(darker, CV_8U, 0.5, 10.0);
        QVERIFY(*motion.see(darker, 0.1) < 0.01);
    }

    void frames_that_have_nothing_in_common_tell_no_motion() {
        FrameMotion motion;
        const cv::Mat one = small_grey(seen_from({.pan_deg = -15.0}));
        const cv::Mat other = small_grey(seen_from({.pan_deg = 40.0, .roll_deg = 50.0}));
        QVERIFY(!motion.see(one, 0.0));
        QVERIFY(!motion.see(other, 0.1));
        QVERIFY(motion.see(other, 0.2)); // the same again
        QVERIFY(!motion.see(other, 0.2 + FrameMotion::longest_s * 1.1));
        QVERIFY(!motion.see(other, 0.1)); // a clock set back
        QVERIFY(!motion.see(other.t(), 0.2));
        QVERIFY(!motion.see(cv::Mat(90, 160, CV_8UC1, cv::Scalar(9)), 0.3));
    }

    void blur_makes_less_fine_and_light_does_not() {
        const cv::Mat sharp = fine_frame();
        const double fine = *fineness(sharp, middle);
        double before = fine;
        for (const double sigma : {1.5, 3.0, 6.0}) {
            cv::Mat blurred;
            cv::GaussianBlur(sharp, blurred, {}, sigma);
            const double here = *fineness(blurred, middle);
            QVERIFY2(here < 0.9 * before, qPrintable(QString::number(here / fine)));
            before = here;
        }
        QVERIFY(before < 0.35 * fine);
        cv::Mat darker;
        sharp.convertTo(darker, CV_8U, 0.5);
        QVERIFY(std::abs(*fineness(darker, middle) / fine - 1.0) < 0.1);
    }

    void a_smear_along_one_axis_is_seen() {
        const cv::Mat sharp = fine_frame();
        const double fine = *fineness(sharp, middle);
        for (const cv::Size smear : {cv::Size(9, 1), cv::Size(1, 9)}) {
            cv::Mat smeared;
            cv::blur(sharp, smeared, smear);
            QVERIFY2(*fineness(smeared, middle) < 0.5 * fine,
                     qPrintable(QString::number(*fineness(smeared, middle) / fine)));
        }
        QVERIFY(*fineness(fine_frame({.pan_deg = 20.0}), middle) < 0.8 * fine);
        QVERIFY(*fineness(fine_frame({.tilt_deg = 20.0}), middle) < 0.8 * fine);
    }

    void nothing_to_see_has_no_fineness() {
        QVERIFY(!fineness({}, all));
        QVERIFY(!fineness(cv::Mat(200, 300, CV_8UC3, cv::Scalar(90, 90, 90)), all));
        const cv::Mat frame = fine_frame();
        QVERIFY(!fineness(frame, {{1.2, 0.2}, {1.4, 0.4}}));
        QVERIFY(!fineness(frame, {{0.5, 0.5}, {0.501, 0.501}}));
        QVERIFY(!fineness(frame, {{std::numeric_limits<double>::quiet_NaN(), 0.0}, {1.0, 1.0}}));
        QVERIFY(fineness(frame, {{-0.5, -0.5}, {1.5, 1.5}}));
    }

    void sharpness_is_against_the_sharpest_of_late() {
        FrameSharpness sharpness;
        QCOMPARE(*sharpness.see(0.04, 0.0), 1.0);
        QVERIFY(std::abs(*sharpness.see(0.02, 0.1) - 0.5) < 0.01);
        QVERIFY(!sharpness.see(std::nullopt, 0.2));
        QVERIFY(std::abs(*sharpness.see(0.02, FrameSharpness::halves_in_s) - 1.0) < 0.01); // faded to it
        QCOMPARE(*sharpness.see(0.08, 30.0), 1.0);
        QCOMPARE(*sharpness.see(0.01, 1.0), 1.0); // a clock set back: anew
    }

    void light_is_measured_where_it_is_asked_for() {
        cv::Mat grey(90, 160, CV_8UC1, cv::Scalar(51));
        const Rect face{{0.4, 0.3}, {0.6, 0.7}};
        grey(cv::Rect(64, 27, 32, 36)).setTo(204);
        QVERIFY(std::abs(*brightness_of(grey, face) - 0.8) < 1e-9);
        QVERIFY(std::abs(*brightness_beside(grey, {face}) - 0.2) < 1e-9);
        QVERIFY(*brightness_beside(grey, {}) > 0.22);
        QVERIFY(!brightness_of(grey, {{1.1, 0.3}, {1.3, 0.7}}));
        QVERIFY(!brightness_beside(grey, {{{0.0, 0.0}, {1.0, 1.0}}}));
        QVERIFY(!brightness_beside({}, {}));
        const Rect half_out{{-0.1, 0.3}, {0.1, 0.7}};
        QVERIFY(std::abs(*brightness_of(grey, half_out) - 0.2) < 1e-9);
    }
};

} // namespace frame_measures_test

TP_TEST(frame_measures_test, FrameMeasuresTest, nothing)
#include "frame_measures_test.moc"
