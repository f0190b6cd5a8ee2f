// SPDX-License-Identifier: Apache-2.0
// What is seen on frames of a simulated camera before portraits.
#include "app/capture/frames/simulated_camera.hpp"
#include "app/capture/seeing/aim_eye.hpp"
#include "faces/detect/detector.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace aim_eye_test {

using namespace tp;

namespace {

cv::Mat anna() { return *read_picture(test::in_source("resources/samples/anna_smiling.jpg")); }

/// A portrait as large as a person: its face is about 20 cm high.
PhotoWall life_size() { return {0.6, 1.0, {0.5, 0.45}}; }

CameraFrame frame_of(const cv::Mat& photo, const HeldPose& pose, double time_s = 0.0, double exposure = 1.0) {
    CameraFrame frame;
    FrameTaking taking;
    taking.exposure = exposure;
    frame.pixels = view_of(photo, life_size(), pose, {}, {}, taking);
    frame.time_s = time_s;
    return frame;
}

double overlap(const Rect& a, const Rect& b) {
    const Vec2 low = glm::max(a.min, b.min), high = glm::min(a.max, b.max);
    if (high.x <= low.x || high.y <= low.y)
        return 0.0;
    const double both = (high.x - low.x) * (high.y - low.y);
    return both / (a.width() * a.height() + b.width() * b.height() - both);
}

/// The largest face that the detector finds in the whole frame, in shares of it.
Rect face_in_whole(EmbeddedDetector& detector, const cv::Mat& frame) {
    const std::vector<Detection> found = detector.detect(frame, Effort::usual);
    if (found.empty())
        return {};
    const Detection& face =
        *std::max_element(found.begin(), found.end(),
                          [](const Detection& a, const Detection& b) { return a.size() < b.size(); });
    const Vec2 size(frame.cols, frame.rows);
    return {face.box.min / size, face.box.max / size};
}

/// Clockwise turn of the line through the eyes, degrees.
double tilt_of(const AimFace& face, double aspect) {
    auto [left, right] = *face.eyes;
    if (right.x < left.x)
        std::swap(left, right);
    return std::atan2(right.y - left.y, (right.x - left.x) * aspect) * 180.0 / std::numbers::pi;
}

} // namespace

class AimEyeTest : public QObject {
    Q_OBJECT
private slots:
    void a_face_is_where_the_detector_sees_it_in_the_whole_frame() {
        NEEDS_PORTRAITS();
        const std::vector<portraits::Portrait> people = portraits::held_out();
        AimEye eye;
        EmbeddedDetector detector;
        for (std::size_t i = 0; i < 6; ++i) {
            const cv::Mat photo = *read_picture(people[i].photo);
            for (const HeldPose& pose :
                 {HeldPose{}, HeldPose{.pan_deg = 15.0, .tilt_deg = -5.0, .roll_deg = 12.0},
                  HeldPose{.pan_deg = -8.0, .forward_m = -0.8}}) {
                const CameraFrame frame = frame_of(photo, pose);
                const AimFrame seen = eye.see(frame);
                QCOMPARE(seen.faces.size(), std::size_t{1});
                QVERIFY(seen.faces[0].confidence > 0.5);
                const double same = overlap(seen.faces[0].box, face_in_whole(detector, frame.pixels));
                QVERIFY2(same > 0.7, qPrintable(QString("%1: %2").arg(people[i].photo.c_str()).arg(same)));
                const auto& eyes = *seen.faces[0].eyes;
                QVERIFY(seen.faces[0].box.contains(eyes[0]) && seen.faces[0].box.contains(eyes[1]));
            }
        }
    }

    void places_are_shares_of_the_frame() {
        AimEye eye;
        const AimFrame seen = eye.see(frame_of(anna(), {.pan_deg = -12.0}));
        QCOMPARE(seen.faces.size(), std::size_t{1});
        const Vec2 centre = seen.faces[0].box.centre();
        QVERIFY(centre.x > 0.6 && centre.x < 0.8 && std::abs(centre.y - 0.5) < 0.1);
        QVERIFY(std::abs(seen.aspect - 16.0 / 9.0) < 1e-9);
    }

