// SPDX-License-Identifier: Apache-2.0
// Which pads are listed, and which of their interfaces is taken, with devices made by umockdev.
#include "device/force_pad/bulk_transport.hpp"
#include "device/force_pad/hid_transport.hpp"
#include "device/registry.hpp"
#include "mock_usb.hpp"
#include "stranger.hpp"

#include <QTest>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

using namespace tp;
using mock::UsbPadBed;

namespace {

const std::vector<std::string> nodes = {UsbPadBed::node, mock::hidraw_node};

} // namespace

class PluggedPadsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const UsbPadBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_pad_with_both_interfaces_is_listed_once_and_used_over_hid() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in(true));
        QCOMPARE(find_hid().size(), std::size_t(1));
        QCOMPARE(find_bulk().size(), std::size_t(1));
        const std::vector<ListedDevice> devices = list_devices();
        QCOMPARE(devices.size(), std::size_t(2));
        QCOMPARE(devices[0].interface, std::string());
        QCOMPARE(devices[1].name, std::string("pad:TPC-0001"));
        QCOMPARE(devices[1].interface, std::string("hid"));
    }

    void where_hid_cannot_be_opened_it_is_used_over_bulk() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in(true));
        const mock::Stranger stranger(bed.root(), nodes, {mock::hidraw_node});
        QVERIFY(stranger.good());
        const std::vector<ListedDevice> devices = list_devices();
        QCOMPARE(devices.size(), std::size_t(2));
        QCOMPARE(devices[1].name, std::string("pad:TPC-0001"));
        QCOMPARE(devices[1].interface, std::string("bulk"));
        Result<std::unique_ptr<ForceDevice>> device = device_named("pad:TPC-0001");
        QVERIFY(device.ok());
        const Result<Capabilities> can = device.value()->open();
        QVERIFY2(can.ok(), can.ok() ? "" : can.error().c_str());
        QCOMPARE(can->serial_number, std::string("TPC-0001"));
        QCOMPARE(bed.seen().claimed, 1L);
    }

    void where_neither_can_be_opened_it_is_listed_and_says_why() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in(true));
        const mock::Stranger stranger(bed.root(), nodes, {mock::hidraw_node, UsbPadBed::node});
        QVERIFY(stranger.good());
        QCOMPARE(list_devices().size(), std::size_t(2));
        Result<std::unique_ptr<ForceDevice>> device = device_named("pad:TPC-0001");
        QVERIFY(device.ok());
        const Result<Capabilities> can = device.value()->open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("udev/rules.d") != std::string::npos, can.error().c_str());
    }

    void without_a_hid_node_it_is_listed_by_its_bulk_interface() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        const std::vector<ListedDevice> devices = list_devices();
        QCOMPARE(devices.size(), std::size_t(2));
        QCOMPARE(devices[1].name, std::string("pad:TPC-0001"));
        QCOMPARE(devices[1].about, std::string("force pad"));
        QCOMPARE(devices[1].interface, std::string("bulk"));
    }
};

QTEST_APPLESS_MAIN(PluggedPadsTest)
#include "plugged_pads_test.moc"
