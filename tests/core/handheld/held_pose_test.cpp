// SPDX-License-Identifier: Apache-2.0
// The camera's geometry, what a detector sees of people, and how a hand trembles.
#include "core/aiming/face_tracks.hpp"
#include "core/handheld/hand_tremor.hpp"
#include "core/handheld/held_pose.hpp"
#include "core/handheld/seen_people.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace held_pose_test {

using namespace tp;

namespace {

const CameraOptics optics;

Vec2 seen(const HeldPose& pose, const ScenePlace& place = {0.0, 0.0, 2.0}) {
    return projected(place, pose, optics)->at;
}

AimFrame faultless(const std::vector<ScenePlace>& people, const HeldPose& pose) {
    Chance chance(1);
    return seen_people(people, pose, optics, DetectorManner::faultless(), chance);
}

} // namespace

class HeldPoseTest : public QObject {
    Q_OBJECT
private slots:
    void what_one_aims_at_is_in_the_middle() { QVERIFY(length(seen({}) - Vec2(0.5)) < 1e-12); }

    void a_camera_that_goes_right_moves_all_to_the_left() {
        QVERIFY(seen({.pan_deg = 10.0}).x < 0.5);
        QVERIFY(seen({.tilt_deg = 10.0}).y > 0.5);
        QVERIFY(seen({.roll_deg = 20.0}, {0.5, 0.0, 2.0}).y < 0.5); // clockwise: what is at the right goes up
        QVERIFY(seen({}, {0.5, 0.0, 2.0}).x > 0.5);
        QVERIFY(seen({}, {0.0, 0.5, 2.0}).y < 0.5);
    }

    void the_field_ends_at_the_edge() {
        QVERIFY(std::abs(seen({.pan_deg = -31.0}).x - 1.0) < 1e-9);
        const double up =
            std::atan(std::tan(31.0 * std::numbers::pi / 180.0) / optics.aspect) * 180.0 / std::numbers::pi;
        QVERIFY(std::abs(seen({.tilt_deg = up}).y - 1.0) < 1e-9);
    }

    void nearer_and_zoomed_is_larger() {
        const ScenePlace ear{0.1, 0.0, 2.0};
        QVERIFY(std::abs((seen({.forward_m = 1.0}, ear).x - 0.5) / (seen({}, ear).x - 0.5) - 2.0) < 1e-9);
        QVERIFY(std::abs((seen({.zoom = 3.0}, ear).x - 0.5) / (seen({}, ear).x - 0.5) - 3.0) < 1e-9);
    }

    void what_is_behind_is_not_seen() {
        QVERIFY(!projected({0.0, 0.0, 2.0}, {.forward_m = 1.96}, optics));
        QVERIFY(!projected({0.0, 0.0, 2.0}, {.forward_m = 3.0}, optics));
        QVERIFY(!projected({0.0, 0.0, 2.0}, {.pan_deg = 120.0}, optics));
        QVERIFY(!projected({0.0, 0.0, NAN}, {}, optics));
    }

    void distances_between_places_do_not_change_with_a_turn() {
        // A rotation keeps the angle between two directions, which the tangents of a pinhole tell.
        const auto direction = [](Vec2 at) {
            const double focal = optics.focal(1.0);
            return std::vector{(at.x - 0.5) / focal, (0.5 - at.y) / (focal * optics.aspect), 1.0};
        };
        const auto cosine = [](const std::vector<double>& a, const std::vector<double>& b) {
            const auto dot = [](const auto& u, const auto& v) {
                return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
            };
            return dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
        };
        const ScenePlace one{0.3, 0.1, 2.0};
        const ScenePlace other{-0.2, -0.3, 1.5};
        const double straight = cosine(direction(seen({}, one)), direction(seen({}, other)));
        const HeldPose turned{.pan_deg = 12.0, .tilt_deg = -9.0, .roll_deg = 25.0};
        QVERIFY(std::abs(cosine(direction(seen(turned, one)), direction(seen(turned, other))) - straight) <
                1e-12);
    }

