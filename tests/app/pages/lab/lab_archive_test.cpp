// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_replay.hpp"
#include "app/pages/lab/lab_setup.hpp"
#include "core/files/whole_file.hpp"
#include "lab_folder.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include <filesystem>

namespace lab_archive_test {

using namespace tp;

class LabArchiveTest : public QObject {
    Q_OBJECT
private slots:
    void a_recording_has_its_setup_beside_it_and_is_told() {
        LabFolder lab;
        QVERIFY(lab.archive.recordings().isEmpty());
        QVERIFY(!std::filesystem::exists(lab.place));
        QSignalSpy changed(&lab.archive, &LabArchive::changed);
        lab.archive.toggleRecording();
        QCOMPARE(lab.activity.state(), LabActivity::Recording);
        lab.advance(0.1);
        lab.archive.toggleRecording();
        QCOMPARE(lab.activity.state(), LabActivity::Stopped);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(lab.archive.recordings().size(), 1);
        const QString name = lab.archive.recordings().front();
        QVERIFY2(lab.last().startsWith("Recorded in ") && lab.last().contains(name), qPrintable(lab.last()));
        QCOMPARE(lab.files("*.json"), QStringList(QString(name).replace(".touch", ".json")));
        const auto setup = read_whole(setup_file(lab.archive.recording(name)), 1 << 20);
        QVERIFY(setup.ok() && parse_setup(*setup).ok());
    }

    void none_takes_the_name_of_another() {
        LabFolder lab;
        for (int i = 0; i < 3; ++i)
            lab.record(0.01);
        QCOMPARE(lab.archive.recordings().size(), 3);
        QCOMPARE(lab.files("*.json").size(), 3);
    }

    void one_that_is_not_whole_is_said_to_be_so() {
        LabFolder lab;
        QVERIFY(lab.archive.finish(false).startsWith("The recording is not whole"));
    }

    void a_table_has_a_row_for_each_tick_and_its_setup() {
        LabFolder lab;
        lab.archive.writeTable();
        QVERIFY(lab.last().startsWith("There is nothing to save yet."));
        QVERIFY(!std::filesystem::exists(lab.place));
        lab.run.start();
        lab.advance(0.1);
        lab.archive.writeTable();
        QCOMPARE(lab.activity.state(), LabActivity::Running);
        QVERIFY2(lab.last().startsWith("100 row(s) are in "), qPrintable(lab.last()));
        QCOMPARE(lab.files("*.csv").size(), 1);
        QCOMPARE(lab.files("*.json").size(), 1);
        const auto table = read_whole(lab.place / lab.files("*.csv").front().toStdString(), 1 << 20);
        QVERIFY(table.ok());
        QCOMPARE(*table, lab.measurements.trace().csv());
        QVERIFY(lab.archive.recordings().isEmpty());
    }

    void a_folder_that_cannot_be_made_leaves_nothing_running() {
        LabFolder lab;
        QFile in_the_way(QString::fromStdString(lab.place.string()));
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        lab.archive.toggleRecording();
        QCOMPARE(lab.activity.state(), LabActivity::Stopped);
        QVERIFY2(lab.last().contains("cannot be created"), qPrintable(lab.last()));
        lab.run.start();
        lab.advance(0.01);
        lab.archive.writeTable();
        QVERIFY2(lab.last().contains("cannot be created"), qPrintable(lab.last()));
    }

    void what_runs_ends_before_a_recording_begins() {
        LabFolder lab;
        lab.run.start();
        lab.advance(0.05);
        lab.archive.toggleRecording();
        QCOMPARE(lab.activity.state(), LabActivity::Recording);
        QVERIFY(lab.measurements.trace().points().empty());
    }
};

} // namespace lab_archive_test

TP_TEST(lab_archive_test, LabArchiveTest, window)
#include "lab_archive_test.moc"
