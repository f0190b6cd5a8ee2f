// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/adviser.hpp"
#include "frames.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

using namespace tp;
using namespace tp::testing;

Q_DECLARE_METATYPE(tp::Advice)

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// An adviser with its tracks, shown one frame after the other.
struct Watched {
    explicit Watched(Aim aim = Aim::middle, HeldCamera camera = {}) : adviser(aim, camera) {}
    AimInstruction see(AimFrame frame) {
        frame.time_s = now += 0.1;
        tracks.see(frame);
        return adviser.advise(tracks.faces(), frame);
    }
    AimInstruction see(const AimFace& face) { return see(frame_of(0.0, {face})); }
    /// Until smoothing has settled.
    AimInstruction stare(const AimFrame& frame) {
        AimInstruction last;
        for (int i = 0; i < 15; ++i)
            last = see(frame);
        return last;
    }
    AimInstruction stare(const AimFace& face) { return stare(frame_of(0.0, {face})); }

    FaceTracks tracks;
    Adviser adviser;
    double now = 0.0;
};

} // namespace

class AdviserTest : public QObject {
    Q_OBJECT
private slots:
    void one_fault_is_one_advice_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("tilt");
        QTest::addColumn<Advice>("advice");
        QTest::newRow("at_the_right") << 0.7 << 0.45 << 0.27 << 0.0 << Advice::move_right;
        QTest::newRow("at_the_left") << 0.3 << 0.45 << 0.27 << 0.0 << Advice::move_left;
        QTest::newRow("high") << 0.5 << 0.25 << 0.27 << 0.0 << Advice::move_up;
        QTest::newRow("low") << 0.5 << 0.7 << 0.27 << 0.0 << Advice::move_down;
        QTest::newRow("small") << 0.5 << 0.45 << 0.1 << 0.0 << Advice::closer;
        QTest::newRow("large") << 0.5 << 0.45 << 0.6 << 0.0 << Advice::farther;
        QTest::newRow("turned") << 0.5 << 0.45 << 0.27 << 12.0 << Advice::turn_clockwise;
        QTest::newRow("turned_back") << 0.5 << 0.45 << 0.27 << -12.0 << Advice::turn_anticlockwise;
        QTest::newRow("well") << 0.5 << 0.45 << 0.27 << 0.0 << Advice::ready;
        QTest::newRow("far_to_the_right_and_low") << 0.8 << 0.6 << 0.27 << 0.0 << Advice::move_right;
        QTest::newRow("low_and_a_little_left") << 0.38 << 0.8 << 0.27 << 0.0 << Advice::move_down;
        QTest::newRow("over_all_edges") << 0.6 << 0.5 << 1.3 << 0.0 << Advice::farther;
    }
    void one_fault_is_one_advice() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, height);
        QFETCH(double, tilt);
        QFETCH(Advice, advice);
        Watched back;
        const AimInstruction said = back.stare(face_at(x, y, height, tilt));
        QCOMPARE(said.advice, advice);
        QCOMPARE(said.faces, 1);
        QCOMPARE(back.adviser.good(), advice == Advice::ready);
        QCOMPARE(said.amount > 0.0, advice != Advice::ready);
    }

    void a_front_camera_and_a_mirrored_picture_each_swap_the_sides() {
        for (const bool front : {false, true})
            for (const bool mirrored : {false, true}) {
                const HeldCamera camera{front, mirrored};
                const bool swaps = front != mirrored;
                QCOMPARE(Watched(Aim::middle, camera).stare(face_at(0.75, 0.45)).advice,
                         swaps ? Advice::move_left : Advice::move_right);
                QCOMPARE(Watched(Aim::middle, camera).stare(face_at(0.5, 0.2)).advice, Advice::move_up);
                QCOMPARE(Watched(Aim::middle, camera).stare(face_at(0.5, 0.45, 0.27, 15.0)).advice,
                         swaps ? Advice::turn_anticlockwise : Advice::turn_clockwise);
                QCOMPARE(Watched(Aim::middle, camera).stare(face_at(0.98, 0.45)).cut,
                         swaps ? AimEdge::left : AimEdge::right);
                QCOMPARE(Watched(Aim::middle, camera).stare(face_at(0.02, 0.45)).cut,
                         swaps ? AimEdge::right : AimEdge::left);
            }
        QCOMPARE(Watched().stare(face_at(0.5, 0.05)).cut, AimEdge::top);
        QCOMPARE(Watched().stare(face_at(0.5, 0.95)).cut, AimEdge::bottom);
        QCOMPARE(Watched().stare(face_at(0.5, 0.5)).cut, AimEdge::none);
    }

    void a_face_nearer_to_an_edge_than_a_fiftieth_is_cut() {
        for (const Aim aim : {Aim::middle, Aim::thirds}) {
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
            return back.adviser.faults()[static_cast<std::size_t>(AimFault::blur)];
        };
        QVERIFY(blur({0.16, 0.0}) >= 1.0);
        QVERIFY(blur({0.0, 0.16}) < 1.0);
    }

    void a_turn_is_little_some_or_much() {
        const auto step = [](double tilt) { return Watched().stare(face_at(0.5, 0.45, 0.27, tilt)).step; };
        QCOMPARE(step(7.6), AimStep::little);
        QCOMPARE(step(10.0), AimStep::some);
        QCOMPARE(step(14.0), AimStep::some);
        QCOMPARE(step(16.0), AimStep::much);
    }

    /// A fault begins at 0.22 of brightness and is twice its limit a tenth below.
    void a_face_is_dark_below_its_limit_and_the_darker_the_worse() {
        const auto light = [](double brightness) {
            Watched back;
            AimFace face = face_at(0.5, 0.45);
            face.brightness = brightness;
            back.stare(face);
            return back.adviser.faults()[static_cast<std::size_t>(AimFault::light)];
        };
        QVERIFY(std::abs(light(0.22) - 1.0) < 1e-9);
        QVERIFY(std::abs(light(0.12) - 2.0) < 1e-9);
        QVERIFY(light(0.3) < 1.0);
    }

    void how_much_grows_with_the_fault() {
        const auto step = [](double x, double y = 0.45) { return Watched().stare(face_at(x, y)).step; };
        QCOMPARE(step(0.61), AimStep::little);
        QCOMPARE(step(0.7), AimStep::some);
        QCOMPARE(step(0.8), AimStep::much);
        QCOMPARE(step(0.5, 0.6), AimStep::little);
        QCOMPARE(step(0.5, 0.75), AimStep::some);
        QCOMPARE(step(0.5, 0.92), AimStep::much);
        QCOMPARE(Watched().stare(face_at(0.5, 0.45, 0.14)).step, AimStep::some);
        QCOMPARE(Watched().stare(face_at(0.5, 0.45, 0.09)).step, AimStep::much);
        QCOMPARE(Watched().stare(face_at(0.5, 0.45, 0.52)).step, AimStep::little);
        QVERIFY(std::abs(Watched().stare(face_at(0.7, 0.45)).amount - 0.2) < 1e-3);
        // Of a usual camera, a face of 0.1 is 3 m away, and 1.48 m where it is of a good size.
        QVERIFY(std::abs(Watched().stare(face_at(0.5, 0.45, 0.1)).amount - 1.52) < 0.02);
        QVERIFY(std::abs(Watched().stare(face_at(0.5, 0.45, 0.27, 20.0)).amount - 20.0) < 1e-3);
    }

    void the_moment_counts_last_data() {
        QTest::addColumn<double>("brightness");
        QTest::addColumn<double>("surroundings");
        QTest::addColumn<double>("motion");
        QTest::addColumn<double>("sharpness");
        QTest::addColumn<bool>("shut");
        QTest::addColumn<Advice>("advice");
        QTest::newRow("dark") << 0.15 << 0.2 << 0.0 << 1.0 << false << Advice::more_light;
        QTest::newRow("against_the_light") << 0.3 << 0.8 << 0.0 << 1.0 << false << Advice::light_behind_them;
        QTest::newRow("light_enough_before_white") << 0.5 << 0.95 << 0.0 << 1.0 << false << Advice::ready;
        QTest::newRow("moving") << 0.5 << 0.5 << 0.3 << 1.0 << false << Advice::keep_still;
        QTest::newRow("blurred") << 0.5 << 0.5 << 0.0 << 0.2 << false << Advice::keep_still;
        QTest::newRow("eyes_shut") << 0.5 << 0.5 << 0.0 << 1.0 << true << Advice::eyes_shut;
        QTest::newRow("dark_before_blurred") << 0.15 << 0.2 << 0.3 << 1.0 << true << Advice::more_light;
        QTest::newRow("blurred_before_shut") << 0.5 << 0.5 << 0.3 << 1.0 << true << Advice::keep_still;
        QTest::newRow("nothing_is_a_number")
            << no_number << no_number << no_number << no_number << false << Advice::ready;
    }
    void the_moment_counts_last() {
        QFETCH(double, brightness);
        QFETCH(double, surroundings);
        QFETCH(double, motion);
        QFETCH(double, sharpness);
        QFETCH(bool, shut);
        QFETCH(Advice, advice);
        for (const double x : {0.5, 0.8}) {
            AimFace face = face_at(x, 0.45);
            face.brightness = brightness;
            face.eyes_shut = shut;
            AimFrame frame = frame_of(0.0, {face});
            frame.surroundings = surroundings;
            frame.motion = motion;
            frame.sharpness = sharpness;
            QCOMPARE(Watched().stare(frame).advice, x > 0.6 ? Advice::move_right : advice);
        }
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
        QCOMPARE(Watched().stare(frame).advice, Advice::ready);
        frame.horizon_deg.reset();
        Watched neither;
        QCOMPARE(neither.stare(frame).advice, Advice::ready);
        QCOMPARE(neither.adviser.faults()[static_cast<std::size_t>(AimFault::tilt)], 0.0);
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

    void two_faults_of_one_size_do_not_take_turns() {
        Watched watched;
        watched.stare(face_at(0.72, 0.45 + 0.24));
        std::set<Advice> advices;
        for (int i = 0; i < 100; ++i)
            advices.insert(watched.see(face_at(0.72 + (i % 2) * 0.01, 0.69 - (i % 2) * 0.01)).advice);
        QCOMPARE(advices.size(), std::size_t{1});
        QCOMPARE(watched.stare(face_at(0.61, 0.75)).advice, Advice::move_down);
    }

    void words_say_first_what_a_tone_does_not() {
        const AimFace face = face_at(0.68, 0.45, 0.27, 11.0); // 1.8 and 1.6 times their limits
        QCOMPARE(Watched().stare(face).advice, Advice::move_right);
        Watched with_tone;
        with_tone.adviser.with_tone(true);
        QCOMPARE(with_tone.stare(face).advice, Advice::turn_clockwise);
        QCOMPARE(with_tone.stare(face_at(0.9, 0.45, 0.27, 8.0)).advice, Advice::move_right);
    }

    void a_lost_face_is_looked_for_where_it_went() {
        for (const auto& [x, y, advice] :
             {std::tuple{0.9, 0.5, Advice::look_right}, std::tuple{0.1, 0.5, Advice::look_left},
              std::tuple{0.5, 0.85, Advice::look_down}, std::tuple{0.5, 0.1, Advice::look_up}}) {
            Watched watched;
            watched.stare(face_at(x, y));
            const AimInstruction lost = watched.stare(frame_of(0.0, {}));
            QCOMPARE(lost.advice, advice);
            QCOMPARE(lost.faces, 0);
            QVERIFY(!watched.adviser.good());
        }
        Watched front(Aim::middle, {true, false});
        front.stare(face_at(0.9, 0.5));
        QCOMPARE(front.stare(frame_of(0.0, {})).advice, Advice::look_left);
    }

    void a_lost_face_is_looked_for_five_seconds_long() {
        Watched watched;
        watched.stare(face_at(0.5, 0.85));
        AimInstruction now = watched.see(frame_of(0.0, {}));
        while (now.faces > 0) // it flickers, perhaps
            now = watched.see(frame_of(0.0, {}));
        int frames = 0;
        for (; now.advice == Advice::look_down; ++frames)
            now = watched.see(frame_of(0.0, {}));
        QVERIFY2(frames >= 49 && frames <= 51, QByteArray::number(frames));
        QCOMPARE(now.advice, Advice::look_left); // as everybody is who was never there
    }

    void only_who_was_a_fifth_beside_has_gone_off_that_way() {
        const auto looked_for = [](double x) {
            Watched watched;
            watched.stare(face_at(x, 0.45));
            return watched.stare(frame_of(0.0, {})).advice;
        };
        QCOMPARE(looked_for(0.29), Advice::look_left);
        QCOMPARE(looked_for(0.31), Advice::look_right); // that is how looking for somebody begins
    }

    void who_was_too_large_is_stepped_back_from() {
        Watched watched;
        watched.stare(face_at(0.5, 0.5, 0.8));
        const AimInstruction back = watched.stare(frame_of(0.0, {}));
        QCOMPARE(back.advice, Advice::farther);
        QCOMPARE(back.amount, 0.9); // a step
        QCOMPARE(back.step, AimStep::some);
    }

    void nobody_yet_is_looked_for_upright_and_on_both_sides() {
        AimFrame tipped = frame_of(0.0, {});
        tipped.elevation_deg = -20.0;
        const AimInstruction up = Watched().see(tipped);
        QCOMPARE(up.advice, Advice::move_up);
        QVERIFY(std::abs(up.amount - 20.0 / 37.0) < 1e-9);
        tipped.elevation_deg = 20.0;
        QCOMPARE(Watched().see(tipped).advice, Advice::move_down);
        Watched watched;
        std::set<Advice> advices;
        tipped.elevation_deg = 3.0;
        QCOMPARE(watched.see(tipped).advice, Advice::look_right);
        for (int i = 0; i < 200; ++i)
            advices.insert(watched.see(tipped).advice);
        QCOMPARE(advices,
                 (std::set{Advice::look_left, Advice::look_right, Advice::look_up, Advice::look_down}));
    }

    void looking_goes_one_way_then_the_other_as_long_as_it_says() {
        Watched watched;
        std::vector<std::pair<Advice, int>> ways; // frames each
        for (int i = 0; i < 300; ++i) {
            const Advice advice = watched.see(frame_of(0.0, {})).advice;
            if (ways.empty() || ways.back().first != advice)
                ways.push_back({advice, 0});
            ++ways.back().second;
        }
        const std::vector<std::pair<Advice, double>> wanted{
            {Advice::look_right, 25}, {Advice::look_left, 50}, {Advice::look_right, 25},
            {Advice::look_up, 12.5},  {Advice::look_down, 25}, {Advice::look_up, 12.5},
            {Advice::look_right, 25}, {Advice::look_left, 50}};
        QVERIFY(ways.size() >= wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QCOMPARE(ways[i].first, wanted[i].first);
            QVERIFY2(std::abs(ways[i].second - wanted[i].second) <= 1.5, QByteArray::number(ways[i].second));
        }
    }

    void eight_degrees_are_upright_enough() {
        const auto see = [](double elevation) {
            AimFrame frame = frame_of(0.0, {});
            frame.elevation_deg = elevation;
            return Watched().see(frame);
        };
        QCOMPARE(see(7.9).advice, Advice::look_right);
        QCOMPARE(see(8.1).advice, Advice::move_down);
        QCOMPARE(see(-8.1).advice, Advice::move_up);
        QCOMPARE(see(14.0).step, AimStep::some);
        QCOMPARE(see(15.0).step, AimStep::much);
    }

    void a_tone_halves_what_words_are_needed_for() {
        const auto advice = [](double x, double tilt) {
            Watched watched;
            watched.adviser.with_tone(true);
            return watched.stare(face_at(x, 0.45, 0.27, tilt)).advice;
        };
        QCOMPARE(advice(0.69, 7.2), Advice::turn_clockwise); // 1.9 and 1.03 times their limits
        QCOMPARE(advice(0.72, 7.2), Advice::move_right);
    }

    void the_advice_changes_to_what_is_so_much_worse() {
        const auto advice_then = [](double tilt) {
            Watched watched;
            const Advice first = watched.stare(face_at(0.62, 0.45)).advice; // 1.2 times its limit
            return first != Advice::move_right ? first
                                               : watched.stare(face_at(0.62, 0.45, 0.27, tilt)).advice;
        };
        QCOMPARE(advice_then(11.2), Advice::move_right);     // 1.33 times as bad
        QCOMPARE(advice_then(12.3), Advice::turn_clockwise); // 1.46
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
            return watched.adviser.faults()[static_cast<std::size_t>(which)];
        };
        QVERIFY(std::abs(fault(AimFault::light, 0.3, 0.8, 1.0) - 2.0) < 1e-9);
        QVERIFY(fault(AimFault::light, 0.44, 0.95, 1.0) > 2.0);
        QVERIFY(fault(AimFault::light, 0.46, 0.95, 1.0) < 1.0); // light enough before any background
        QVERIFY(std::abs(fault(AimFault::blur, 0.5, 0.5, 0.15) - 2.0) < 1e-9);
    }

    /// How many times its limit a fault is; no more than ten times.
    void each_fault_is_so_bad() {
        const auto size_of_fault = [](AimFault which, const AimFrame& frame, Aim aim = Aim::middle) {
            Watched watched(aim);
            watched.stare(frame);
            return watched.adviser.faults()[static_cast<std::size_t>(which)];
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

    void for_everybody_a_missing_one_is_stepped_back_for() {
        Watched watched(Aim::everybody);
        watched.adviser.expect(3);
        const AimFrame two = frame_of(0.0, {face_at(0.4, 0.45), face_at(0.6, 0.45)});
        QCOMPARE(watched.stare(two).advice, Advice::farther);
        QCOMPARE(watched.stare(two).amount, 0.4); // half a step, and then one looks again
        QCOMPARE(watched.stare(two).step, AimStep::some);
        QCOMPARE(watched.adviser.badness(), 10.0);
        QCOMPARE(watched.stare(two).faces, 2);
        watched.adviser.expect(2);
        QCOMPARE(watched.stare(two).advice, Advice::ready);
    }

    void whoever_is_known_is_named_in_the_order_in_which_they_came() {
        using Names = std::vector<std::string>;
        for (const Aim aim : {Aim::middle, Aim::everybody}) {
            Watched watched(aim);
            AimFace anna = face_at(0.3, 0.45, 0.2), ben = face_at(0.7, 0.4, 0.3);
            QVERIFY(watched.stare(frame_of(0.0, {anna})).names.empty());
            anna.name = "Anna";
            QCOMPARE(watched.stare(frame_of(0.0, {anna})).names, Names{"Anna"});
            QCOMPARE(watched.stare(frame_of(0.0, {ben, anna})).names, Names{"Anna"});
            ben.name = "Ben";
            const AimInstruction both = watched.stare(frame_of(0.0, {ben, anna}));
            QCOMPARE(both.names, (Names{"Anna", "Ben"})); // though Ben is larger
            QCOMPARE(both.faces, 2);
        }
    }

    void nobody_is_named_twice() {
        AimFace one = face_at(0.3, 0.45), other = face_at(0.7, 0.45);
        one.name = other.name = "Anna";
        const AimInstruction both = Watched(Aim::everybody).stare(frame_of(0.0, {one, other}));
        QCOMPARE(both.names, std::vector<std::string>{"Anna"});
        QCOMPARE(both.faces, 2);
    }

    /// Light behind somebody ends below where it begins, but for one who comes anew.
    void forgotten_light_begins_anew() {
        const auto light = [](double behind) {
            AimFace face = face_at(0.5, 0.45);
            face.brightness = 0.2; // dark before any background
            AimFrame frame = frame_of(0.0, {face});
            frame.surroundings = behind;
            return frame;
        };
        Watched watched;
        QCOMPARE(watched.stare(light(0.7)).advice, Advice::light_behind_them);
        QCOMPARE(watched.stare(light(0.48)).advice, Advice::light_behind_them); // 0.9 times its limit
        watched.adviser.forget();
        QCOMPARE(watched.stare(light(0.48)).advice, Advice::more_light);
    }

    void forgotten_is_as_at_first() {
        Watched watched;
        watched.stare(face_at(0.9, 0.5));
        watched.adviser.forget();
        watched.tracks.forget();
        QVERIFY(!watched.adviser.framing());
        QCOMPARE(watched.see(frame_of(0.0, {})).advice, Advice::look_right);
        QCOMPARE(watched.adviser.badness(), 0.0);
    }
};

QTEST_APPLESS_MAIN(AdviserTest)
#include "adviser_test.moc"
