// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/device_connector.hpp"
#include "device_socket.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

#include <functional>
#include <memory>
#include <utility>

namespace device_connector_test {

using namespace tp;
using tp::testing::DeviceSocket;

class DeviceConnectorTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qRegisterMetaType<std::shared_ptr<OpenDevice>>(); }

    void what_is_plugged_in_and_out_is_seen_while_it_watches() {
        DeviceSocket socket;
        DeviceConnector connector(socket.access());
        connector.watch(true);
        QVERIFY(!connector.knows());
        QTRY_VERIFY(connector.knows());
        QVERIFY(connector.there().empty()); // the simulated one is none
        socket.plug_in();
        QTRY_COMPARE(connector.there().size(), std::size_t(1));
        QCOMPARE(connector.there().front().serial_number, std::string(DeviceSocket::serial_number));
        socket.unplug();
        QTRY_VERIFY(connector.there().empty());
        connector.watch(false);
        QVERIFY(!connector.knows());
        socket.plug_in();
        connector.watch(true);
        QTRY_VERIFY(connector.knows());
        QCOMPARE(connector.there().size(), std::size_t(1));
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
        DeviceConnector connector(access);
        QVERIFY(!tell);
        connector.watch(true);
        QTRY_VERIFY(connector.knows());
        QVERIFY(connector.there().empty());
        socket.plug_in();
        tell();
        QTRY_COMPARE(connector.there().size(), std::size_t(1));
        QSignalSpy looks(&connector, &DeviceConnector::looked);
        QTRY_VERIFY(!looks.isEmpty()); // once more, for nodes that come later
        connector.watch(false);
        QVERIFY(!tell); // nobody is asked to tell any more
    }

    void a_device_is_opened_or_says_why_not() {
        DeviceSocket socket;
        socket.plug_in();
        DeviceConnector connector(socket.access());
        std::shared_ptr<OpenDevice> open;
        QString refusal;
        connect(&connector, &DeviceConnector::opened, this,
                [&](const std::shared_ptr<OpenDevice>& one) { open = one; });
        connect(&connector, &DeviceConnector::refused, this,
                [&](const QString& sentence) { refusal = sentence; });
        connector.watch(true);
        QTRY_COMPARE(connector.there().size(), std::size_t(1));
        socket.refuse("Another program uses the force pad. Close that program and try again.");
        connector.open(connector.there().front());
        QVERIFY(connector.opening());
        QTRY_VERIFY(refusal.contains("Close that program"));
        QVERIFY(!connector.opening());
        socket.refuse({});
        connector.open(connector.there().front());
        QTRY_VERIFY(open != nullptr);
        QCOMPARE(open->can.serial_number, std::string(DeviceSocket::serial_number));
        QVERIFY(socket.in_use());
        connector.release(std::make_unique<DeviceDrive>(std::move(open->device), open->can, ServoSettings{}));
        QTRY_VERIFY(!socket.in_use());
    }

    void what_is_not_wanted_any_more_is_given_back() {
        DeviceSocket socket;
        socket.plug_in();
        DeviceConnector connector(socket.access());
        int answers = 0;
        connect(&connector, &DeviceConnector::opened, this, [&] { ++answers; });
        connector.watch(true);
        QTRY_COMPARE(connector.there().size(), std::size_t(1));
        connector.open(connector.there().front());
        connector.cancel();
        QVERIFY(!connector.opening());
        QTRY_COMPARE(socket.opened(), 1);
        QTRY_VERIFY(!socket.in_use());
        connector.open(connector.there().front());
        connector.open(connector.there().front()); // the newest wish is answered
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

} // namespace device_connector_test

TP_TEST(device_connector_test, DeviceConnectorTest, event_loop)
#include "device_connector_test.moc"
