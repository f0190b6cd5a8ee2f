// SPDX-License-Identifier: Apache-2.0
#include "core/files/whole_file.hpp"
#include "lab_bench.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QFile>
#include <QSignalSpy>

#include <cmath>

namespace lab_session_test {

using namespace tp;

namespace {

constexpr int patience_ms = 60000; ///< on a busy machine

QByteArray content(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

} // namespace

class LabSessionTest : public QObject {
    Q_OBJECT
private slots:
    void who_enters_is_told_and_devices_are_looked_for() {
        LabBench bench;
        bench.session.enter();
        QVERIFY(bench.last().startsWith("The lab. "));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.devices()->names().size(), 2, patience_ms);
    }

    void escape_stops_and_the_next_one_is_not_taken() {
        LabBench bench;
        for (const int index : {-1, 99})
            bench.session.playback()->replay(index);
        QVERIFY(bench.voice.said().isEmpty());
        QVERIFY(!bench.session.stop());
        bench.session.servo()->start();
        QCOMPARE(bench.session.activity()->state(), LabActivity::Running);
        QVERIFY(bench.session.stop());
        QCOMPARE(bench.session.activity()->state(), LabActivity::Stopped);
        QCOMPARE(bench.session.hand()->newtons(), 0.0);
        QVERIFY(!bench.session.stop());
        bench.session.servo()->start();
        bench.session.leave();
        QCOMPARE(bench.session.activity()->state(), LabActivity::Stopped);
    }

    void the_table_holds_what_the_trace_holds_and_the_parameters_lie_beside_it() {
        LabBench bench;
        bench.session.files()->writeTable();
        QVERIFY(bench.last().contains("nothing to save yet"));
        bench.session.tuning()->setNumber("range", 6.0, "Range");
        bench.hand(43.0, 5.0);
        bench.session.servo()->start();
        bench.session.advance(0.3);
        bench.session.files()->writeTable();
        const QDir folder(bench.folder.filePath("lab"));
        const QStringList tables = folder.entryList({"*.csv"});
        QCOMPARE(tables.size(), 1);
        QVERIFY2(bench.last().contains(tables[0]) && bench.last().startsWith("300 row"), qPrintable(bench.last()));
        QCOMPARE(content(folder.filePath(tables[0])).toStdString(), bench.session.plots()->trace().csv());
        const QString beside = folder.filePath(tables[0].chopped(4) + ".json");
        const Result<LabSetup> setup = parse_setup(content(beside).toStdString());
        QVERIFY(setup.ok());
        QVERIFY(setup->parameters == bench.session.tuning()->parameters());
        bench.session.files()->writeTable(); // in the same second: another name
        QCOMPARE(folder.entryList({"*.csv"}).size(), 2);
    }

    void a_recording_is_computed_again_to_the_last_bit_and_replayed() {
        for (const int law : {0, 1}) {
            LabBench bench;
            bench.session.scene()->choose(1);
            bench.session.tuning()->chooseLaw(law);
            bench.session.tuning()->setNumber("stiffness", 0.3, "K");
            bench.session.tuning()->setNumber("quantum", 0.05, "Quantum");
            bench.session.tuning()->setNumber("delay", 2.0, "Delay");
            if (law == 0)
                bench.session.tuning()->setNumber("hold", 0.5, "Hysteresis");
            bench.session.tuning()->setNumber("drop", 0.1, "Drop");
            bench.hand(-25.0, -14.0);
            bench.session.files()->toggleRecording();
            QVERIFY(bench.session.activity()->recording());
            for (int i = 0; i < 40; ++i) {
                bench.session.hand()->nudge(1.5, -0.5);
                bench.session.advance(0.05);
            }
            bench.session.tuning()->setNumber("stiffness", 0.1, "K");
            QVERIFY(bench.last().startsWith("Nothing can be changed during a recording."));
            QCOMPARE(bench.session.tuning()->parameters().stiffness, 0.3);
            const TracePoint last = bench.session.plots()->trace().points().back();
            const std::size_t count = bench.session.plots()->trace().points().size();
            QCOMPARE(count, std::size_t{2000});
            bench.session.files()->toggleRecording();
            QVERIFY(!bench.session.activity()->recording());
            QCOMPARE(bench.session.files()->recordings().size(), 1);
            QVERIFY2(bench.last().startsWith("Recorded in ") && bench.last().contains(bench.session.files()->recordings()[0]),
                     qPrintable(bench.last()));

            const std::filesystem::path file =
                bench.settings().folder / bench.session.files()->recordings()[0].toStdString();
            const Result<LabReplay> read = read_replay(file);
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().c_str());
            QVERIFY(read->setup.has_value());
            QCOMPARE(read->greatest_difference, 0.0);
            QCOMPARE(read->ticks.size(), count);

            bench.session.tuning()->reset();
            bench.session.playback()->replay(0);
            QTRY_COMPARE_WITH_TIMEOUT(bench.session.activity()->state(), LabActivity::Replaying, patience_ms);
            bench.session.advance(1.0);
            QCOMPARE(bench.session.activity()->state(), LabActivity::Replaying);
            QVERIFY(std::abs(bench.session.plots()->trace().points().back().time - 1.0) < 0.002);
            bench.session.advance(1.1);
            QCOMPARE(bench.session.activity()->state(), LabActivity::Stopped);
            QVERIFY2(bench.last().contains("differ by at most 0 newtons"), qPrintable(bench.last()));
            QCOMPARE(bench.session.plots()->trace().points().back().x, last.x);
            QCOMPARE(bench.session.plots()->trace().points().back().fy, last.fy);
            QCOMPARE(bench.session.plots()->trace().points().size(), count);
        }
    }

