// SPDX-License-Identifier: Apache-2.0
// Which devices tick and how, and what a tick becomes on each.
#include "device/touch_output/force_feedback/feedback_effect.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <initializer_list>
#include <limits>

namespace feedback_effect_test {

using namespace tp;
using namespace tp::feedback_bit;

namespace {

FeedbackBits bits_of(std::initializer_list<std::size_t> set) {
    FeedbackBits bits;
    for (const std::size_t bit : set)
        bits.set(bit);
    return bits;
}

constexpr std::array kinds{FeedbackKind::motor, FeedbackKind::two_motors, FeedbackKind::sine,
                           FeedbackKind::square};
constexpr std::size_t custom = 0x5d;

} // namespace

class FeedbackEffectTest : public QObject {
    Q_OBJECT
private slots:
    void what_the_kernel_only_pretends_is_a_motor() {
        const FeedbackBits memless = bits_of({rumble, periodic, square, triangle, sine, gain});
        QCOMPARE(feedback_kind(memless, true), FeedbackKind::two_motors);
        QCOMPARE(feedback_kind(memless, false), FeedbackKind::motor);
        QCOMPARE(feedback_kind(bits_of({rumble}), false), FeedbackKind::motor);
        QCOMPARE(feedback_kind(bits_of({rumble, gain}), true), FeedbackKind::two_motors);
    }
    void what_plays_waves_ticks() {
        QCOMPARE(feedback_kind(bits_of({rumble, periodic, sine}), false), FeedbackKind::sine);
        QCOMPARE(feedback_kind(bits_of({rumble, periodic, sine, square, gain}), true), FeedbackKind::sine);
        QCOMPARE(feedback_kind(bits_of({rumble, periodic, square, triangle}), false), FeedbackKind::square);
    }
    void what_may_push_a_hand_is_left_out() {
        for (std::size_t bit = constant; bit <= ramp; ++bit)
            QCOMPARE(feedback_kind(bits_of({rumble, periodic, sine, square, triangle, gain, bit}), true),
                     FeedbackKind::none);
    }
    void what_plays_only_waves_of_its_own_is_left_out() {
        QCOMPARE(feedback_kind(bits_of({rumble, periodic, custom}), false), FeedbackKind::none);
        QCOMPARE(feedback_kind({}, true), FeedbackKind::none);
        QCOMPARE(feedback_kind(bits_of({gain}), true), FeedbackKind::none);
    }

    void each_effect_is_as_strong_as_its_tick_and_ends_by_itself() {
        const double none = std::numeric_limits<double>::quiet_NaN();
        for (const FeedbackKind kind : kinds)
            for (const double amplitude : {0.01, 0.5, 1.0, 7.0, none})
                for (const double sharpness : {-1.0, 0.0, 0.4, 0.5, 1.0, none})
                    for (const double seconds : {0.0001, 0.008, 0.03, 0.05, 3600.0, none}) {
                        const Tick tick(amplitude, sharpness, seconds);
                        const FeedbackEffect effect = feedback_of(tick, kind);
                        if (tick.empty()) {
                            QVERIFY(effect == FeedbackEffect{});
                            continue;
                        }
                        QVERIFY(std::abs(effect.strong + effect.weak - 65535.0 * tick.amplitude()) <= 0.5);
                        const double lasts = std::max(tick.seconds(), shortest_feedback_s(kind));
                        QVERIFY(std::abs(0.001 * effect.length_ms - lasts) <= 0.0005);
                        QVERIFY(effect.length_ms > 0 && effect.length_ms <= 1000.0 * Tick::longest_s);
                        QCOMPARE(effect.period_ms > 0, plays_waves(kind));
                        QVERIFY(effect.period_ms <= effect.length_ms);
                    }
    }

    /// A motor has to get going, and is not felt before.
    void it_is_known_how_late_and_how_short_a_tick_can_be() {
        for (const FeedbackKind kind : kinds) {
            QCOMPARE(feedback_delay_s(kind), plays_waves(kind) ? 0.01 : 0.03);
            QCOMPARE(shortest_feedback_s(kind), plays_waves(kind) ? 0.008 : 0.04);
        }
    }

    void of_two_motors_the_fast_one_is_sharp() {
        const FeedbackEffect sharp = feedback_of(Tick(1.0, 0.7, 0.01), FeedbackKind::two_motors);
        QCOMPARE(sharp.weak, std::uint16_t(65535));
        QCOMPARE(sharp.strong, std::uint16_t(0));
        const FeedbackEffect soft = feedback_of(Tick(1.0, 0.2, 0.01), FeedbackKind::two_motors);
        QCOMPARE(soft.strong, std::uint16_t(65535));
        QCOMPARE(soft.weak, std::uint16_t(0));
        QCOMPARE(feedback_of(Tick(1.0, 1.0, 0.01), FeedbackKind::motor).strong, std::uint16_t(65535));
    }
    void a_sharper_tick_is_a_higher_wave() {
        for (const FeedbackKind kind : {FeedbackKind::sine, FeedbackKind::square}) {
            QCOMPARE(feedback_of(Tick(1.0, 0.0, 0.05), kind).period_ms, std::uint16_t(8));
            QCOMPARE(feedback_of(Tick(1.0, 0.5, 0.05), kind).period_ms, std::uint16_t(6));
            QCOMPARE(feedback_of(Tick(1.0, 1.0, 0.05), kind).period_ms, std::uint16_t(4));
        }
    }
    void a_word_keeps_an_effect() {
        const FeedbackEffect effect{0x1234, 0xFEDC, 8, 50};
        QVERIFY(unpacked_feedback(packed(effect)) == effect);
        QCOMPARE(packed({}), std::uint64_t(0));
        QVERIFY(packed({0, 0, 0, 1}) != 0);
    }
};

} // namespace feedback_effect_test

TP_TEST(feedback_effect_test, FeedbackEffectTest, nothing)
#include "feedback_effect_test.moc"
