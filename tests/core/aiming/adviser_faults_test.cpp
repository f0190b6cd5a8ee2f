// SPDX-License-Identifier: Apache-2.0
#include "frames.hpp"
#include "test_program.hpp"
#include "watched.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace adviser_faults_test {

using namespace tp;
using namespace tp::testing;

class AdviserFaultsTest : public QObject {
    Q_OBJECT
private slots:
    void a_face_nearer_to_an_edge_than_a_fiftieth_is_cut() {
        for (const Aim aim : {Aim::middle, Aim::thirds, Aim::head_and_shoulders, Aim::everybody}) {
            const auto cut = [aim](double top) { return Watched(aim).stare(face_at(0.5, top + 0.135)).cut; };
            QCOMPARE(cut(0.03), AimEdge::none);
            QCOMPARE(cut(0.015), AimEdge::top);
        }
    }

    /// Picture widths a second count: as fast up and down is slower.
    void a_face_that_moves_is_blurred_by_the_widths_that_it_goes() {
        const auto blur = [](Vec2 way) {
            Watched back;
            for (int i = 0; i < 15; ++i)
                back.see(face_at(0.45 + way.x * 0.1 * i, 0.4 + way.y * 0.1 * i));
            return back.size(AimFault::blur);
        };
        QVERIFY(blur({0.16, 0.0}) >= 1.0);
        QVERIFY(blur({0.0, 0.16}) < 1.0);
    }

    /// A fault begins at 0.22 of brightness and is twice its limit a tenth below.
    void a_face_is_dark_below_its_limit_and_the_darker_the_worse() {
        const auto light = [](double brightness) {
            Watched back;
            AimFace face = face_at(0.5, 0.45);
            face.brightness = brightness;
            back.stare(face);
            return back.size(AimFault::light);
        };
        QVERIFY(std::abs(light(0.22) - 1.0) < 1e-9);
        QVERIFY(std::abs(light(0.12) - 2.0) < 1e-9);
        QVERIFY(light(0.3) < 1.0);
    }

    void a_blur_ends_well_above_where_it_begins() {
        Watched watched;
        const auto advice = [&watched](double sharpness) {
            AimFrame frame = frame_of(0.0, {face_at(0.5, 0.45)});
            frame.sharpness = sharpness;
            return watched.stare(frame).advice;
        };
        QCOMPARE(advice(0.36), Advice::ready);
        QCOMPARE(advice(0.34), Advice::keep_still);
        QCOMPARE(advice(0.39), Advice::keep_still);
        QCOMPARE(advice(0.41), Advice::ready);
    }

    void what_is_no_number_hides_no_blur() {
        const double inf = std::numeric_limits<double>::infinity();
        const auto advice = [](double motion, double sharpness) {
            AimFrame frame = frame_of(0.0, {face_at(0.5, 0.45)});
            frame.motion = motion;
            frame.sharpness = sharpness;
            return Watched().stare(frame).advice;
        };
        QCOMPARE(advice(inf, 0.2), Advice::keep_still);
        QCOMPARE(advice(0.24, -inf), Advice::keep_still);
        QCOMPARE(advice(inf, -inf), Advice::ready);
    }

    /// Of everybody the darkest counts; who is not the subject does not.
    void the_light_on_whom_the_picture_is_about() {
        AimFace large = face_at(0.5, 0.45), dark = face_at(0.8, 0.4, 0.2);
        const AimFace unknown = face_at(0.2, 0.4, 0.15); // how bright is not known
        large.brightness = 0.5;
        dark.brightness = 0.15;
        dark.eyes_shut = true;
        for (const auto& faces : {std::vector{large, dark}, std::vector{dark, large, unknown}}) {
            Watched one, all(Aim::everybody);
            QCOMPARE(one.stare(frame_of(0.0, faces)).advice, Advice::ready);
            all.stare(frame_of(0.0, faces));
            QVERIFY(std::abs(all.size(AimFault::light) - 1.7) < 1e-9);
            QVERIFY(all.adviser.there(AimFault::eyes));
        }
    }

    void nobody_has_no_fault() {
        Watched watched;
        watched.stare(face_at(0.7, 0.45, 0.1, 20.0));
        QVERIFY(watched.adviser.badness() > 1.0);
        watched.stare(frame_of(0.0, {}));
        QCOMPARE(watched.adviser.faults(), AimFaultSizes{});
        QVERIFY(!watched.adviser.there(AimFault::size));
        QCOMPARE(watched.adviser.badness(), 0.0);
        QCOMPARE(watched.stare(face_at(0.58, 0.45)).advice, Advice::ready); // and begins anew
    }

    void the_faces_own_motion_is_motion() {
        Watched watched;
        AimInstruction last;
        for (int i = 0; i < 12; ++i)
            last = watched.see(face_at(0.41 + 0.015 * i, 0.45));
        QCOMPARE(last.advice, Advice::keep_still);
    }