    void other_parameters_than_the_recorded_ones_differ() {
        LabBench bench;
        bench.hand(42.0, 0.0);
        bench.session.files()->toggleRecording();
        bench.session.advance(1.0);
        bench.session.stop();
        const std::filesystem::path file = bench.settings().folder / bench.session.files()->recordings()[0].toStdString();
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
        bench.session.files()->toggleRecording();
        bench.session.advance(0.2);
        bench.session.stop();
        const QString file = bench.folder.filePath("lab/" + bench.session.files()->recordings()[0]);
        QVERIFY(QFile::remove(file.chopped(6) + ".json"));
        bench.session.playback()->replay(0);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.activity()->state(), LabActivity::Replaying, patience_ms);
        QVERIFY(bench.session.stop());
        QFile spoilt(file);
        QVERIFY(spoilt.open(QIODevice::WriteOnly));
        spoilt.write("nothing");
        spoilt.close();
        bench.session.playback()->replay(0);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.last().startsWith("lab-"), qPrintable(bench.last()), patience_ms);
        QCOMPARE(bench.session.activity()->state(), LabActivity::Stopped);
    }

    void a_folder_that_cannot_be_made_is_told_and_nothing_runs() {
        LabBench bench;
        LabSettings settings = bench.settings();
        QFile in_the_way(bench.folder.filePath("file"));
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        settings.folder = bench.folder.filePath("file/lab").toStdString();
        LabSession session(bench.narrator, bench.preferences, settings);
        session.files()->toggleRecording();
        QVERIFY(bench.last().contains("cannot be created"));
        QVERIFY(!session.activity()->recording());
        QCOMPARE(session.activity()->state(), LabActivity::Stopped);
        session.servo()->start();
        session.advance(0.1);
        session.files()->writeTable();
        QVERIFY(bench.last().contains("cannot be created"));
    }

    void in_real_time_the_servo_ticks_by_itself_and_what_it_did_is_replayed() {
        LabBench bench;
        LabSettings settings = bench.settings();
        settings.time = nullptr;
        LabSession session(bench.narrator, bench.preferences, settings);
        session.hand()->touchDown(0.5 * session.scene()->surfaceWidth() + 42.0, 0.5 * session.scene()->surfaceHeight());
        // A machine that stands still for 50 ms ends what runs, as it should; then the person begins again.
        const auto runs_until = [&session](const auto& begin, const auto& holds) {
            do {
                begin();
                if (!QTest::qWaitFor([&] { return holds() || session.activity()->state() == LabActivity::Stopped; }, patience_ms))
                    return false;
            } while (!holds());
            return true;
        };
        QVERIFY(runs_until([&] { session.files()->toggleRecording(); },
                           [&] { return session.plots()->trace().points().size() > 300 && session.hand()->newtons() > 0.01; }));
        QVERIFY(session.stop());
        QVERIFY(!session.files()->recordings().isEmpty());
        const std::filesystem::path file = settings.folder / session.files()->recordings().first().toStdString();
        const Result<LabReplay> read = read_replay(file);
        QVERIFY(read.ok());
        QVERIFY(read->ticks.size() >= session.plots()->trace().points().size());
        session.playback()->replay(0);
        QTRY_VERIFY_WITH_TIMEOUT(bench.last().startsWith("The replay has ended. Computed again"), patience_ms);
        QCOMPARE(session.activity()->state(), LabActivity::Stopped);
        QVERIFY(runs_until(
            [&] {
                session.servo()->start();
                session.tuning()->setNumber("mass", 0.3, "Mass"); // the loop is made anew
                session.tuning()->setSwitch("silent", true, "Silent");
            },
            [&] { return bench.last() == sentence(Fault::stale_input); }));
        session.tuning()->setSwitch("unplugged", true, "Unplugged");
        QTRY_COMPARE_WITH_TIMEOUT(session.activity()->state(), LabActivity::Stopped, patience_ms);
    }

};

} // namespace lab_session_test

TP_TEST(lab_session_test, LabSessionTest, window)
#include "lab_session_test.moc"
