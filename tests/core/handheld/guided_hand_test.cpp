// SPDX-License-Identifier: Apache-2.0
#include "core/handheld/guided_hand.hpp"

#include <QTest>

#include <cmath>
#include <cstdint>

using namespace tp;

Q_DECLARE_METATYPE(tp::Advice)

namespace {

/// A hand that errs in nothing.
HandManner exact() {
    HandManner manner;
    manner.spread = manner.wrong_side = manner.wrong_height = 0.0;
    manner.tone_wrong_side = manner.tone_wrong_height = manner.tone_spread = 0.0;
    return manner;
}

void run(GuidedHand& hand, double seconds) {
    for (double passed = 0.0; passed < seconds - 1e-9; passed += 0.01)
        hand.step(0.01);
}

AimInstruction one(Advice advice, AimStep step = AimStep::some) {
    AimInstruction instruction;
    instruction.advice = advice;
    instruction.step = step;
    return instruction;
}

AimTone beats(double side, double pitch_octaves, double rate = 5.0) {
    AimTone tone;
    tone.sounds = true;
    tone.side = side;
    tone.pitch_octaves = pitch_octaves;
    tone.beats_per_s = rate;
    return tone;
}

} // namespace

class GuidedHandTest : public QObject {
    Q_OBJECT
private slots:
    void it_does_what_it_hears_data() {
        QTest::addColumn<Advice>("advice");
        QTest::addColumn<double>("pan");
        QTest::addColumn<double>("tilt");
        QTest::addColumn<double>("roll");
        QTest::addColumn<double>("forward");
        QTest::newRow("left") << Advice::move_left << -10.0 << 0.0 << 0.0 << 0.0;
        QTest::newRow("right") << Advice::move_right << 10.0 << 0.0 << 0.0 << 0.0;
        QTest::newRow("up") << Advice::move_up << 0.0 << 10.0 << 0.0 << 0.0;
        QTest::newRow("down") << Advice::move_down << 0.0 << -10.0 << 0.0 << 0.0;
        QTest::newRow("clockwise") << Advice::turn_clockwise << 0.0 << 0.0 << 10.0 << 0.0;
        QTest::newRow("anticlockwise") << Advice::turn_anticlockwise << 0.0 << 0.0 << -10.0 << 0.0;
        QTest::newRow("closer") << Advice::closer << 0.0 << 0.0 << 0.0 << 0.6;
        QTest::newRow("farther") << Advice::farther << 0.0 << 0.0 << 0.0 << -0.6;
        QTest::newRow("still") << Advice::ready << 0.0 << 0.0 << 0.0 << 0.0;
    }
    void it_does_what_it_hears() {
        QFETCH(Advice, advice);
        QFETCH(double, pan);
        QFETCH(double, tilt);
        QFETCH(double, roll);
        QFETCH(double, forward);
        for (const bool front : {false, true}) {
            GuidedHand hand(exact(), {}, front, 1);
            hand.hear_words(one(advice), 0.0);
            run(hand, 6.0);
            const double side = front ? -1.0 : 1.0; // the holder's right is the front camera's left
            QVERIFY(std::abs(hand.pose().pan_deg - side * pan) < 1e-6);
            QVERIFY(std::abs(hand.pose().roll_deg - side * roll) < 1e-6);
            QVERIFY(std::abs(hand.pose().tilt_deg - tilt) < 1e-6);
            QVERIFY(std::abs(hand.pose().forward_m - forward) < 1e-6);
        }
    }

    void it_waits_for_the_end_of_the_sentence_and_reacts() {
        GuidedHand hand(exact(), {}, false, 1);
        const double ends = hand.hear_words(one(Advice::move_right), 0.0);
        QVERIFY(std::abs(ends - (0.15 + 60.0 * 2 / 175.0)) < 1e-9);
        run(hand, ends + 0.29);
        QCOMPARE(hand.pose().pan_deg, 0.0);
        run(hand, 0.6);
        QVERIFY(hand.pose().pan_deg > 0.1);
    }

    void how_far_is_what_was_said() {
        const auto moved = [](AimStep step) {
            GuidedHand hand(exact(), {}, false, 1);
            hand.hear_words(one(Advice::move_right, step), 0.0);
            run(hand, 6.0);
            return hand.pose().pan_deg;
        };
        QVERIFY(std::abs(moved(AimStep::little) - 5.0) < 1e-6);
        QVERIFY(std::abs(moved(AimStep::much) - 20.0) < 1e-6);
    }

    void a_new_sentence_ends_a_look_round() {
        GuidedHand hand(exact(), {}, false, 1);
        hand.hear_words(one(Advice::look_right), 0.0);
        run(hand, 3.0);
        const double ends = hand.hear_words(one(Advice::ready), hand.now_s());
        run(hand, ends + 0.7 - 3.0);
        const double stopped = hand.pose().pan_deg;
        QVERIFY(stopped > 1.0 && stopped < 60.0);
        run(hand, 3.0);
        QCOMPARE(hand.pose().pan_deg, stopped);
    }

    void a_tone_leads_and_stops() {
        GuidedHand hand(exact(), {}, false, 1);
        hand.hear_tone(beats(1.0, 0.0), 0.0);
        run(hand, 0.29);
        QCOMPARE(hand.pose().pan_deg, 0.0); // not before it has reacted
        run(hand, 1.5);
        QVERIFY(hand.pose().pan_deg > 1.0);
        AimTone there;
        there.sounds = true;
        hand.hear_tone(there, hand.now_s());
        run(hand, 0.61);
        const double stopped = hand.pose().pan_deg;
        run(hand, 3.0);
        QCOMPARE(hand.pose().pan_deg, stopped);
        GuidedHand other(exact(), {}, false, 1);
        other.hear_tone(beats(0.0, 0.5), 0.0);
        run(other, 1.8);
        QVERIFY(other.pose().tilt_deg > 1.0);
        QCOMPARE(other.pose().pan_deg, 0.0);
    }

    void a_tone_on_the_other_side_ends_a_turn() {
        GuidedHand hand(exact(), {}, false, 1);
        hand.hear_words(one(Advice::move_right, AimStep::much), 0.0);
        run(hand, 1.5);
        hand.hear_tone(beats(-1.0, 0.0), hand.now_s());
        run(hand, 3.0);
        QVERIFY(hand.pose().pan_deg < 15.0);
    }

    void nothing_heard_is_aimed_at_the_voice() {
        GuidedHand hand(exact(), {.pan_deg = 80.0}, false, 1);
        run(hand, 2.5);
        QCOMPARE(hand.pose().pan_deg, 80.0);
        run(hand, 6.0);
        QVERIFY(std::abs(hand.pose().pan_deg) < 60.0);
    }

    void sides_are_confused_as_often_as_assumed() {
        int wrong = 0;
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            GuidedHand hand(HandManner{}, {}, false, seed);
            hand.hear_words(one(Advice::move_right), 0.0);
            run(hand, 3.0);
            wrong += hand.pose().pan_deg < 0.0 ? 1 : 0;
        }
        QVERIFY(std::abs(wrong / 2000.0 - HandManner{}.wrong_side) < 0.02);
    }
};

QTEST_APPLESS_MAIN(GuidedHandTest)
#include "guided_hand_test.moc"
