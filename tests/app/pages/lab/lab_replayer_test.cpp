// SPDX-License-Identifier: Apache-2.0
#include "lab_folder.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTest>

#include <cstddef>
#include <filesystem>

namespace lab_replayer_test {

using namespace tp;

namespace {

/// Half a second beside the circle, then the hand elsewhere.
void record_beside_the_circle(LabFolder& lab) {
    lab.touch(42.0, 0.0);
    lab.record(0.5);
    lab.touch(-20.0, 10.0);
}

} // namespace

class LabReplayerTest : public QObject {
    Q_OBJECT
private slots:
    void a_recording_is_shown_at_its_own_pace_and_its_end_is_told() {
        LabFolder lab;
        record_beside_the_circle(lab);
        lab.replayer.replay(0);
        QVERIFY(lab.last().startsWith("Reading "));
        QTRY_COMPARE_WITH_TIMEOUT(lab.activity.state(), LabActivity::Replaying, patience_ms);
        QVERIFY2(lab.last().startsWith("Replaying "), qPrintable(lab.last()));
        lab.advance(0.25);
        const std::size_t half = lab.measurements.trace().points().size();
        QVERIFY2(half >= 249 && half <= 252, qPrintable(QString::number(half)));
        QVERIFY(lab.hand.pointer().x() > 145.0); // where the recorded hand was: 42 mm right of the middle
        lab.advance(0.1);
        QVERIFY(lab.measurements.trace().points().size() > half);
        QCOMPARE(lab.activity.state(), LabActivity::Replaying);
        lab.advance(0.2);
        QCOMPARE(lab.activity.state(), LabActivity::Stopped);
        QCOMPARE(lab.measurements.trace().points().size(), 500u);
        QVERIFY2(
            lab.last().startsWith("The replay has ended. Computed again, the forces differ by at most 0 "),
            qPrintable(lab.last()));
    }

    void a_stop_ends_it_and_no_more_is_shown() {
        LabFolder lab;
        record_beside_the_circle(lab);
        lab.replayer.replay(0);
        QTRY_COMPARE_WITH_TIMEOUT(lab.activity.state(), LabActivity::Replaying, patience_ms);
        lab.advance(0.1);
        lab.activity.stop();
        const std::size_t shown = lab.measurements.trace().points().size();
        lab.advance(1.0);
        QCOMPARE(lab.measurements.trace().points().size(), shown);
        QVERIFY(!lab.last().startsWith("The replay has ended."));
    }

    void one_that_is_being_read_is_not_played_after_another_is_asked_for() {
        LabFolder lab;
        record_beside_the_circle(lab);
        const QString longer = lab.archive.recordings().front();
        lab.record(0.1);
        const int other = lab.archive.recordings().indexOf(longer) == 0 ? 1 : 0;
        lab.replayer.replay(1 - other);
        lab.replayer.replay(other);
        QTRY_COMPARE_WITH_TIMEOUT(lab.activity.state(), LabActivity::Replaying, patience_ms);
        QVERIFY(lab.last().contains(lab.archive.recordings()[other]));
        lab.advance(0.2);
        QCOMPARE(lab.activity.state(), LabActivity::Stopped);
        QCOMPARE(lab.measurements.trace().points().size(), 100u);
    }

    void a_recording_that_is_not_there_is_not_read() {
        LabFolder lab;
        record_beside_the_circle(lab);
        lab.voice.clear();
        lab.replayer.replay(-1);
        lab.replayer.replay(1);
        QVERIFY(lab.voice.said().isEmpty());
        QCOMPARE(lab.activity.state(), LabActivity::Stopped);
    }

    void a_spoilt_one_is_told_and_leaves_the_lab_as_it_was() {
        LabFolder lab;
        record_beside_the_circle(lab);
        const QString file =
            QString::fromStdString(lab.archive.recording(lab.archive.recordings().front()).string());
        QVERIFY(QFile::resize(file, 3));
        lab.replayer.replay(0);
        QTRY_VERIFY_WITH_TIMEOUT(lab.last().startsWith(lab.archive.recordings().front() + ": "), patience_ms);
        QCOMPARE(lab.activity.state(), LabActivity::Stopped);
    }

    void one_without_its_parameters_is_played_and_not_computed_again() {
        LabFolder lab;
        record_beside_the_circle(lab);
        QVERIFY(std::filesystem::remove(setup_file(lab.archive.recording(lab.archive.recordings().front()))));
        lab.replayer.replay(0);
        QTRY_COMPARE_WITH_TIMEOUT(lab.activity.state(), LabActivity::Replaying, patience_ms);
        lab.advance(1.0);
        QVERIFY2(lab.last().startsWith("The replay has ended. Its parameters are not beside it"),
                 qPrintable(lab.last()));
    }
};

} // namespace lab_replayer_test

TP_TEST(lab_replayer_test, LabReplayerTest, window)
#include "lab_replayer_test.moc"
