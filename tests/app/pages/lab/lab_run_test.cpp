// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_run.hpp"
#include "lab_parts.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace lab_run_test {

using namespace tp;

namespace {

/// A servo in virtual time.
struct RunBench : LabParts {
    VirtualClock time;
    LabRun run{LabRun::Around{activity, tuning, scene, devices, hand, measurements, teller, preferences, time,
                              true}};
    bool whole = false; ///< the last recording

    RunBench() {
        QObject::connect(&activity, &LabActivity::stopAsked, [this] {
            whole = run.end();
            activity.become(LabActivity::Stopped);
            hand.release();
        });
    }
    void advance(double seconds) {
        QVERIFY(run.run_for(seconds));
        run.poll();
        measurements.renew();
    }
};

/// A hand so firm that the finger stays beside a line, and nothing but the law acts.
void hold_firmly(LabTuning& tuning) {
    tuning.setNumber("handStiffness", 1.0, "Grip");
    tuning.setNumber("lineDamping", 0.0, "Line damping");
    tuning.setSwitch("energyObserver", false, "Observer");
}

} // namespace

class LabRunTest : public QObject {
    Q_OBJECT
private slots:
    void the_force_is_what_the_equation_says_for_every_stiffness_and_range() {
        for (const double stiffness : {0.1, 0.2, 0.5})
            for (const double range : {2.0, 4.0, 10.0}) {
                RunBench bench;
                hold_firmly(bench.tuning);
                bench.tuning.setNumber("stiffness", stiffness, "K");
                bench.tuning.setNumber("range", range, "d");
                bench.touch(40.0 + 0.4 * range, 0.0); // outside of the circle of 40 mm
                bench.run.start();
                bench.advance(2.0);
                const TracePoint& rest = bench.measurements.trace().points().back();
                const double distance = std::hypot(rest.x, rest.y) - 40.0;
                const double expected = std::min(1.5, stiffness * std::min(distance, 2.0 * range - distance));
                QVERIFY(distance > 0.1);
                QVERIFY2(std::abs(rest.newtons() - expected) < 0.01 * stiffness * range,
                         qPrintable(QString("%1 N, not %2 N").arg(rest.newtons()).arg(expected)));
                QVERIFY(rest.fx < 0.0);
            }
    }

    void a_changed_stiffness_is_felt_while_it_runs() {
        RunBench bench;
        hold_firmly(bench.tuning);
        bench.touch(42.0, 0.0);
        bench.run.start();
        bench.advance(2.0);
        const double before = bench.hand.newtons();
        bench.tuning.setNumber("stiffness", 0.4, "K");
        QCOMPARE(bench.activity.state(), LabActivity::Running);
        bench.advance(1.0);
        QVERIFY(bench.hand.newtons() > 1.5 * before);
        bench.tuning.undo();
        bench.advance(1.0);
        QVERIFY(std::abs(bench.hand.newtons() - before) < 0.01);
    }

    void the_strongest_force_holds() {
        RunBench bench;
        hold_firmly(bench.tuning);
        bench.tuning.setNumber("maxForce", 0.2, "Strongest force");
        bench.tuning.setNumber("stiffness", 0.5, "K");
        bench.touch(43.0, 0.0);
        bench.run.start();
        bench.advance(2.0);
        QVERIFY(std::abs(bench.hand.newtons() - 0.2) < 1e-6);
    }

    void a_device_that_is_heavier_moves_less() {
        const auto way = [](double mass) {
            RunBench bench;
            bench.tuning.setNumber("mass", mass, "Mass");
            bench.tuning.setNumber("handStiffness", 0.0, "Grip");
            bench.tuning.setNumber("handDamping", 0.0, "Hand");
            bench.touch(42.0, 0.0);
            bench.run.start();
            bench.advance(0.15);
            return 42.0 - bench.measurements.trace().points().back().x;
        };
        QVERIFY(way(0.02) > 1.5 * way(0.5));
        QVERIFY(way(0.5) > 0.0);
    }

    void a_fault_is_told_in_the_chains_words_and_a_grave_one_stops() {
        RunBench bench;
        bench.run.start();
        bench.advance(1.0);
        bench.tuning.setSwitch("silent", true, "Silent");
        bench.advance(0.5);
        QCOMPARE(bench.last(), QString(sentence(Fault::stale_input)));
        QCOMPARE(bench.activity.state(), LabActivity::Running);
        bench.tuning.setSwitch("silent", false, "Silent");
        bench.advance(1.0);
        QVERIFY(bench.measurements.trace().points().size() > 2000);
        bench.tuning.setSwitch("unplugged", true, "Unplugged");
        bench.advance(0.1);
        QCOMPARE(bench.activity.state(), LabActivity::Stopped);
        QVERIFY(bench.last().contains(sentence(Fault::device_lost)));
        QCOMPARE(bench.hand.newtons(), 0.0);
    }

    void a_device_that_hangs_is_seen_in_the_lateness() {
        RunBench bench;
        bench.run.hang();
        QVERIFY(bench.last().startsWith("Only a simulated device"));
        bench.run.start();
        bench.advance(0.5);
        bench.run.hang();
        bench.advance(0.5);
        const double worst =
            bench.measurements.trace().range([](const TracePoint& p) { return p.lateness; }).most;
        QVERIFY(std::abs(worst - 0.2) < 0.002);
        QVERIFY2(bench.measurements.readings()[LabMeasurements::Lateness].contains("at most 200"),
                 qPrintable(bench.measurements.readings()[LabMeasurements::Lateness]));
    }

    void a_start_while_it_runs_is_none_and_a_turned_parameter_goes_on() {
        RunBench bench;
        QVERIFY(!bench.run.run_for(1.0));
        bench.run.start();
        QVERIFY(bench.last().startsWith("The servo is running: "));
        bench.advance(0.5);
        bench.voice.clear();
        bench.run.start();
        QVERIFY(bench.voice.said().isEmpty());
        bench.tuning.setNumber("mass", 0.3, "Mass"); // device and loop are made anew
        QCOMPARE(bench.activity.state(), LabActivity::Running);
        QCOMPARE(bench.voice.said().size(), 1); // the parameter
        bench.advance(0.1);
        QCOMPARE(bench.measurements.trace().points().size(), 100u);
    }
    void a_recording_is_one_until_it_is_stopped() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("one.touch").toStdString();
        RunBench bench;
        bench.run.record(file);
        QCOMPARE(bench.activity.state(), LabActivity::Recording);
        QVERIFY(bench.last().startsWith("Recording: "));
        bench.advance(0.5);
        bench.activity.stop();
        QVERIFY(bench.whole);
        QVERIFY(std::filesystem::file_size(file) > 500);
    }
    void a_device_that_is_gone_leaves_nothing_running() {
        RunBench bench;
        bench.devices.find();
        QTRY_COMPARE_WITH_TIMEOUT(bench.devices.names().size(), 2, patience_ms);
        bench.devices.choose(1);
        bench.run.start();
        QCOMPARE(bench.activity.state(), LabActivity::Opening);
        QTRY_COMPARE_WITH_TIMEOUT(bench.activity.state(), LabActivity::Stopped, patience_ms);
        QVERIFY2(bench.last().startsWith("There is no device \"pad:7\" now."), qPrintable(bench.last()));
    }
};

} // namespace lab_run_test

TP_TEST(lab_run_test, LabRunTest, window)
#include "lab_run_test.moc"
