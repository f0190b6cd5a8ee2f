// SPDX-License-Identifier: Apache-2.0
#include "lab_bench.hpp"

#include "core/files/whole_file.hpp"
#include "places.hpp"

#include <QDir>
#include <QFile>
#include <QSignalSpy>

#include <cmath>

using namespace tp;

namespace {

constexpr int patience_ms = 60000; ///< on a busy machine

/// A hand so firm that the finger stays beside a line, and nothing but the law acts.
void hold_firmly(LabSession& session) {
    session.setNumber("handStiffness", 1.0, "Grip");
    session.setNumber("lineDamping", 0.0, "Line damping");
    session.setSwitch("energyObserver", false, "Observer");
}

QByteArray content(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

} // namespace

class LabSessionTest : public QObject {
    Q_OBJECT
private slots:
    void the_force_is_what_the_equation_says_for_every_stiffness_and_range() {
        for (const double stiffness : {0.1, 0.2, 0.5})
            for (const double range : {2.0, 4.0, 10.0}) {
                LabBench bench;
                hold_firmly(bench.session);
                bench.session.setNumber("stiffness", stiffness, "K");
                bench.session.setNumber("range", range, "d");
                bench.hand(40.0 + 0.4 * range, 0.0); // outside of the circle of 40 mm
                bench.session.start();
                bench.session.advance(2.0);
                const TracePoint& rest = bench.session.trace().points().back();
                const double distance = std::hypot(rest.x, rest.y) - 40.0;
                const double expected = std::min(1.5, stiffness * std::min(distance, 2.0 * range - distance));
                QVERIFY(distance > 0.1);
                QVERIFY2(std::abs(rest.newtons() - expected) < 0.01 * stiffness * range,
                         qPrintable(QString("%1 N, not %2 N").arg(rest.newtons()).arg(expected)));
                QVERIFY(rest.fx < 0.0);
            }
    }

    void a_changed_stiffness_is_felt_while_it_runs() {
        LabBench bench;
        hold_firmly(bench.session);
        bench.hand(42.0, 0.0);
        bench.session.start();
        bench.session.advance(2.0);
        const double before = bench.session.newtons();
        bench.session.setNumber("stiffness", 0.4, "K");
        QCOMPARE(bench.session.state(), LabSession::Running);
        bench.session.advance(1.0);
        QVERIFY(bench.session.newtons() > 1.5 * before);
        bench.session.undo();
        bench.session.advance(1.0);
        QVERIFY(std::abs(bench.session.newtons() - before) < 0.01);
    }

    void the_strongest_force_holds() {
        LabBench bench;
        hold_firmly(bench.session);
        bench.session.setNumber("maxForce", 0.2, "Strongest force");
        bench.session.setNumber("stiffness", 0.5, "K");
        bench.hand(43.0, 0.0);
        bench.session.start();
        bench.session.advance(2.0);
        QVERIFY(std::abs(bench.session.newtons() - 0.2) < 1e-6);
    }

    void the_laws_differ_at_a_corner_and_the_page_says_where_the_finger_is() {
        LabBench bench;
        bench.session.chooseScene(1);
        bench.session.chooseLaw(1);
        bench.session.setNumber("vertexSpacing", 10.0, "Spacing");
        bench.hand(2.0, 36.0); // beyond the top corner
        bench.session.whereAmI();
        const QString published = bench.last();
        bench.session.chooseLaw(0);
        bench.session.whereAmI();
        QVERIFY(bench.last() != published);
        QVERIFY2(bench.last().startsWith("The finger is 2.0 mm right, 36.0 mm above of the middle."), qPrintable(bench.last()));
        QVERIFY(bench.last().contains("from triangle"));
        bench.hand(100.0, 70.0);
        bench.session.whereAmI();
        QVERIFY(bench.last().endsWith("No line pulls there."));
    }

