// SPDX-License-Identifier: Apache-2.0
// Outputs under a bare finger as pages come to them: the next page gets one only when the one before has let go of its own.
#include "app/parts/devices/touch_connector.hpp"
#include "test_program.hpp"
#include "touch_socket.hpp"

#include <QTest>

#include <memory>
#include <utility>

namespace touch_connector_test {

using namespace tp;
using tp::testing::TouchSocket;

namespace {

/// A page that keeps what is opened for it.
struct Page {
    explicit Page(const TouchSocket& socket) : connector(socket.access()) {
        QObject::connect(
            &connector, &TouchConnector::opened, &connector,
            [this](const std::shared_ptr<OpenTouch>& open) { output = std::move(open->output); });
    }
    void ask() { connector.open({"double:1", "test pad", "1", TouchMeans::ticks, false}); }
    void leave() {
        connector.cancel();
        connector.release(std::move(output));
    }
    std::unique_ptr<TouchOutput> output;
    TouchConnector connector;
};

} // namespace

class TouchConnectorTest : public QObject {
    Q_OBJECT
private slots:
    void no_two_pages_hold_one_output() {
        TouchSocket socket;
        socket.plug_in();
        Page first(socket), second(socket);
        first.ask();
        QTRY_VERIFY(first.output != nullptr);
        {
            const auto slow_to_close = socket.hold_closing();
            first.leave();
            second.ask();
            QTest::qWait(50);
            QVERIFY(second.output == nullptr);
        }
        QTRY_VERIFY(second.output != nullptr);
        QCOMPARE(socket.most_open(), 1);
        QCOMPARE(socket.open(), 1);
    }

    void one_that_nobody_wants_any_more_is_closed_before_the_next_is_opened() {
        TouchSocket socket;
        socket.plug_in();
        Page first(socket), second(socket);
        for (int time = 0; time < 20; ++time) {
            first.ask();
            first.leave();
            second.ask();
            QTRY_VERIFY(second.output != nullptr);
            second.leave();
            QTRY_COMPARE(socket.open(), 0);
        }
    }
};

} // namespace touch_connector_test

TP_TEST(touch_connector_test, TouchConnectorTest, event_loop)
#include "touch_connector_test.moc"
