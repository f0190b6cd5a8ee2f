// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/advice_pace.hpp"

#include <QTest>

#include <limits>
#include <vector>

using namespace tp;

namespace {

AimInstruction one(Advice advice) {
    AimInstruction instruction;
    instruction.advice = advice;
    return instruction;
}

/// Shows the same for `seconds` from `now` on, ten times a second; when it was said.
std::vector<double> shown(AdvicePace& pace, Advice advice, double& now, double seconds,
                          double sentence_s = 1.0, double badness = 2.0) {
    std::vector<double> said;
    double ends = std::numeric_limits<double>::infinity();
    for (const double until = now + seconds; now < until; now += 0.1) {
        if (now >= ends) {
            pace.sentence_ended(now);
            ends = std::numeric_limits<double>::infinity();
        }
        if (pace.say(one(advice), badness, now)) {
            said.push_back(now);
            ends = now + sentence_s;
        }
    }
    if (pace.speaking())
        pace.sentence_ended(now);
    return said;
}

} // namespace

class AdvicePaceTest : public QObject {
    Q_OBJECT
private slots:
    void a_change_is_said_at_once_and_the_same_after_a_pause() {
        AdvicePace pace;
        double now = 0.0;
        const std::vector<double> said = shown(pace, Advice::move_left, now, 7.0);
        QCOMPARE(said.size(), std::size_t{3});
        QVERIFY(said[0] < 0.01);
        QVERIFY(said[1] - said[0] > 1.0 + again_s - 0.01 && said[1] - said[0] < 1.0 + again_s + 0.25);
        now += 0.5;
        const double before = now;
        const std::vector<double> other = shown(pace, Advice::move_up, now, 1.0);
        QCOMPARE(other.size(), std::size_t{1});
        QVERIFY(other[0] - before < 0.11);
    }

    void nothing_is_said_into_a_sentence() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        for (double now = 0.1; now < longest_sentence_s; now += 0.1) {
            QVERIFY(pace.speaking());
            QVERIFY(!pace.say(one(now < 2.0 ? Advice::move_up : Advice::closer), 5.0, now));
        }
    }

    void after_a_sentence_one_breathes() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        pace.sentence_ended(1.0);
        QVERIFY(!pace.say(one(Advice::move_up), 2.0, 1.0 + 0.9 * aim_breath_s));
        QVERIFY(pace.say(one(Advice::move_up), 2.0, 1.0 + 1.01 * aim_breath_s));
    }

    void the_end_of_somebody_elses_sentence_is_no_pause() {
        AdvicePace pace;
        pace.sentence_ended(1.0); // this one said nothing
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 1.0 + 0.5 * aim_breath_s));
    }

    void a_sentence_whose_end_nobody_told_ends() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        QVERIFY(!pace.say(one(Advice::move_up), 2.0, longest_sentence_s));
        QVERIFY(!pace.say(one(Advice::move_up), 2.0, longest_sentence_s + 0.05));
        QVERIFY(!pace.speaking());
        QVERIFY(pace.say(one(Advice::move_up), 2.0, longest_sentence_s + 0.3));
    }

    void what_helps_is_not_said_again() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 4.0, 0.0));
        pace.sentence_ended(1.0);
        double badness = 4.0;
        for (double now = 1.2; now < 6.0; now += 0.1)
            QVERIFY(!pace.say(one(Advice::move_left), badness *= 0.96, now));
    }

    void the_wrong_way_is_answered_soon() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        pace.sentence_ended(1.0);
        QVERIFY(!pace.say(one(Advice::move_left), 3.0, 1.0 + 0.9 * wrong_way_s));
        QVERIFY(pace.say(one(Advice::move_left), 3.0, 1.0 + 1.05 * wrong_way_s));
    }

    void all_is_well_is_said_seldom() {
        AdvicePace pace;
        double now = 0.0;
        QCOMPARE(shown(pace, Advice::ready, now, 6.9).size(), std::size_t{1});
        QCOMPARE(shown(pace, Advice::ready, now, 2.0).size(), std::size_t{1});
    }

    void motion_that_passes_is_not_said() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::ready), 0.0, 0.0));
        pace.sentence_ended(0.5);
        double now = 1.0;
        QCOMPARE(shown(pace, Advice::keep_still, now, 0.6).size(), std::size_t{0});
        QCOMPARE(shown(pace, Advice::ready, now, 0.5).size(), std::size_t{0});
        QCOMPARE(shown(pace, Advice::keep_still, now, 1.2).size(), std::size_t{1});
    }

    void nobody_for_a_moment_is_no_news() {
        AdvicePace pace;
        double now = 0.0;
        QCOMPARE(shown(pace, Advice::look_left, now, 0.25).size(), std::size_t{0});
        QCOMPARE(shown(pace, Advice::look_left, now, 0.5).size(), std::size_t{1});
    }

    void a_clock_set_back_neither_silences_nor_repeats_at_once() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 1000.0));
        pace.sentence_ended(1001.0);
        QVERIFY(!pace.say(one(Advice::move_left), 2.0, 5.0));
        double now = 5.1;
        const std::vector<double> said = shown(pace, Advice::move_left, now, 4.0);
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY(said[0] >= 5.0 + again_s - 0.01);
    }

    void a_time_that_is_none_says_nothing() {
        AdvicePace pace;
        QVERIFY(!pace.say(one(Advice::move_left), 2.0, std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(pace.say(one(Advice::move_left), std::numeric_limits<double>::quiet_NaN(), 0.0));
        pace.sentence_ended(std::numeric_limits<double>::quiet_NaN());
        QVERIFY(!pace.speaking());
        QVERIFY(pace.say(one(Advice::move_up), 2.0, 1.0));
    }

    void forgotten_is_said_anew() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        pace.sentence_ended(1.0);
        pace.forget();
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 1.05));
    }
};

QTEST_APPLESS_MAIN(AdvicePaceTest)
#include "advice_pace_test.moc"
