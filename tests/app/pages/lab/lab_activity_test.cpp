// SPDX-License-Identifier: Apache-2.0
#include "lab_parts.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

namespace lab_activity_test {

using namespace tp;

class LabActivityTest : public QObject {
    Q_OBJECT
private slots:
    void what_each_state_means() {
        LabParts bench;
        LabActivity& activity = bench.activity;
        struct Meaning {
            LabActivity::State state;
            bool stopped, opening, running, recording, fixed;
        };
        for (const Meaning& meaning : {Meaning{LabActivity::Opening, false, true, false, false, false},
                                       {LabActivity::Running, false, false, true, false, false},
                                       {LabActivity::OpeningToRecord, false, true, false, true, true},
                                       {LabActivity::Recording, false, false, true, true, true},
                                       {LabActivity::Replaying, false, false, false, false, true},
                                       {LabActivity::Stopped, true, false, false, false, false}}) {
            activity.become(meaning.state);
            QCOMPARE(activity.state(), meaning.state);
            QCOMPARE(activity.stopped(), meaning.stopped);
            QCOMPARE(activity.opening(), meaning.opening);
            QCOMPARE(activity.running(), meaning.running);
            QCOMPARE(activity.recording(), meaning.recording);
            QCOMPARE(activity.fixed(), meaning.fixed);
            bench.voice.clear();
            QCOMPARE(activity.refuses_change(), meaning.fixed);
            QCOMPARE(!bench.voice.said().isEmpty(), meaning.fixed);
        }
    }
    void a_change_is_told_once_and_a_stop_is_asked_for() {
        LabParts bench;
        QSignalSpy changed(&bench.activity, &LabActivity::changed);
        QSignalSpy asked(&bench.activity, &LabActivity::stopAsked);
        bench.activity.become(LabActivity::Running);
        bench.activity.become(LabActivity::Running);
        bench.activity.stop();
        QCOMPARE(changed.size(), 1);
        QCOMPARE(asked.size(), 1);
    }
};

} // namespace lab_activity_test

TP_TEST(lab_activity_test, LabActivityTest, window)
#include "lab_activity_test.moc"
