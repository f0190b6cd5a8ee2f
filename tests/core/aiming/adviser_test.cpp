// SPDX-License-Identifier: Apache-2.0
#include "frames.hpp"
#include "watched.hpp"

#include <QTest>

#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

using namespace tp;
using namespace tp::testing;

Q_DECLARE_METATYPE(tp::Advice)
Q_DECLARE_METATYPE(tp::Aim)
Q_DECLARE_METATYPE(tp::AimEdge)

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

    /// Boxes at the edges, where the way to go and the edge that cuts are not the same.
    void what_is_cut_says_where_to_go_data() {
        QTest::addColumn<double>("x0");
        QTest::addColumn<double>("y0");
        QTest::addColumn<double>("x1");
        QTest::addColumn<double>("y1");
        QTest::addColumn<Aim>("aim");
        QTest::addColumn<Advice>("advice");
        QTest::addColumn<AimEdge>("cut");
        QTest::addColumn<double>("amount");
        QTest::newRow("lower right") << 0.9 << 0.9 << 1.6 << 1.6 << Aim::middle << Advice::move_right
                                     << AimEdge::right << 0.75;
        QTest::newRow("more at the top")
            << 0.0 << -0.1 << 0.2 << 0.2 << Aim::middle << Advice::move_left << AimEdge::top << 0.4;
        QTest::newRow("wide, over the left")
            << -0.5 << 0.3 << 0.5 << 0.6 << Aim::middle << Advice::move_left << AimEdge::left << 0.52;
        QTest::newRow("tall, over the top")
            << 0.4 << -0.6 << 0.6 << 0.3 << Aim::middle << Advice::move_up << AimEdge::top << 0.62;
        QTest::newRow("right of its third, cut at the left")
            << 0.0 << 0.25 << 0.75 << 0.55 << Aim::thirds << Advice::move_left << AimEdge::left
            << 0.375 - 1.0 / 3.0;
        QTest::newRow("over both sides")
            << -0.01 << 0.27 << 1.0 << 0.63 << Aim::middle << Advice::farther << AimEdge::left << -1.0;
    }
    void what_is_cut_says_where_to_go() {
        QFETCH(double, x0);
        QFETCH(double, y0);
        QFETCH(double, x1);
        QFETCH(double, y1);
        QFETCH(Aim, aim);
        QFETCH(Advice, advice);
        QFETCH(AimEdge, cut);
        QFETCH(double, amount);
        AimFace face;
        face.box = {{x0, y0}, {x1, y1}};
        const AimInstruction said = Watched(aim).stare(face);
        QCOMPARE(said.advice, advice);
        QCOMPARE(said.cut, cut);
        QVERIFY2(amount < 0.0 || std::abs(said.amount - amount) < 1e-9, QByteArray::number(said.amount));
    }

    /// Two of everybody, from the upper edge far down: the camera goes up though their middle is low.
    void a_cut_at_the_top_is_worse_than_a_middle_that_is_low() {
        AimFace high = face_at(0.4, 0.1, 0.2), low = face_at(0.6, 0.85, 0.2);
        QCOMPARE(Watched(Aim::everybody).stare(frame_of(0.0, {high, low})).advice, Advice::move_up);
    }

    /// Where one fault is over another takes its turn at once, and a place comes before a blur that was there first.
    void the_advice_stays_only_with_what_is_still_there_and_of_its_turn() {
        Watched over;
        QCOMPARE(over.stare(face_at(0.605, 0.45)).advice, Advice::move_right);
        QCOMPARE(over.stare(face_at(0.573, 0.45, 0.27, 7.05)).advice, Advice::turn_clockwise);
        Watched blurred;
        AimFrame frame = frame_of(0.0, {face_at(0.5, 0.45)});
        frame.sharpness = 0.2;
        QCOMPARE(blurred.stare(frame).advice, Advice::keep_still);
        frame.faces = {face_at(0.62, 0.45)};
        QCOMPARE(blurred.stare(frame).advice, Advice::move_right);
    }

    void a_turn_is_little_some_or_much() {
        const auto step = [](double tilt) { return Watched().stare(face_at(0.5, 0.45, 0.27, tilt)).step; };
        QCOMPARE(step(7.6), AimStep::little);
        QCOMPARE(step(10.0), AimStep::some);
        QCOMPARE(step(14.0), AimStep::some);
        QCOMPARE(step(16.0), AimStep::much);
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

    void a_tone_halves_what_words_are_needed_for() {
        const auto advice = [](double x, double tilt) {
            Watched watched;
            watched.adviser.with_tone(true);
            return watched.stare(face_at(x, 0.45, 0.27, tilt)).advice;
        };
        QCOMPARE(advice(0.69, 7.2), Advice::turn_clockwise); // 1.9 and 1.03 times their limits
        QCOMPARE(advice(0.72, 7.2), Advice::move_right);
        Watched high;
        high.adviser.with_tone(true);
        QCOMPARE(high.stare(face_at(0.5, 0.45 - 0.12 * 1.9, 0.27, 7.2)).advice, Advice::turn_clockwise);
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
};

QTEST_APPLESS_MAIN(AdviserTest)
#include "adviser_test.moc"