    void motion_is_what_the_middle_does() {
        const HeldPose after{.pan_deg = 0.1, .tilt_deg = 0.0};
        const double moved = std::abs(seen(after).x - 0.5) / 0.01;
        QVERIFY(std::abs(picture_motion({}, after, 0.01, optics) / moved - 1.0) < 1e-3);
    }

    void a_face_is_as_large_as_geometry_says() {
        const AimFrame frame = faultless({{0.0, 0.0, 1.0}}, {});
        QCOMPARE(frame.faces.size(), std::size_t{1});
        const Rect box = frame.faces[0].box;
        QVERIFY(std::abs(box.height() / box.width() - face_height_m / face_width_m * optics.aspect) < 1e-9);
        QVERIFY(std::abs(box.width() - face_width_m * optics.focal(1.0)) < 1e-9);
    }

    void eyes_lean_against_the_camera() {
        FaceTracks tracks;
        for (int i = 0; i < 2; ++i) {
            AimFrame frame = faultless({{0.0, 0.0, 1.0}}, {.roll_deg = 15.0});
            frame.time_s = i;
            tracks.see(frame);
        }
        QVERIFY(std::abs(*tracks.faces()[0].tilt_deg + 15.0) < 1e-6);
    }

    void who_is_too_far_or_too_far_beside_is_not_found() {
        QVERIFY(faultless({{0.0, 0.0, 8.0}}, {}).faces.empty());
        QVERIFY(faultless({{0.0, 0.0, 2.0}}, {.pan_deg = 32.5}).faces.empty());
        QCOMPARE(faultless({{0.0, 0.0, 2.0}}, {.pan_deg = 30.5}).faces.size(), std::size_t{1});
        QVERIFY(faultless({{0.0, 0.0, 2.0}}, {.forward_m = 2.5}).faces.empty());
        QCOMPARE(faultless({{0.0, 0.0, 2.0}, {0.6, 0.0, 2.0}}, {}).faces.size(), std::size_t{2});
    }

    void a_detector_misses_as_often_as_it_says() {
        Chance chance(5);
        int found = 0;
        for (int i = 0; i < 4000; ++i)
            found += static_cast<int>(seen_people({{0.0, 0.0, 1.0}}, {}, optics, {}, chance).faces.size());
        QVERIFY(std::abs(found / 4000.0 - 0.97) < 0.01);
    }

    void a_mirror_swaps_only_sides() {
        const AimFrame frame = faultless({{0.3, 0.1, 1.5}}, {.roll_deg = 10.0});
        const AimFrame turned = mirrored(frame);
        QVERIFY(std::abs(turned.faces[0].box.centre().x - (1.0 - frame.faces[0].box.centre().x)) < 1e-12);
        QCOMPARE(turned.faces[0].box.centre().y, frame.faces[0].box.centre().y);
        QVERIFY(turned.faces[0].box.width() > 0.0);
        const Rect again = mirrored(turned).faces[0].box;
        QVERIFY(length(again.min - frame.faces[0].box.min) < 1e-12);
    }

    void a_still_hand_trembles_as_published() {
        const TremorManner manner;
        // 0.01 g at 7 Hz is 0.0507 mm.
        QVERIFY(std::abs(manner.tremor_deg() * std::numbers::pi / 180.0 * manner.lever_m - 0.0507e-3) < 1e-6);
        HandTremor tremor(manner, 7);
        double sum = 0.0;
        double squares = 0.0;
        double fastest = 0.0;
        HeldPose before = tremor.added_to({});
        constexpr int steps = 200'000;
        for (int i = 0; i < steps; ++i) {
            tremor.step(0.01);
            const HeldPose now = tremor.added_to({});
            sum += now.pan_deg;
            squares += now.pan_deg * now.pan_deg;
            fastest = std::max(fastest, std::abs(now.pan_deg - before.pan_deg) / 0.01);
            before = now;
        }
        QVERIFY(std::abs(sum / steps) < 0.1);
        QVERIFY(std::abs(std::sqrt(squares / steps) - manner.sway_deg) < 0.1);
        QVERIFY(fastest < 8.0); // degrees a second: an arm has mass
    }
};

} // namespace held_pose_test

TP_TEST(held_pose_test, HeldPoseTest, nothing)
#include "held_pose_test.moc"
