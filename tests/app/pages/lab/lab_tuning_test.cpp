// SPDX-License-Identifier: Apache-2.0
#include "lab_parts.hpp"
#include "test_program.hpp"

#include <QList>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace lab_tuning_test {

using namespace tp;

class LabTuningTest : public QObject {
    Q_OBJECT
private slots:
    void every_number_and_switch_is_kept_told_and_taken_back() {
        LabParts bench;
        for (const LabNumber& number : lab_numbers()) {
            const LabParameters before = bench.tuning.parameters();
            bench.tuning.setNumber(
                number.key, before.*number.member == number.lowest ? number.highest : number.lowest, "It");
            QVERIFY2(!(bench.tuning.parameters() == before), number.key);
            QVERIFY2(bench.last().startsWith("It: "), qPrintable(bench.last()));
            QCOMPARE(bench.tuning.values()->value(number.key).toDouble(),
                     bench.tuning.parameters().*number.member);
            bench.tuning.undo();
            QVERIFY2(bench.tuning.parameters() == before, number.key);
        }
        for (const LabSwitch& one : lab_switches()) {
            const LabParameters before = bench.tuning.parameters();
            bench.tuning.setSwitch(one.key, !(before.*one.member), "It");
            QVERIFY2(!(bench.tuning.parameters() == before), one.key);
            bench.tuning.undo();
            QVERIFY2(bench.tuning.parameters() == before, one.key);
        }
        bench.tuning.undo();
        QCOMPARE(bench.last(), QString("There is nothing to undo."));
    }

    void hysteresis_and_blending_take_turns() {
        LabParts bench;
        bench.tuning.setNumber("hold", 0.5, "Hysteresis");
        bench.tuning.setNumber("blend", 0.3, "Blending");
        QCOMPARE(bench.tuning.parameters().hold, 0.0);
        bench.tuning.setNumber("hold", 0.4, "Hysteresis");
        QCOMPARE(bench.tuning.parameters().blend, 0.0);
        bench.tuning.undo();
        QCOMPARE(bench.tuning.parameters().blend, 0.3);
    }

    void the_reset_is_taken_back_as_one_step() {
        LabParts bench;
        bench.tuning.chooseLaw(1);
        bench.tuning.setNumber("mass", 0.3, "Mass");
        bench.tuning.setSwitch("silent", true, "Silent");
        const LabParameters before = bench.tuning.parameters();
        bench.tuning.reset();
        QVERIFY(bench.tuning.parameters() == LabParameters{});
        bench.tuning.undo();
        QVERIFY(bench.tuning.parameters() == before);
    }

    void what_is_out_of_bounds_or_unknown_changes_nothing_beyond_them() {
        LabParts bench;
        bench.tuning.setNumber("stiffness", 40.0, "K");
        bench.tuning.setNumber("stiffness", std::nan(""), "K");
        bench.tuning.setNumber("colour", 1.0, "?");
        bench.tuning.setSwitch("colour", true, "?");
        for (const int index : {-1, 99})
            bench.tuning.chooseLaw(index);
        LabParameters expected;
        expected.stiffness = 0.5;
        QVERIFY(bench.tuning.parameters() == expected);
    }
    void a_slider_that_is_moved_on_is_one_step() {
        LabParts bench;
        for (const double stiffness : {0.3, 0.35, 0.4})
            bench.tuning.setNumber("stiffness", stiffness, "K");
        bench.tuning.undo();
        QVERIFY(bench.tuning.parameters() == LabParameters{});
        QVERIFY(bench.tuning.undoable().isEmpty());
    }
    void what_must_be_done_for_a_change_is_told() {
        LabParts bench;
        QSignalSpy scene(&bench.tuning, &LabTuning::sceneTurned);
        QSignalSpy turned(&bench.tuning, &LabTuning::turned);
        bench.tuning.setNumber("stiffness", 0.3, "K");
        bench.tuning.chooseLaw(1);
        QCOMPARE(scene.size(), 2);
        bench.tuning.setNumber("mass", 0.3, "Mass");
        bench.tuning.setSwitch("silent", true, "Silent");
        bench.tuning.setSwitch("silent", true, "Silent"); // the same again is no change
        QCOMPARE(scene.size(), 2);
        QList<bool> anew;
        for (qsizetype i = 0; i < turned.size(); ++i)
            anew << turned[i][0].toBool();
        QCOMPARE(anew, QList<bool>({false, false, true, false}));
    }
    void nothing_is_turned_or_taken_back_during_a_recording() {
        LabParts bench;
        bench.tuning.setNumber("stiffness", 0.3, "K");
        const LabParameters before = bench.tuning.parameters();
        bench.activity.become(LabActivity::Recording);
        bench.tuning.setNumber("stiffness", 0.1, "K");
        QVERIFY(bench.last().startsWith("Nothing can be changed during a recording."));
        bench.tuning.undo();
        bench.tuning.reset();
        QVERIFY(bench.tuning.parameters() == before);
    }
};

} // namespace lab_tuning_test

TP_TEST(lab_tuning_test, LabTuningTest, window)
#include "lab_tuning_test.moc"
