// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/advice_pace.hpp"

#include <QTest>

#include <limits>
#include <vector>

using namespace tp;

Q_DECLARE_METATYPE(tp::Advice)

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

/// One who was told `advice`, which is `badness` bad, in a sentence that ended at 0.
struct Told {
    explicit Told(Advice advice, double badness = 2.0) : now(one(advice)) {
        pace.say(now, badness, -1.0);
        pace.say(now, badness, 0.0);
        pace.sentence_ended(0.0);
    }
    bool hears(double badness, double at) { return pace.say(now, badness, at); }

    AdvicePace pace;
    AimInstruction now;
};

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
        QVERIFY(said[1] - said[0] > 2.99 && said[1] - said[0] < 3.25);
        now += 0.5;
        const double before = now;
        const std::vector<double> other = shown(pace, Advice::move_up, now, 1.0);
        QCOMPARE(other.size(), std::size_t{1});
        QVERIFY(other[0] - before < 0.11);
    }

    /// For so long an instruction holds before it is said, after such a pause again, and where it became worse.
    void each_is_said_at_its_time_data() {
        QTest::addColumn<Advice>("advice");
        QTest::addColumn<double>("settles");
        QTest::addColumn<double>("again");
        QTest::addColumn<double>("worse");
        const auto row = [](Advice advice, double settles, double again, double worse) {
            QTest::addRow("%d", static_cast<int>(advice)) << advice << settles << again << worse;
        };
        for (const Advice look : {Advice::look_left, Advice::look_right, Advice::look_up, Advice::look_down})
            row(look, 0.3, 2.0, 2.0);
        for (const Advice move : {Advice::move_left, Advice::move_right, Advice::move_up, Advice::move_down})
            row(move, 0.0, 2.0, 0.6);
        for (const Advice lie :
             {Advice::closer, Advice::farther, Advice::turn_clockwise, Advice::turn_anticlockwise})
            row(lie, 0.0, 2.0, 2.0);
        for (const Advice light : {Advice::more_light, Advice::light_behind_them, Advice::eyes_shut})
            row(light, 0.4, 6.0, 6.0);
        row(Advice::keep_still, 0.7, 2.0, 2.0);
        row(Advice::ready, 0.0, 6.0, 6.0);
    }
    void each_is_said_at_its_time() {
        QFETCH(Advice, advice);
        QFETCH(double, settles);
        QFETCH(double, again);
        QFETCH(double, worse);
        constexpr double before = 0.01;
        AdvicePace fresh;
        if (settles > 0.0) {
            QVERIFY(!fresh.say(one(advice), 2.0, 0.0));
            QVERIFY(!fresh.say(one(advice), 2.0, settles - before));
            QVERIFY(!fresh.say(one(advice), 2.0, settles - before)); // a frame that came twice is no news
        }
        QVERIFY(fresh.say(one(advice), 2.0, settles));
        for (const bool is_worse : {false, true}) {
            Told told(advice);
            const double badness = is_worse ? 2.61 : 2.6; // worse by three tenths, or not yet
            const double pause = is_worse ? worse : again;
            QVERIFY(!told.hears(badness, pause - before));
            QVERIFY(told.hears(badness, pause));
        }
    }

    void nothing_is_said_into_a_sentence() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        for (double now = 0.1; now < 6.0; now += 0.1) {
            QVERIFY(pace.speaking());
            QVERIFY(!pace.say(one(now < 2.0 ? Advice::move_up : Advice::closer), 5.0, now));
        }
    }

    void after_a_sentence_one_breathes() {
        for (const double now : {0.14, 0.15}) {
            Told told(Advice::move_left);
            QCOMPARE(told.pace.say(one(Advice::move_up), 2.0, now), now >= 0.15);
        }
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        pace.sentence_ended(1.0);
        QVERIFY(!pace.say(one(Advice::move_up), 2.0, 1.14));
        QVERIFY(pace.say(one(Advice::move_up), 2.0, 1.16));
    }

    /// By seven hundredths at least; then the pause begins with it.
    void what_helped_a_little_is_said_again_later() {
        for (const double badness : {1.84, 1.86}) {
            Told told(Advice::move_left);
            QVERIFY(!told.hears(badness, 1.0));
            QCOMPARE(told.hears(badness, 2.0), badness > 1.85);
        }
    }

    void the_wrong_way_counts_from_the_best_that_was_reached() {
        Told told(Advice::move_left);
        QVERIFY(!told.hears(1.0, 0.3));
        QVERIFY(told.hears(1.4, 0.65));
        Told unmeasured(Advice::move_left);
        QVERIFY(!unmeasured.hears(std::numeric_limits<double>::quiet_NaN(), 0.3)); // as good as it can be
        QVERIFY(unmeasured.hears(1.2, 0.65));
    }

    void the_end_of_somebody_elses_sentence_is_no_pause() {
        AdvicePace pace;
        pace.sentence_ended(1.0); // this one said nothing
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 1.07));
    }

    void a_sentence_whose_end_nobody_told_ends() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 2.0, 0.0));
        QVERIFY(!pace.say(one(Advice::move_up), 2.0, 6.0));
        QVERIFY(pace.speaking());
        QVERIFY(!pace.say(one(Advice::move_up), 2.0, 6.05));
        QVERIFY(!pace.speaking());
        QVERIFY(pace.say(one(Advice::move_up), 2.0, 6.3));
    }

    void what_helps_is_not_said_again() {
        AdvicePace pace;
        QVERIFY(pace.say(one(Advice::move_left), 4.0, 0.0));
        pace.sentence_ended(1.0);
        double badness = 4.0;
        for (double now = 1.2; now < 6.0; now += 0.1)
            QVERIFY(!pace.say(one(Advice::move_left), badness *= 0.96, now));
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
        QVERIFY(said[0] >= 6.99);
        AdvicePace midway;
        QVERIFY(midway.say(one(Advice::move_left), 2.0, 1000.0));
        QVERIFY(
            !midway.say(one(Advice::move_left), 2.0, 5.0)); // a sentence goes on, and ends though nobody told
        QVERIFY(!midway.say(one(Advice::move_left), 2.0, 11.05));
        QVERIFY(!midway.speaking());
    }

    void a_time_that_is_none_says_nothing() {
        AdvicePace pace;
        QVERIFY(!pace.say(one(Advice::move_left), 2.0, std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(pace.say(one(Advice::move_left), std::numeric_limits<double>::quiet_NaN(), 0.0));
        pace.sentence_ended(std::numeric_limits<double>::quiet_NaN());
        QVERIFY(!pace.speaking());
        QVERIFY(!pace.say(one(Advice::move_up), 2.0, 0.1)); // it ended at the last time that was one
        QVERIFY(pace.say(one(Advice::move_up), 2.0, 0.2));
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