    void light_of_the_face_and_round_it_follow_the_exposure() {
        AimEye eye;
        const AimFrame light = eye.see(frame_of(anna(), {}));
        const AimFrame dark = eye.see(frame_of(anna(), {}, 0.1, 0.4));
        const double ratio = *dark.faces.at(0).brightness / *light.faces.at(0).brightness;
        QVERIFY2(std::abs(ratio - 0.4) < 0.05, qPrintable(QString::number(ratio)));
        QVERIFY(*light.faces[0].brightness > 0.2 && *light.faces[0].brightness < 0.95);
        QVERIFY(light.surroundings && *light.surroundings > 0.3);
    }

    void the_horizon_turns_as_the_eyes_do() {
        for (const bool mirrored : {false, true}) {
            SimulatedHold hold;
            hold.wall = life_size();
            hold.tremor.peak_g = hold.tremor.sway_deg = 0.0;
            hold.held = {mirrored, mirrored};
            hold.start.roll_deg = 15.0;
            hold.start.tilt_deg = 3.0;
            SimulatedCamera camera(anna(), hold);
            AimEye eye(camera.held());
            const AimFrame seen = eye.see(**camera.next());
            QCOMPARE(*seen.elevation_deg, 3.0);
            camera.move_to({});
            const AimFrame level = eye.see(**camera.next());
            QCOMPARE(*level.horizon_deg, 0.0);
            QCOMPARE(seen.faces.size(), std::size_t{1});
            const double turned =
                tilt_of(seen.faces[0], seen.aspect) - tilt_of(level.faces.at(0), level.aspect);
            QVERIFY2(std::abs(*seen.horizon_deg - turned) < 6.0, // of a drawn face; people's are within 2
                     qPrintable(QString("%1 and %2").arg(*seen.horizon_deg).arg(turned)));
        }
        QVERIFY(!AimEye().see(frame_of(anna(), {})).horizon_deg);
    }

    void motion_is_the_hands() {
        SimulatedHold hold;
        hold.wall = life_size();
        hold.wall.width_m = 2.0;
        hold.tremor.peak_g = hold.tremor.sway_deg = 0.0;
        hold.frames_per_s = 10.0;
        SimulatedCamera camera(anna(), hold);
        AimEye eye;
        eye.see(**camera.next());
        HeldPose pose;
        for (int i = 0; i < 4; ++i) {
            const HeldPose before = pose;
            pose.pan_deg += 1.5;
            camera.move_to(pose);
            const AimFrame seen = eye.see(**camera.next());
            const double truth = picture_motion(before, pose, 0.1, hold.optics);
            QVERIFY(seen.motion && std::abs(*seen.motion - truth) < 0.15 * truth);
        }
        QVERIFY(*eye.see(**camera.next()).motion < 0.02);
    }

    void a_blurred_frame_is_less_sharp() {
        AimEye eye;
        CameraFrame frame = frame_of(anna(), {});
        QCOMPARE(*eye.see(frame).sharpness, 1.0);
        cv::GaussianBlur(frame.pixels, frame.pixels, {}, 5.0);
        frame.time_s = 0.1;
        QVERIFY(*eye.see(frame).sharpness < 0.35);
    }

    void shut_eyes_are_told_of_faces_that_are_large_enough() {
        NEEDS_PORTRAITS();
        const std::vector<portraits::Portrait> people = portraits::held_out();
        for (std::size_t i = 0; i < 4; ++i) {
            const cv::Mat open = *read_picture(people[i].photo);
            const cv::Mat shut =
                with_closed_eyes(open, people[i].truth, 1.0, static_cast<unsigned>(i)).picture;
            AimEye eye;
            QVERIFY(!eye.see(frame_of(open, {}, 0.0)).faces.at(0).eyes_shut);
            QVERIFY(!eye.see(frame_of(shut, {}, 0.1)).faces.at(0).eyes_shut); // looked at from time to time
            QVERIFY(eye.see(frame_of(shut, {}, 1.0)).faces.at(0).eyes_shut);
            QVERIFY(!eye.see(frame_of(open, {}, 2.0)).faces.at(0).eyes_shut);
            QVERIFY(!eye.see(frame_of(shut, {.forward_m = -3.0}, 3.0)).faces.at(0).eyes_shut);
        }
    }

