// SPDX-License-Identifier: Apache-2.0
#include "lab_parts.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

namespace lab_devices_test {

using namespace tp;

class LabDevicesTest : public QObject {
    Q_OBJECT
private slots:
    void devices_are_found_beside_the_page() {
        LabParts bench;
        QCOMPARE(bench.devices.names(), QStringList{"Simulated: the mouse or a finger on the screen"});
        bench.devices.find();
        QTRY_COMPARE_WITH_TIMEOUT(bench.devices.names().size(), 2, patience_ms);
        QCOMPARE(bench.devices.names()[1], QString("force pad, pad:7"));
        QVERIFY(bench.devices.simulated());
        QSignalSpy stop(&bench.activity, &LabActivity::stopAsked);
        bench.devices.choose(1);
        QCOMPARE(bench.last(), QString("force pad, pad:7."));
        bench.devices.choose(1);
        bench.devices.choose(99);
        QVERIFY(!bench.devices.simulated());
        QCOMPARE(stop.size(), 1);
        QSignalSpy found(&bench.devices, &LabDevices::changed);
        bench.devices.find(); // it is still there
        QTRY_COMPARE_WITH_TIMEOUT(found.size(), 1, patience_ms);
        QVERIFY(!bench.devices.simulated());
        bench.there.pop_back();
        bench.devices.find();
        QTRY_VERIFY_WITH_TIMEOUT(bench.devices.simulated(), patience_ms);
        QCOMPARE(stop.size(), 2);
    }
    void nothing_is_looked_for_while_one_is_opened() {
        LabParts bench;
        bench.activity.become(LabActivity::OpeningToRecord);
        bench.devices.find();
        bench.activity.become(LabActivity::Stopped);
        QTest::qWait(0);
        QCOMPARE(bench.devices.names().size(), 1);
    }
    void the_simulated_one_is_open_at_once_and_one_that_is_gone_is_told() {
        LabParts bench;
        VirtualClock time;
        QStringList opened;
        const auto note = [&](const Result<std::shared_ptr<DeviceChain>>& chain) {
            opened << (chain ? QString("open") : QString::fromStdString(chain.error()));
        };
        bench.devices.open({}, bench.scene.size(), {}, time, note);
        QCOMPARE(opened, QStringList{"open"});
        bench.devices.find();
        QTRY_COMPARE_WITH_TIMEOUT(bench.devices.names().size(), 2, patience_ms);
        bench.devices.choose(1);
        bench.devices.open({}, bench.scene.size(), {}, time, note);
        QCOMPARE(opened.size(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 2, patience_ms);
        QVERIFY2(opened[1].startsWith("There is no device \"pad:7\" now."), qPrintable(opened[1]));
        bench.devices.open({}, bench.scene.size(), {}, time, note);
        bench.devices.cancel();
        QSignalSpy found(&bench.devices, &LabDevices::changed);
        bench.devices.find(); // comes after what was cancelled
        QTRY_COMPARE_WITH_TIMEOUT(found.size(), 1, patience_ms);
        QCOMPARE(opened.size(), 2);
    }
};

} // namespace lab_devices_test

TP_TEST(lab_devices_test, LabDevicesTest, window)
#include "lab_devices_test.moc"
