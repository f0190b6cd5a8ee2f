// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/device_access.hpp"
#include "test_program.hpp"

#include <QTest>

#include <vector>

namespace device_access_test {

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

    void what_may_be_no_force_device_serves_only_who_chose_it() {
        const ListedDevice board{"2diy3:A", "Arduino board", "", "serial", true};
        QCOMPARE(device_for({board}, {}), nullptr);
        QCOMPARE(device_for({board}, "broken long ago"), nullptr);
        const std::vector<ListedDevice> there{board, {"2diy1:A", "Arduino board", "", "serial", true}, {"pad:A", "one", "A", "hid"}};
        QCOMPARE(device_for(there, {}), &there[2]);
        for (const ListedDevice& one : there) // one board, listed for each generation
            QCOMPARE(device_for(there, key_of(one)), &one);
    }
};

} // namespace device_access_test

TP_TEST(device_access_test, DeviceAccessTest, event_loop)
#include "device_access_test.moc"
