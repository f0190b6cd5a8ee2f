// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/sonar_cue.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

namespace sonar_cue_test {

using namespace tp;

namespace {
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
} // namespace

class SonarCueTest : public QObject {
    Q_OBJECT
private slots:
    void on_the_line_one_soft_steady_tone() {
        for (const double distance : {0.0, 0.5, on_line_mm}) {
            const SonarCue cue = sonar_cue(distance, 1.0, 1.0);
            QVERIFY(cue.steady());
            QCOMPARE(cue.from_hz, level_hz);
            QCOMPARE(cue.gain, line_gain);
            QCOMPARE(cue.side, 0.0);
        }
        QVERIFY(line_gain < far_gain);
    }

    void the_nearer_the_faster_and_the_louder() {
        double interval = shortest_interval_s - 1e-9;
        double gain = beep_gain + 1e-9;
        for (double distance = on_line_mm + 0.1; distance < far_mm; distance += 0.1) {
            const SonarCue cue = sonar_cue(distance, 0.0, 1.0);
            QVERIFY(cue.interval_s > interval);
            QVERIFY(cue.gain < gain);
            interval = cue.interval_s;
            gain = cue.gain;
        }
        QCOMPARE(sonar_cue(far_mm, 0.0, 1.0).interval_s, longest_interval_s);
        QCOMPARE(sonar_cue(500.0, 0.0, 1.0).interval_s, longest_interval_s);
    }

    void the_interval_is_linear_in_the_distance() {
        const double one = sonar_cue(10.0, 1.0, 0.0).interval_s;
        const double two = sonar_cue(20.0, 1.0, 0.0).interval_s;
        const double three = sonar_cue(30.0, 1.0, 0.0).interval_s;
        QVERIFY(std::abs((three - two) - (two - one)) < 1e-12);
    }

    void a_line_above_is_high_and_rises_and_one_below_is_low_and_falls() {
        const SonarCue above = sonar_cue(10.0, 0.0, 3.0);
        const SonarCue beside = sonar_cue(10.0, 3.0, 0.0);
        const SonarCue below = sonar_cue(10.0, 0.0, -3.0);
        QVERIFY(above.to_hz > 1.3 * above.from_hz);
        QVERIFY(below.to_hz < below.from_hz / 1.3);
        QCOMPARE(beside.from_hz, level_hz);
        QCOMPARE(beside.to_hz, level_hz);
        QVERIFY(above.from_hz > level_hz && below.from_hz < level_hz);
    }

    void left_and_right_differ_by_ear_and_by_timbre() {
        const SonarCue left = sonar_cue(10.0, -2.0, 0.0);
        const SonarCue right = sonar_cue(10.0, 2.0, 0.0);
        QCOMPARE(left.side, -1.0);
        QCOMPARE(right.side, 1.0);
        QCOMPARE(left.reed, most_reed);
        QCOMPARE(right.reed, 0.0);
    }

    void every_direction_is_a_cue_of_its_own_and_where_older_ears_hear() {
        QList<SonarCue> heard;
        for (int hour = 0; hour < 12; ++hour) {
            const double turn = 2.0 * std::numbers::pi * hour / 12.0;
            const SonarCue cue = sonar_cue(10.0, std::sin(turn), std::cos(turn));
            for (const double hz : {cue.from_hz, cue.to_hz})
                QVERIFY(hz >= 300.0 && hz <= 3000.0);
            for (const SonarCue& other : heard) // without the ears: one loudspeaker must do
                QVERIFY(std::abs(std::log2(cue.to_hz / other.to_hz)) > 0.05 || std::abs(cue.reed - other.reed) > 0.1);
            heard << cue;
        }
    }

    void it_does_not_depend_on_how_long_the_direction_is() {
        QCOMPARE(sonar_cue(10.0, 0.3, 0.4).to_hz, sonar_cue(10.0, 30.0, 40.0).to_hz);
    }

    void numbers_that_are_none_are_far_away() {
        for (const double distance : {no_number, infinity}) {
            QCOMPARE(sonar_cue(distance, 0.0, 0.0).interval_s, longest_interval_s);
            QCOMPARE(sonar_cue(distance, no_number, 1.0).to_hz, level_hz);
        }
        QVERIFY(sonar_cue(-1.0, 0.0, 0.0).steady());
    }

    void a_tour_is_a_tone_that_is_high_where_the_finger_is_high() {
        QCOMPARE(tour_cue(0.5, 0.0).from_hz, 0.5 * level_hz);
        QCOMPARE(tour_cue(0.5, 0.5).from_hz, level_hz);
        QCOMPARE(tour_cue(0.5, 1.0).from_hz, 2.0 * level_hz);
        QCOMPARE(tour_cue(0.0, 0.5).side, -1.0);
        QCOMPARE(tour_cue(2.0, 0.5).side, 1.0);
        QVERIFY(tour_cue(0.0, 0.5).reed > tour_cue(1.0, 0.5).reed);
        QVERIFY(tour_cue(0.3, 0.3).steady());
        QCOMPARE(tour_cue(no_number, no_number).from_hz, level_hz);
    }
};

} // namespace sonar_cue_test

TP_TEST(sonar_cue_test, SonarCueTest, event_loop)
#include "sonar_cue_test.moc"
