// SPDX-License-Identifier: Apache-2.0
#include "app/devices/device_access.hpp"

#include <QTest>

#include <vector>

using namespace tp;

class DeviceAccessTest : public QObject {
    Q_OBJECT
private slots:
    void the_chosen_device_serves_and_else_the_first() {
        const std::vector<ListedDevice> there{{"pad:A", "one", "A", "hid"}, {"pad:/dev/hidraw3", "two", "", "bulk"}};
        QCOMPARE(device_for(there, {}), &there[0]);
        QCOMPARE(device_for(there, "A"), &there[0]);
        QCOMPARE(device_for(there, "pad:/dev/hidraw3"), &there[1]);
        QCOMPARE(device_for(there, "broken long ago"), &there[0]);
        QCOMPARE(device_for(there, no_device_key), nullptr);
        QCOMPARE(device_for({}, "A"), nullptr);
        for (const ListedDevice& one : there)
            QCOMPARE(device_for(there, key_of(one)), &one);
    }
};

QTEST_GUILESS_MAIN(DeviceAccessTest)
#include "device_access_test.moc"
