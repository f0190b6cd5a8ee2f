// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/device_connector.hpp"
#include "device_socket.hpp"

#include <QSignalSpy>
#include <QTest>

#include <functional>
#include <memory>
#include <utility>

using namespace tp;
using tp::testing::DeviceSocket;

class DeviceConnectorTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qRegisterMetaType<std::shared_ptr<OpenDevice>>(); }

    void what_is_plugged_in_and_out_is_seen_while_it_watches() {
        DeviceSocket socket;
        DeviceConnector desk(socket.access());
        desk.watch(true);
        QVERIFY(!desk.knows());
        QTRY_VERIFY(desk.knows());
        QVERIFY(desk.there().empty()); // the simulated one is none
        socket.plug_in();
        QTRY_COMPARE(desk.there().size(), std::size_t(1));
        QCOMPARE(desk.there().front().serial_number, std::string(DeviceSocket::serial_number));
        socket.unplug();
        QTRY_VERIFY(desk.there().empty());
        desk.watch(false);
        QVERIFY(!desk.knows());
        socket.plug_in();
        desk.watch(true);
        QTRY_VERIFY(desk.knows());
        QCOMPARE(desk.there().size(), std::size_t(1));
    }

    void a_word_that_something_was_plugged_in_has_it_looked_for_at_once() {
        DeviceSocket socket;
        DeviceAccess access = socket.access();
        access.look_every_ms = 3'600'000;
        std::function<void()> tell;
        access.on_plug = [&tell](std::function<void()> changed) {
            tell = std::move(changed);
            return std::shared_ptr<void>(
                &tell, [](void* words) { *static_cast<std::function<void()>*>(words) = nullptr; });
        };
        DeviceConnector desk(access);
        QVERIFY(!tell);
        desk.watch(true);
        QTRY_VERIFY(desk.knows());
        QVERIFY(desk.there().empty());
        socket.plug_in();
        tell();
        QTRY_COMPARE(desk.there().size(), std::size_t(1));
        QSignalSpy looks(&desk, &DeviceConnector::looked);
        QTRY_VERIFY(!looks.isEmpty()); // once more, for nodes that come later
        desk.watch(false);
        QVERIFY(!tell); // nobody is asked to tell any more
    }

    void a_device_is_opened_or_says_why_not() {
        DeviceSocket socket;
        socket.plug_in();
        DeviceConnector desk(socket.access());
        std::shared_ptr<OpenDevice> open;
        QString refusal;
        connect(&desk, &DeviceConnector::opened, this,
                [&](const std::shared_ptr<OpenDevice>& one) { open = one; });
        connect(&desk, &DeviceConnector::refused, this, [&](const QString& sentence) { refusal = sentence; });
        desk.watch(true);
        QTRY_COMPARE(desk.there().size(), std::size_t(1));
        socket.refuse("Another program uses the force pad. Close that program and try again.");
        desk.open(desk.there().front());
        QVERIFY(desk.opening());
        QTRY_VERIFY(refusal.contains("Close that program"));
        QVERIFY(!desk.opening());
        socket.refuse({});
        desk.open(desk.there().front());
        QTRY_VERIFY(open != nullptr);
        QCOMPARE(open->can.serial_number, std::string(DeviceSocket::serial_number));
        QVERIFY(socket.in_use());
        desk.release(std::make_unique<DeviceDrive>(std::move(open->device), open->can, ServoSettings{}));
        QTRY_VERIFY(!socket.in_use());
    }

    void what_is_not_wanted_any_more_is_given_back() {
        DeviceSocket socket;
        socket.plug_in();
        DeviceConnector desk(socket.access());
        int answers = 0;
        connect(&desk, &DeviceConnector::opened, this, [&] { ++answers; });
        desk.watch(true);
        QTRY_COMPARE(desk.there().size(), std::size_t(1));
        desk.open(desk.there().front());
        desk.cancel();
        QVERIFY(!desk.opening());
        QTRY_COMPARE(socket.opened(), 1);
        QTRY_VERIFY(!socket.in_use());
        desk.open(desk.there().front());
        desk.open(desk.there().front()); // the newest wish is answered
        QTRY_COMPARE(socket.opened(), 3);
        QTRY_COMPARE(answers, 1);
    }

    void the_middle_of_what_it_reaches_lies_on_the_middle_of_the_surface() {
        Capabilities can;
        QVERIFY(middle_on_middle(can)({3.0, 4.0}) == Vec2(3.0, 4.0));
        can.workspace = {{-41, 75}, {79, 75}, {79, 135}, {-41, 135}};
        QVERIFY(middle_on_middle(can)({19.0, 105.0}) == Vec2(0.0, 0.0));
        QVERIFY(middle_on_middle(can)({20.0, 105.0}) == Vec2(1.0, 0.0));
    }
};

QTEST_GUILESS_MAIN(DeviceConnectorTest)
#include "device_connector_test.moc"
