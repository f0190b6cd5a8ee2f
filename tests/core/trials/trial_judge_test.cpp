// SPDX-License-Identifier: Apache-2.0
#include "core/base/chance.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/trials/trial_judge.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>

namespace trial_judge_test {

using namespace tp;

namespace {

StudyTrial trial(const char* path, std::uint64_t seed) {
    const auto experiment = read_experiment(
        "experiment: a\ntask: follow\nlongest trial: 100 s\nfactor range: 2, 4 mm\nset path: " +
        std::string(path) + "\n");
    return trial_of(*experiment, {0, 0, false, seed}).value();
}

/// Goes along the path from one arc to another at 50 mm/s, beside it by `off` to the left.
void go(TrialJudge& judge, const StudyTrial& trial, double from, double to, double off = 0.0) {
    const int steps = static_cast<int>(std::abs(to - from) / 0.5) + 1;
    for (int i = 0; i <= steps; ++i) {
        const double arc = from + (to - from) * i / steps;
        const Vec2 along = point_along(trial.path, arc + 0.01) - point_along(trial.path, arc - 0.01);
        const Vec2 left = Vec2(-along.y, along.x) / length(along);
        judge.feed(judge.time_s() + 0.01, point_along(trial.path, arc) + off * left);
    }
}

} // namespace

class TrialJudgeTest : public QObject {
    Q_OBJECT
private slots:
    void a_finger_exactly_on_the_path_has_no_error_and_passes_all() {
        for (const char* const path : {"circle", "triangle", "curve"})
            for (std::uint64_t seed = 0; seed < 20; ++seed) {
                const StudyTrial one = trial(path, seed);
                TrialJudge judge(one);
                QVERIFY(judge.state() == TrialState::going && !judge.error_mm());
                go(judge, one, 0.0, length_of(one.path));
                QVERIFY(judge.state() == TrialState::done);
                QVERIFY(*judge.error_mm() < 1e-9);
                QCOMPARE(judge.knots_passed(), judge.knots());
            }
    }
    void a_closed_path_may_be_gone_round_the_other_way() {
        for (const char* const path : {"circle", "triangle"}) {
            const StudyTrial one = trial(path, 3);
            TrialJudge judge(one);
            go(judge, one, length_of(one.path), 0.0);
            QVERIFY(judge.state() == TrialState::done);
        }
    }
    void the_error_is_the_mean_distance() {
        const StudyTrial one = trial("circle", 3);
        for (const double off : {-4.0, 2.5}) {
            TrialJudge judge(one);
            go(judge, one, 0.0, length_of(one.path), off);
            QVERIFY(std::abs(*judge.error_mm() - std::abs(off)) < 0.01);
        }
        TrialJudge two(one);
        two.feed(0.0, one.start);
        two.feed(0.1, one.start + 0.1 * (bounds_of(one.path.points).centre() - one.start));
        QVERIFY(std::abs(*two.error_mm() - 2.0) < 0.01);
    }
    void one_that_cuts_a_corner_misses_a_knot() {
        for (const bool corner : {true, false}) {
            const StudyTrial one = trial("triangle", 3);
            const double side = length_of(one.path) / 3.0;
            TrialJudge judge(one);
            go(judge, one, 0.0, side - (corner ? 20.0 : 0.0));
            const Vec2 from = point_along(one.path, side - 20.0), to = point_along(one.path, side + 20.0);
            for (int i = 0; corner && i <= 40; ++i)
                judge.feed(judge.time_s() + 0.01, from + (i / 40.0) * (to - from));
            go(judge, one, side + (corner ? 20.0 : 0.0), 3.0 * side);
            QVERIFY(judge.state() == (corner ? TrialState::missed : TrialState::done));
            QCOMPARE(judge.knots_passed(), corner ? std::size_t{4} : std::size_t{5});
        }
    }
    void one_that_leaves_a_curve_for_a_while_misses_a_knot() {
        const StudyTrial one = trial("curve", 3);
        TrialJudge judge(one);
        go(judge, one, 0.0, 60.0);
        go(judge, one, length_of(one.path) - 60.0, length_of(one.path));
        QVERIFY(judge.state() == TrialState::missed);
        QVERIFY(judge.knots_passed() < judge.knots());
    }
    void going_back_to_the_start_half_way_is_no_end() {
        for (const char* const path : {"circle", "triangle"}) {
            const StudyTrial one = trial(path, 3);
            const double whole = length_of(one.path);
            TrialJudge judge(one);
            go(judge, one, 0.0, 0.45 * whole);
            go(judge, one, 0.45 * whole, 0.0);
            QVERIFY(judge.state() == TrialState::going);
            go(judge, one, 0.0, whole);
            QVERIFY(judge.state() == TrialState::done);
        }
    }
    void standing_at_the_start_is_no_end() {
        const StudyTrial one = trial("circle", 3);
        TrialJudge judge(one);
        for (int i = 0; i < 100; ++i)
            judge.feed(0.01 * i, one.start);
        QVERIFY(judge.state() == TrialState::going);
        QCOMPARE(judge.knots_passed(), std::size_t{0});
    }
    void time_counts_from_the_first_sample_to_the_end() {
        const StudyTrial one = trial("curve", 3);
        TrialJudge judge(one);
        judge.feed(12.0, one.start);
        judge.feed(14.5, one.start);
        QCOMPARE(judge.time_s(), 2.5);
        go(judge, one, 0.0, length_of(one.path));
        const double end = judge.time_s(), error = *judge.error_mm();
        judge.feed(1000.0, Vec2(0.0));
        QCOMPARE(judge.time_s(), end);
        QCOMPARE(*judge.error_mm(), error);
    }
    void the_longest_time_ends_it() {
        const StudyTrial one = trial("circle", 3);
        TrialJudge judge(one);
        judge.feed(5.0, one.start);
        judge.feed(104.9, one.start);
        QVERIFY(judge.state() == TrialState::going);
        judge.feed(105.0, one.start);
        QVERIFY(judge.state() == TrialState::out_of_time);
        QCOMPARE(judge.time_s(), 100.0);
    }
    void what_is_to_be_named_is_judged_by_time_alone() {
        const auto experiment = read_experiment(
            "experiment: a\ntask: name\nanswer: shape\nfactor shape: circle, square\nlongest trial: 3 s\n");
        TrialJudge judge(trial_of(*experiment, {1, 0, false, 1}).value());
        for (int i = 0; i <= 20; ++i)
            judge.feed(0.1 * i, Vec2(0.0));
        QVERIFY(judge.state() == TrialState::going && !judge.error_mm());
        judge.feed(3.0, Vec2(0.0));
        QVERIFY(judge.state() == TrialState::out_of_time);
    }
    void a_place_that_is_none_is_not_counted() {
        const StudyTrial one = trial("circle", 3);
        TrialJudge judge(one);
        judge.feed(0.0, one.start);
        judge.feed(1.0, Vec2(std::numeric_limits<double>::quiet_NaN()));
        QCOMPARE(*judge.error_mm(), distance_to(one.path, one.start));
    }
    void any_way_of_any_finger_is_judged_in_finite_numbers() {
        Chance chance(11);
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const StudyTrial one = trial(seed % 3 == 0   ? "circle"
                                         : seed % 3 == 1 ? "triangle"
                                                         : "curve",
                                         seed);
            TrialJudge judge(one);
            Vec2 finger = one.start;
            double sum = 0.0;
            int samples = 0;
            while (judge.state() == TrialState::going && samples < 3000) {
                finger = glm::clamp(finger + Vec2{chance.between(-9, 9), chance.between(-9, 9)}, Vec2(-100.0),
                                    Vec2(100.0));
                judge.feed(0.01 * samples, finger);
                sum += distance_to(one.path, finger);
                ++samples;
            }
            QVERIFY(std::abs(*judge.error_mm() - sum / samples) < 1e-9);
            QVERIFY(judge.state() != TrialState::done || judge.knots_passed() == judge.knots());
        }
    }
};

} // namespace trial_judge_test

TP_TEST(trial_judge_test, TrialJudgeTest, nothing)
#include "trial_judge_test.moc"
