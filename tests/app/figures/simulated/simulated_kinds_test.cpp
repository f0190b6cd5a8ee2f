// SPDX-License-Identifier: Apache-2.0
// Devices by name as simulated people meet them, and the guided tour to the start.
#include "app/figures/simulated/simulated_kinds.hpp"
#include "core/experiment/experiment_file.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>

namespace simulated_kinds_test {

using namespace tp;

namespace {

StudyTrial circle(const char* stiffness = "0.4 N/mm") {
    const Experiment experiment =
        read_experiment(std::string("experiment: a\ntask: follow\nset path: circle\n"
                                    "set stiffness: ") +
                        stiffness + "\nset range: 6 mm\nfactor law: exact, published\n")
            .value();
    return trial_of(experiment, {0, 0, false, 3}).value();
}

SimulatedTrial done_with(const SimulatedBench& bench, const StudyTrial& trial = circle()) {
    return simulate_trial(trial, person_of(1, 1), bench, 5).value();
}

SimulatedBench bench_of(const SimulatedBody& body) {
    SimulatedBench bench;
    bench.body = body;
    return bench;
}

double strongest(const SimulatedTrial& trial) {
    double most = 0.0;
    for (const FingerSample& sample : trial.path)
        most = std::max(most, length(Vec2(sample.fx_n, sample.fy_n)));
    return most;
}

} // namespace

class SimulatedKindsTest : public QObject {
    Q_OBJECT
private slots:
    void the_numbers_are_those_of_the_back_ends() {
        QCOMPARE(simulated_kinds().size(), std::size_t{5});
        const SimulatedKind pad = simulated_kind("pad").value();
        QVERIFY(std::abs(pad.body.max_force_n - 1.2) < 1e-6 && std::abs(pad.delay_s - 0.001) < 1e-9);
        QVERIFY(std::abs(pad.body.quantum_mm - 0.03) < 1e-9);
        const SimulatedKind falcon = simulated_kind("falcon").value();
        QCOMPARE(falcon.body.mass_kg, 0.2);
        QCOMPARE(falcon.body.coulomb_n, 0.05);
        const SimulatedKind haply = simulated_kind("2diy").value();
        QVERIFY(haply.body.max_force_n > 1.0 && haply.body.continuous_force_n < 1.0);
        QVERIFY(simulated_kind("mouse")->body.drawn && !simulated_kind("stick")->body.drawn);
        QVERIFY(!simulated_kind("joypad"));
    }
    void what_a_body_is_is_felt() {
        const SimulatedTrial usual = done_with({});
        SimulatedBody weak, heavy, rough, coarse, drawn;
        weak.max_force_n = 0.4;
        heavy.mass_kg = 1.0;
        rough.coulomb_n = 0.3;
        coarse.quantum_mm = 1.0;
        drawn.drawn = true;
        for (const SimulatedBody& body : {weak, heavy, rough, coarse, drawn})
            QVERIFY(done_with(bench_of(body)).time_s != usual.time_s);
        QVERIFY(strongest(usual) > 0.5);
        QVERIFY(strongest(done_with(bench_of(weak))) < 0.41);
        for (const FingerSample& sample : done_with(bench_of(coarse)).path)
            QVERIFY(std::abs(sample.x_mm - std::round(sample.x_mm)) < 1e-9);
    }
    void whoever_feels_a_device_comes_round() {
        for (const SimulatedKind& kind : simulated_kinds()) {
            SimulatedBench bench = bench_of(kind.body);
            bench.rate_hz = kind.rate_hz;
            QVERIFY2(done_with(bench).state == TrialState::done, std::string(kind.name).c_str());
        }
    }
    void the_guided_tour_brings_the_finger_near_the_start_before_the_time_begins() {
        SimulatedBench bench;
        bench.led = true;
        const StudyTrial trial = circle();
        const SimulatedTrial led = done_with(bench, trial), set_down = done_with({}, trial);
        QVERIFY2(led.led_s > 1.0 && led.led_s < 30.0, qPrintable(QString::number(led.led_s)));
        QCOMPARE(set_down.led_s, 0.0);
        const FingerSample& first = led.path.front();
        const double off = length(Vec2(first.x_mm, first.y_mm) - trial.start);
        QVERIFY2(off < 10.0 && off > 0.0, qPrintable(QString::number(off)));
        QCOMPARE(first.time_s, 0.0);
        QVERIFY(led.state == TrialState::done);
    }
};

} // namespace simulated_kinds_test

TP_TEST(simulated_kinds_test, SimulatedKindsTest, nothing)
#include "simulated_kinds_test.moc"