    void every_number_and_switch_is_kept_told_and_taken_back() {
        LabBench bench;
        for (const LabNumber& number : lab_numbers()) {
            const LabParameters before = bench.session.parameters();
            bench.session.setNumber(number.key, before.*number.member == number.lowest ? number.highest : number.lowest, "It");
            QVERIFY2(!(bench.session.parameters() == before), number.key);
            QVERIFY2(bench.last().startsWith("It: "), qPrintable(bench.last()));
            QCOMPARE(bench.session.values()->value(number.key).toDouble(), bench.session.parameters().*number.member);
            bench.session.undo();
            QVERIFY2(bench.session.parameters() == before, number.key);
        }
        for (const LabSwitch& one : lab_switches()) {
            const LabParameters before = bench.session.parameters();
            bench.session.setSwitch(one.key, !(before.*one.member), "It");
            QVERIFY2(!(bench.session.parameters() == before), one.key);
            bench.session.undo();
            QVERIFY2(bench.session.parameters() == before, one.key);
        }
        bench.session.undo();
        QCOMPARE(bench.last(), QString("There is nothing to take back."));
    }

    void what_is_out_of_bounds_or_unknown_changes_nothing_beyond_them() {
        LabBench bench;
        bench.session.setNumber("stiffness", 40.0, "K");
        QCOMPARE(bench.session.parameters().stiffness, 0.5);
        bench.session.setNumber("stiffness", std::nan(""), "K");
        bench.session.setNumber("colour", 1.0, "?");
        bench.session.setSwitch("colour", true, "?");
        for (const int index : {-1, 99}) {
            bench.session.chooseLaw(index);
            bench.session.chooseScene(index);
            bench.session.chooseDevice(index);
            bench.session.replay(index);
        }
        LabParameters expected;
        expected.stiffness = 0.5;
        QVERIFY(bench.session.parameters() == expected);
        QCOMPARE(bench.session.scene(), 0);
    }

    void hysteresis_and_blending_take_turns() {
        LabBench bench;
        bench.session.setNumber("hold", 0.5, "Hysteresis");
        bench.session.setNumber("blend", 0.3, "Blending");
        QCOMPARE(bench.session.parameters().hold, 0.0);
        bench.session.setNumber("hold", 0.4, "Hysteresis");
        QCOMPARE(bench.session.parameters().blend, 0.0);
        bench.session.undo();
        QCOMPARE(bench.session.parameters().blend, 0.3);
    }

    void the_reset_is_taken_back_as_one_step() {
        LabBench bench;
        bench.session.chooseLaw(1);
        bench.session.setNumber("mass", 0.3, "Mass");
        bench.session.setSwitch("silent", true, "Silent");
        const LabParameters before = bench.session.parameters();
        bench.session.reset();
        QVERIFY(bench.session.parameters() == LabParameters{});
        bench.session.undo();
        QVERIFY(bench.session.parameters() == before);
    }

    void a_device_that_is_heavier_moves_less() {
        const auto way = [](double mass) {
            LabBench bench;
            bench.session.setNumber("mass", mass, "Mass");
            bench.session.setNumber("handStiffness", 0.0, "Grip");
            bench.session.setNumber("handDamping", 0.0, "Hand");
            bench.hand(42.0, 0.0);
            bench.session.start();
            bench.session.advance(0.15);
            return 42.0 - bench.session.trace().points().back().x;
        };
        QVERIFY(way(0.02) > 1.5 * way(0.5));
        QVERIFY(way(0.5) > 0.0);
    }

    void escape_stops_and_the_next_one_is_not_taken() {
        LabBench bench;
        QVERIFY(!bench.session.stop());
        bench.session.start();
        QCOMPARE(bench.session.state(), LabSession::Running);
        QVERIFY(bench.session.stop());
        QCOMPARE(bench.session.state(), LabSession::Stopped);
        QCOMPARE(bench.session.newtons(), 0.0);
        QVERIFY(!bench.session.stop());
        bench.session.start();
        bench.session.leave();
        QCOMPARE(bench.session.state(), LabSession::Stopped);
    }

    void a_fault_is_told_in_the_chains_words_and_a_grave_one_stops() {
        LabBench bench;
        bench.session.start();
        bench.session.advance(1.0);
        bench.session.setSwitch("silent", true, "Silent");
        bench.session.advance(0.5);
        QCOMPARE(bench.last(), QString(sentence(Fault::stale_input)));
        QCOMPARE(bench.session.state(), LabSession::Running);
        bench.session.setSwitch("silent", false, "Silent");
        bench.session.advance(1.0);
        QVERIFY(bench.session.trace().points().size() > 2000);
        bench.session.setSwitch("unplugged", true, "Unplugged");
        bench.session.advance(0.1);
        QCOMPARE(bench.session.state(), LabSession::Stopped);
        QVERIFY(bench.last().contains(sentence(Fault::device_lost)));
        QCOMPARE(bench.session.newtons(), 0.0);
    }