    void without_eyes_the_horizon_says_the_tilt() {
        AimFace face = face_at(0.5, 0.45);
        face.eyes.reset();
        AimFrame frame = frame_of(0.0, {face});
        frame.horizon_deg = -15.0;
        QCOMPARE(Watched().stare(frame).advice, Advice::turn_anticlockwise);
        frame.horizon_deg = no_number;
        Watched level;
        QCOMPARE(level.stare(frame).advice, Advice::ready);
        QCOMPARE(level.size(AimFault::tilt), 0.0);
        frame.horizon_deg.reset();
        Watched neither;
        QCOMPARE(neither.stare(frame).advice, Advice::ready);
        QCOMPARE(neither.size(AimFault::tilt), 0.0);
        frame.horizon_deg = 15.0;
        frame.faces[0] = face_at(0.5, 0.45);
        QCOMPARE(Watched().stare(frame).advice, Advice::ready);
    }

    void a_place_at_its_limit_does_not_flap() {
        Watched watched;
        Advice before = watched.stare(face_at(0.59, 0.45)).advice;
        QCOMPARE(before, Advice::ready);
        int changes = 0;
        for (int i = 0; i < 200; ++i) {
            const AimInstruction now = watched.see(face_at(0.6 + (i % 2 == 0 ? 0.006 : -0.006), 0.45));
            changes += now.advice != before ? 1 : 0;
            before = now.advice;
        }
        QCOMPARE(before, Advice::move_right);
        QCOMPARE(changes, 1);
    }

    void a_fault_ends_well_below_where_it_begins() {
        Watched watched;
        watched.stare(face_at(0.5, 0.45));
        QCOMPARE(watched.stare(face_at(0.595, 0.45)).advice, Advice::ready);
        QCOMPARE(watched.stare(face_at(0.605, 0.45)).advice, Advice::move_right);
        QCOMPARE(watched.stare(face_at(0.58, 0.45)).advice, Advice::move_right);
        QCOMPARE(watched.stare(face_at(0.57, 0.45)).advice, Advice::ready);
    }

    /// Light behind somebody ends at three quarters of where it begins.
    void light_behind_begins_and_ends() {
        Watched watched;
        const auto advice = [&watched](double behind) {
            AimFace face = face_at(0.5, 0.45);
            face.brightness = 0.2; // dark before any background
            AimFrame frame = frame_of(0.0, {face});
            frame.surroundings = behind;
            return watched.stare(frame).advice;
        };
        QCOMPARE(advice(0.48), Advice::more_light); // 0.9 times its limit
        QCOMPARE(advice(0.5), Advice::light_behind_them);
        QCOMPARE(advice(0.48), Advice::light_behind_them);
        QCOMPARE(advice(0.44), Advice::more_light);
        QCOMPARE(advice(0.7), Advice::light_behind_them);
        watched.adviser.forget();
        QCOMPARE(advice(0.48), Advice::more_light);
    }

    void light_behind_and_blur_are_so_bad() {
        const auto fault = [](AimFault which, double brightness, double surroundings, double sharpness) {
            AimFace face = face_at(0.5, 0.45);
            face.brightness = brightness;
            AimFrame frame = frame_of(0.0, {face});
            frame.surroundings = surroundings;
            frame.sharpness = sharpness;
            Watched watched;
            watched.stare(frame);
            return watched.size(which);
        };
        QVERIFY(std::abs(fault(AimFault::light, 0.3, 0.8, 1.0) - 2.0) < 1e-9);
        QVERIFY(fault(AimFault::light, 0.44, 0.95, 1.0) > 2.0);
        QVERIFY(fault(AimFault::light, 0.45, 0.95, 1.0) < 1.0); // light enough before any background
        QVERIFY(std::abs(fault(AimFault::blur, 0.5, 0.5, 0.15) - 2.0) < 1e-9);
    }

    /// How many times its limit a fault is; no more than ten times.
    void each_fault_is_so_bad() {
        const auto size_of_fault = [](AimFault which, const AimFrame& frame, Aim aim = Aim::middle) {
            Watched watched(aim);
            watched.stare(frame);
            return watched.size(which);
        };
        const auto of_face = [](const AimFace& face) { return frame_of(0.0, {face}); };
        const auto is = [](double size, double wanted) { return std::abs(size - wanted) < 1e-5; };
        QVERIFY(is(size_of_fault(AimFault::across, of_face(face_at(0.7, 0.45))), 2.0));
        QVERIFY(is(size_of_fault(AimFault::tilt, of_face(face_at(0.5, 0.45, 0.27, 14.0))), 2.0));
        AimFace shut = face_at(0.5, 0.45);
        shut.eyes_shut = true;
        QVERIFY(is(size_of_fault(AimFault::eyes, of_face(shut)), 1.2));
        AimFrame shaken = of_face(face_at(0.5, 0.45));
        shaken.motion = 0.24;
        QVERIFY(is(size_of_fault(AimFault::blur, shaken), 2.0));
        shaken.motion = 100.0;
        QVERIFY(is(size_of_fault(AimFault::blur, shaken), 10.0));
        // One of two reaches over the left edge by 0.03, which is 0.05 nearer than it may be.
        AimFace left = face_at(0.0, 0.45);
        AimFace right = left;
        left.box.min.x = -0.03;
        right.box.max.x = 0.97;
        right.box.min.x = 0.88;
        QVERIFY(is(size_of_fault(AimFault::across, frame_of(0.0, {left, right}), Aim::everybody), 2.0));
    }
};

} // namespace adviser_faults_test

TP_TEST(adviser_faults_test, AdviserFaultsTest, nothing)
#include "adviser_faults_test.moc"