    void a_face_is_asked_for_its_name_from_time_to_time() {
        AimEye eye;
        int asked = 0;
        eye.name_by([&asked](const cv::Mat& frame, const Face& face) {
            ++asked;
            const bool whole =
                frame.cols == 1280 && face.box.contains({640.0, 360.0}) && face.box.width() > 100.0;
            return whole ? std::string("Anna") : std::string("nobody");
        });
        const cv::Mat photo = anna();
        QCOMPARE(eye.see(frame_of(photo, {}, 1.0)).faces.at(0).name, std::string("Anna"));
        QCOMPARE(eye.see(frame_of(photo, {}, 1.5)).faces.at(0).name, std::string());
        QCOMPARE(eye.see(frame_of(photo, {}, 2.1)).faces.at(0).name, std::string("Anna"));
        QCOMPARE(asked, 2);
    }

    void of_two_one_is_asked_at_a_time_and_each_in_turn() {
        AimEye eye;
        std::vector<double> asked;
        eye.name_by([&asked](const cv::Mat&, const Face& face) {
            asked.push_back(face.box.centre().x);
            return std::string(face.box.centre().x < 640.0 ? "Anna" : "Ben");
        });
        const cv::Mat one = frame_of(anna(), {}, 0.0).pixels.colRange(320, 960);
        CameraFrame both;
        cv::hconcat(one, one, both.pixels);
        std::set<std::string> names;
        for (int i = 0; i < 2; ++i) {
            both.time_s = 2.0 * AimEye::name_every_s * (i + 1);
            const AimFrame seen = eye.see(both);
            QCOMPARE(seen.faces.size(), std::size_t{2});
            QCOMPARE(asked.size(), static_cast<std::size_t>(i + 1));
            for (const AimFace& face : seen.faces)
                if (!face.name.empty()) {
                    QCOMPARE(face.name, std::string(face.box.centre().x < 0.5 ? "Anna" : "Ben"));
                    names.insert(face.name);
                }
        }
        QCOMPARE(names.size(), std::size_t{2});
    }

    void what_is_no_picture_has_only_a_time() {
        AimEye eye;
        CameraFrame frame;
        frame.time_s = 7.0;
        QCOMPARE(eye.see(frame).time_s, 7.0);
        frame.pixels = cv::Mat(5, 5, CV_8UC3, cv::Scalar(1, 2, 3));
        QVERIFY(eye.see(frame).faces.empty());
        frame.pixels = cv::Mat(100, 100, CV_8UC1, cv::Scalar(1));
        QVERIFY(eye.see(frame).faces.empty());
        frame.pixels = cv::Mat(1, 2000, CV_8UC3, cv::Scalar(1, 2, 3));
        frame.time_s = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(eye.see(frame).faces.empty());
    }

    void a_frame_is_never_written_to() {
        AimEye eye;
        const cv::Mat large = frame_of(anna(), {}).pixels;
        for (const int width : {160, 320}) {
            cv::Mat small;
            cv::resize(large, small, {width, width * 9 / 16}, 0.0, 0.0, cv::INTER_AREA);
            const cv::Mat before = small.clone();
            eye.see({small, 0.0, {}, {}});
            eye.see({cv::Mat(720, 1280, CV_8UC3, cv::Scalar(1, 2, 3)), 0.1, {}, {}});
            QCOMPARE(cv::norm(small, before, cv::NORM_INF), 0.0);
        }
    }

    void where_nobody_is_no_face_is_sure() {
        AimEye eye;
        cv::RNG random(3);
        cv::Mat shapes(9, 16, CV_8UC3), frame;
        for (int i = 0; i < 10; ++i) {
            random.fill(shapes, cv::RNG::UNIFORM, 0, 255);
            cv::resize(shapes, frame, {1280, 720}, 0.0, 0.0, cv::INTER_CUBIC);
            const AimFrame seen = eye.see({frame, 0.1 * i, {}, {}});
            QVERIFY(std::none_of(seen.faces.begin(), seen.faces.end(),
                                 [](const AimFace& face) { return face.confidence >= 0.5; }));
        }
    }
};

} // namespace aim_eye_test

TP_TEST(aim_eye_test, AimEyeTest, nothing)
#include "aim_eye_test.moc"