    void a_device_that_hangs_is_seen_in_the_lateness() {
        LabBench bench;
        bench.session.hang();
        QVERIFY(bench.last().startsWith("Only a simulated device"));
        bench.session.start();
        bench.session.advance(0.5);
        bench.session.hang();
        bench.session.advance(0.5);
        const double worst = bench.session.trace().range([](const TracePoint& p) { return p.lateness; }).most;
        QVERIFY(std::abs(worst - 0.2) < 0.002);
        QVERIFY2(bench.session.readings()[LabSession::Lateness].contains("at most 200"),
                 qPrintable(bench.session.readings()[LabSession::Lateness]));
    }

    void the_readings_say_what_the_plots_show() {
        LabBench bench;
        QVERIFY(bench.session.readings()[LabSession::Force].contains("nothing measured yet"));
        hold_firmly(bench.session);
        bench.hand(42.0, 0.0);
        bench.session.start();
        bench.session.advance(2.0);
        const QString newtons = QString::number(bench.session.newtons(), 'f', 2);
        QVERIFY2(bench.session.readings()[LabSession::Force].startsWith("Force |F| now " + newtons + " newtons, at most 0."),
                 qPrintable(bench.session.readings()[LabSession::Force]));
        bench.session.readPlots();
        QVERIFY(bench.last().contains("Position now x ") && bench.last().contains("Energy"));
    }

    void the_table_holds_what_the_trace_holds_and_the_parameters_lie_beside_it() {
        LabBench bench;
        bench.session.writeTable();
        QVERIFY(bench.last().contains("nothing to write yet"));
        bench.session.setNumber("range", 6.0, "Range");
        bench.hand(43.0, 5.0);
        bench.session.start();
        bench.session.advance(0.3);
        bench.session.writeTable();
        const QDir folder(bench.folder.filePath("lab"));
        const QStringList tables = folder.entryList({"*.csv"});
        QCOMPARE(tables.size(), 1);
        QVERIFY2(bench.last().contains(tables[0]) && bench.last().startsWith("300 row"), qPrintable(bench.last()));
        QCOMPARE(content(folder.filePath(tables[0])).toStdString(), bench.session.trace().csv());
        const QString beside = folder.filePath(tables[0].chopped(4) + ".json");
        const Result<LabSetup> setup = parse_setup(content(beside).toStdString());
        QVERIFY(setup.ok());
        QVERIFY(setup->parameters == bench.session.parameters());
        bench.session.writeTable(); // in the same second: another name
        QCOMPARE(folder.entryList({"*.csv"}).size(), 2);
    }

    void a_recording_is_computed_again_to_the_last_bit_and_replayed() {
        for (const int law : {0, 1}) {
            LabBench bench;
            bench.session.chooseScene(1);
            bench.session.chooseLaw(law);
            bench.session.setNumber("stiffness", 0.3, "K");
            bench.session.setNumber("quantum", 0.05, "Quantum");
            bench.session.setNumber("delay", 2.0, "Delay");
            if (law == 0)
                bench.session.setNumber("hold", 0.5, "Hysteresis");
            bench.session.setNumber("drop", 0.1, "Drop");
            bench.hand(-25.0, -14.0);
            bench.session.toggleRecording();
            QVERIFY(bench.session.recording());
            for (int i = 0; i < 40; ++i) {
                bench.session.nudge(1.5, -0.5);
                bench.session.advance(0.05);
            }
            bench.session.setNumber("stiffness", 0.1, "K");
            QVERIFY(bench.last().startsWith("Nothing can be changed during a recording."));
            QCOMPARE(bench.session.parameters().stiffness, 0.3);
            const TracePoint last = bench.session.trace().points().back();
            const std::size_t count = bench.session.trace().points().size();
            QCOMPARE(count, std::size_t{2000});
            bench.session.toggleRecording();
            QVERIFY(!bench.session.recording());
            QCOMPARE(bench.session.recordings().size(), 1);
            QVERIFY2(bench.last().startsWith("Recorded in ") && bench.last().contains(bench.session.recordings()[0]),
                     qPrintable(bench.last()));

            const std::filesystem::path file =
                bench.settings().folder / bench.session.recordings()[0].toStdString();
            const Result<LabReplay> read = read_replay(file);
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().c_str());
            QVERIFY(read->setup.has_value());
            QCOMPARE(read->greatest_difference, 0.0);
            QCOMPARE(read->ticks.size(), count);

            bench.session.reset();
            bench.session.replay(0);
            QTRY_COMPARE_WITH_TIMEOUT(bench.session.state(), LabSession::Replaying, patience_ms);
            bench.session.advance(1.0);
            QCOMPARE(bench.session.state(), LabSession::Replaying);
            QVERIFY(std::abs(bench.session.trace().points().back().time - 1.0) < 0.002);
            bench.session.advance(1.1);
            QCOMPARE(bench.session.state(), LabSession::Stopped);
            QVERIFY2(bench.last().contains("differ by at most 0 newtons"), qPrintable(bench.last()));
            QCOMPARE(bench.session.trace().points().back().x, last.x);
            QCOMPARE(bench.session.trace().points().back().fy, last.fy);
            QCOMPARE(bench.session.trace().points().size(), count);
        }
    }

