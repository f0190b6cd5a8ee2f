// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/simulated_trial.hpp"
#include "core/experiment/experiment_file.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cmath>

namespace simulated_trial_test {

using namespace tp;

namespace {

struct Means {
    double error_mm = 0.0, time_s = 0.0;
    int done = 0, all = 0;
};

/// Some people follow a path, each twice.
Means follow(const std::string& path, const std::string& stiffness, const std::string& range,
             const SimulatedBench& bench = {}) {
    const Experiment experiment =
        read_experiment("experiment: a\ntask: follow\nset path: " + path + "\nset stiffness: " + stiffness +
                        "\nset range: " + range + "\nfactor law: exact, published\n")
            .value();
    Means means;
    for (int number = 1; number <= 8; ++number)
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const auto done = simulate_trial(
                *trial_of(experiment, {0, 0, false, 31 * seed + static_cast<std::uint64_t>(number)}),
                person_of(number, 3), bench, seed);
            ++means.all;
            if (done->state != TrialState::done)
                continue;
            ++means.done;
            means.error_mm += *done->error_mm;
            means.time_s += done->time_s;
        }
    means.error_mm /= means.done;
    means.time_s /= means.done;
    return means;
}

} // namespace

/// What the published experiments found must come of the hand and the law alone: these fail where a sign turns.
class SimulatedTrialTest : public QObject {
    Q_OBJECT
private slots:
    void nearly_everybody_comes_to_the_end() {
        for (const char* const path : {"circle", "triangle", "curve"}) {
            const Means means = follow(path, "0.4 N/mm", "8 mm");
            QVERIFY2(means.done >= means.all - 3, path);
            QVERIFY(means.error_mm > 0.3 && means.error_mm < 10.0);
            QVERIFY(means.time_s > 3.0 && means.time_s < 90.0);
        }
    }
    void error_and_time_fall_with_the_stiffness() {
        Means weak, strong;
        for (const char* const path : {"circle", "triangle", "curve"})
            for (const bool is_weak : {true, false}) {
                const Means means = follow(path, is_weak ? "0.1 N/mm" : "0.5 N/mm", "6 mm");
                (is_weak ? weak : strong).error_mm += means.error_mm / 3.0;
                (is_weak ? weak : strong).time_s += means.time_s / 3.0;
            }
        QVERIFY2(weak.error_mm > 1.3 * strong.error_mm,
                 qPrintable(QString("%1 %2").arg(weak.error_mm).arg(strong.error_mm)));
        QVERIFY2(weak.time_s > 1.15 * strong.time_s,
                 qPrintable(QString("%1 %2").arg(weak.time_s).arg(strong.time_s)));
    }
    void time_falls_with_the_range() {
        const Means narrow = follow("circle", "0.3 N/mm", "2 mm"),
                    wide = follow("circle", "0.3 N/mm", "10 mm");
        QVERIFY2(narrow.time_s > 1.3 * wide.time_s,
                 qPrintable(QString("%1 %2").arg(narrow.time_s).arg(wide.time_s)));
    }
    void corners_cost_time() {
        // The triangle is the shorter way: 173 mm against 251.
        QVERIFY(follow("triangle", "0.3 N/mm", "6 mm").time_s >
                1.2 * follow("circle", "0.3 N/mm", "6 mm").time_s);
    }
    void a_force_that_comes_late_is_no_help() {
        SimulatedBench late;
        late.rate_hz = 250.0;
        late.delay_ticks = 16;
        const Means means = follow("circle", "0.3 N/mm", "6 mm", late);
        QVERIFY(means.done > 0);
        QVERIFY(means.error_mm != follow("circle", "0.3 N/mm", "6 mm").error_mm);
    }
    void large_shapes_are_named_rightly() {
        const Experiment experiment =
            read_experiment(
                "experiment: a\ntask: name\nfactor shape: circle, square, hexagon\nset radius: 80 mm\nset "
                "stiffness: 0.5 N/mm\nset range: 10 mm\nanswer: shape\n")
                .value();
        int right = 0, all = 0;
        for (int number = 1; number <= 5; ++number)
            for (std::size_t condition = 0; condition < 3; ++condition) {
                const auto done = simulate_trial(
                    *trial_of(experiment, {condition, 0, false, static_cast<std::uint64_t>(number)}),
                    person_of(number, 3), {}, 9);
                QVERIFY(!done->error_mm && done->state != TrialState::done);
                right += done->answer == experiment.value_of(StudyParameter::shape, condition) ? 1 : 0;
                ++all;
            }
        QVERIFY2(right >= all - 3, qPrintable(QString::number(right)));
    }
    void small_pentagons_and_hexagons_are_worse_than_other_small_shapes() {
        const Experiment experiment =
            read_experiment(
                "experiment: a\ntask: name\nfactor shape: circle, triangle, square, pentagon, hexagon\n"
                "set radius: 20 mm\nset stiffness: 0.5 N/mm\nset range: 10 mm\nset law: published\n"
                "answer: shape\n")
                .value();
        std::array<int, 5> right{};
        constexpr int people = 12;
        for (int number = 1; number <= people; ++number)
            for (std::size_t condition = 0; condition < right.size(); ++condition) {
                const auto done = simulate_trial(
                    *trial_of(experiment, {condition, 0, false, static_cast<std::uint64_t>(number)}),
                    person_of(number, 3), {}, 9);
                right[condition] +=
                    done->answer == experiment.value_of(StudyParameter::shape, condition) ? 1 : 0;
            }
        const auto counts =
            QString("%1 %2 %3 %4 %5").arg(right[0]).arg(right[1]).arg(right[2]).arg(right[3]).arg(right[4]);
        QVERIFY2(right[0] >= 8, qPrintable(counts)); // a small circle is no polygon
        QVERIFY2(right[0] + right[1] + right[2] > 3 * (right[3] + right[4]) / 2 + 3, qPrintable(counts));
    }
    void a_path_has_a_hundred_samples_a_second_and_ends_with_the_trial() {
        const Experiment experiment =
            read_experiment("experiment: a\ntask: follow\nset path: circle\nfactor range: 6, 8 mm\n").value();
        const StudyTrial trial = trial_of(experiment, {0, 0, false, 4}).value();
        const auto done = simulate_trial(trial, Person{}, {}, 1);
        TrialJudge judge(trial);
        for (std::size_t i = 0; i < done->path.size(); ++i) {
            QVERIFY(std::abs(done->path[i].time_s - 0.01 * static_cast<double>(i)) < 1e-6);
            judge.feed(done->path[i].time_s, {done->path[i].x_mm, done->path[i].y_mm});
        }
        QCOMPARE(judge.time_s(), done->time_s);
        QCOMPARE(judge.error_mm(), done->error_mm);
        QVERIFY(judge.state() == done->state);
    }
    void the_time_of_an_answer_is_kept() {
        const Experiment experiment =
            read_experiment("experiment: a\ntask: name\nfactor shape: circle, square\nanswer: "
                            "shape\nlongest trial: 2 s\n")
                .value();
        const auto done = simulate_trial(*trial_of(experiment, {0, 0, false, 4}), Person{}, {}, 1);
        QVERIFY(done->state == TrialState::out_of_time && done->answer.empty());
        QVERIFY(std::abs(done->time_s - 2.0) < 0.011);
    }
    void what_the_law_cannot_is_said() {
        SimulatedBench bench;
        bench.continuity.corner_cue = true;
        const Experiment experiment =
            read_experiment("experiment: a\ntask: follow\nset path: circle\nfactor law: exact, published\n")
                .value();
        QVERIFY(simulate_trial(*trial_of(experiment, {0, 0, false, 4}), Person{}, bench, 1));
        QVERIFY(!simulate_trial(*trial_of(experiment, {1, 0, false, 4}), Person{}, bench, 1));
    }
};

} // namespace simulated_trial_test

TP_TEST(simulated_trial_test, SimulatedTrialTest, nothing)
#include "simulated_trial_test.moc"