    void other_parameters_than_the_recorded_ones_differ() {
        LabBench bench;
        bench.hand(42.0, 0.0);
        bench.session.toggleRecording();
        bench.session.advance(1.0);
        bench.session.stop();
        const std::filesystem::path file = bench.settings().folder / bench.session.recordings()[0].toStdString();
        Result<LabSetup> setup = parse_setup(*read_whole(setup_file(file), 1 << 20));
        QVERIFY(setup.ok());
        setup->parameters.stiffness = 0.1;
        QFile beside(QString::fromStdString(setup_file(file).string()));
        QVERIFY(beside.open(QIODevice::WriteOnly));
        beside.write(QByteArray::fromStdString(setup_json(*setup)));
        beside.close();
        const Result<LabReplay> read = read_replay(file);
        QVERIFY(read.ok());
        QVERIFY(read->greatest_difference > 0.05);
        QVERIFY(beside.resize((16 << 20) + 1)); // read it would take thirty times as much memory
        QVERIFY(read_replay(file).error().find("larger than 16 MB") != std::string::npos);
    }

    void a_recording_without_its_parameters_is_played_and_a_spoilt_one_is_told() {
        LabBench bench;
        bench.session.toggleRecording();
        bench.session.advance(0.2);
        bench.session.stop();
        const QString file = bench.folder.filePath("lab/" + bench.session.recordings()[0]);
        QVERIFY(QFile::remove(file.chopped(6) + ".json"));
        bench.session.replay(0);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.state(), LabSession::Replaying, patience_ms);
        QVERIFY(bench.session.stop());
        QFile spoilt(file);
        QVERIFY(spoilt.open(QIODevice::WriteOnly));
        spoilt.write("nothing");
        spoilt.close();
        bench.session.replay(0);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.last().startsWith("lab-"), qPrintable(bench.last()), patience_ms);
        QCOMPARE(bench.session.state(), LabSession::Stopped);
    }

    void a_folder_that_cannot_be_made_is_told_and_nothing_runs() {
        LabBench bench;
        LabSettings settings = bench.settings();
        QFile in_the_way(bench.folder.filePath("file"));
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        settings.folder = bench.folder.filePath("file/lab").toStdString();
        LabSession session(bench.narrator, bench.preferences, settings);
        session.toggleRecording();
        QVERIFY(bench.last().contains("cannot be made"));
        QVERIFY(!session.recording());
        QCOMPARE(session.state(), LabSession::Stopped);
        session.start();
        session.advance(0.1);
        session.writeTable();
        QVERIFY(bench.last().contains("cannot be made"));
    }

    void in_real_time_the_servo_ticks_by_itself_and_what_it_did_is_replayed() {
        LabBench bench;
        LabSettings settings = bench.settings();
        settings.time = nullptr;
        LabSession session(bench.narrator, bench.preferences, settings);
        session.touchDown(0.5 * session.surfaceWidth() + 42.0, 0.5 * session.surfaceHeight());
        // A machine that stands still for 50 ms ends what runs, as it should; then the person begins again.
        const auto runs_until = [&session](const auto& begin, const auto& holds) {
            do {
                begin();
                if (!QTest::qWaitFor([&] { return holds() || session.state() == LabSession::Stopped; }, patience_ms))
                    return false;
            } while (!holds());
            return true;
        };
        QVERIFY(runs_until([&] { session.toggleRecording(); },
                           [&] { return session.trace().points().size() > 300 && session.newtons() > 0.01; }));
        QVERIFY(session.stop());
        QVERIFY(!session.recordings().isEmpty());
        const std::filesystem::path file = settings.folder / session.recordings().first().toStdString();
        const Result<LabReplay> read = read_replay(file);
        QVERIFY(read.ok());
        QVERIFY(read->ticks.size() >= session.trace().points().size());
        session.replay(0);
        QTRY_VERIFY_WITH_TIMEOUT(bench.last().startsWith("The replay has ended. Computed again"), patience_ms);
        QCOMPARE(session.state(), LabSession::Stopped);
        QVERIFY(runs_until(
            [&] {
                session.start();
                session.setNumber("mass", 0.3, "Mass"); // the loop is made anew
                session.setSwitch("silent", true, "Silent");
            },
            [&] { return bench.last() == sentence(Fault::stale_input); }));
        session.setSwitch("unplugged", true, "Unplugged");
        QTRY_COMPARE_WITH_TIMEOUT(session.state(), LabSession::Stopped, patience_ms);
    }

    void devices_are_found_beside_the_page_and_one_that_is_gone_is_told() {
        LabBench bench;
        QCOMPARE(bench.session.devices().size(), 1);
        bench.session.enter();
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.devices().size(), 2, patience_ms);
        QCOMPARE(bench.session.devices()[1], QString("force pad, pad:7"));
        bench.session.chooseDevice(1);
        bench.session.start();
        QCOMPARE(bench.session.state(), LabSession::Opening);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.state(), LabSession::Stopped, patience_ms);
        QVERIFY2(bench.last().startsWith("There is no device \"pad:7\" now."), qPrintable(bench.last()));
    }

    void the_field_is_painted_beside_the_page_and_shows_the_newest_wish() {
        LabBench bench;
        QSignalSpy painted(&bench.session, &LabSession::fieldChanged);
        bench.session.setFieldScale(1.0);
        QTRY_VERIFY_WITH_TIMEOUT(!painted.isEmpty(), patience_ms);
        QCOMPARE(bench.session.field().size(), QSize(220, 160 + bench.session.legendPixels()));
        const QImage circle = bench.session.field();
        painted.clear();
        bench.session.chooseScene(2);
        bench.session.chooseScene(1);
        QTRY_VERIFY_WITH_TIMEOUT(!painted.isEmpty(), patience_ms);
        QTest::qWait(0);
        QCOMPARE(painted.size(), 1);
        QVERIFY(bench.session.field() != circle);
        QVERIFY(bench.session.fieldWords().contains("from 0 to 0.80 newtons"));
        painted.clear();
        bench.session.setFieldScale(2.0); // a coarse one of the same size comes before it
        QTRY_COMPARE_WITH_TIMEOUT(painted.size(), 2, patience_ms);
        QCOMPARE(bench.session.field().size(), QSize(440, 320 + bench.session.legendPixels()));
    }

    void a_photograph_is_felt_and_one_that_cannot_be_is_told() {
        LabBench bench;
        bench.session.chooseScene(3);
        QVERIFY(bench.last().startsWith("There is no photograph yet."));
        bench.session.openPhoto(QUrl("https://example.org/a.jpg"));
        QVERIFY(bench.last().startsWith("Only a photograph that is a file"));
        bench.session.openPhoto(QUrl::fromLocalFile("/nowhere/face.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.last().startsWith("face.jpg: "), patience_ms);
        QCOMPARE(bench.session.scene(), 0);
        bench.session.openPhoto(QUrl::fromLocalFile(tp::test::in_source("resources/samples/anna_smiling.jpg")));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.scene(), 3, 120000);
        QVERIFY2(bench.last().startsWith("anna_smiling.jpg: "), qPrintable(bench.last()));
        QVERIFY(bench.session.flat().lines.size() >= 5);
        QCOMPARE(bench.session.scenes()[3], QString("Photograph anna_smiling.jpg"));
    }
};

QTEST_MAIN(LabSessionTest)
#include "lab_session_test.moc"
