// SPDX-License-Identifier: Apache-2.0
// What stands in for a Falcon's line and its cable does what is known of them: the bridge's packets, the rates, the firmware,
// what a cable delays, keeps and spoils.
#include "device/falcon/model_falcon.hpp"
#include "device/falcon/simulated_falcon_link.hpp"
#include "quick_falcon.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace model_line_test {

using namespace tp;
using namespace tp::falcon;
using namespace tp::testing;

namespace {

std::vector<std::uint8_t> said(ModelFalcon& model) {
    std::vector<std::uint8_t> bytes;
    UsbPacket packet;
    while (model.packet(packet)) {
        const auto payload = ftdi::received(packet.content()).payload;
        bytes.insert(bytes.end(), payload.begin(), payload.end());
    }
    return bytes;
}

/// How many milliseconds until it has said so much; 10 000 where it never does.
int ms_until_said(ModelFalcon& model, std::size_t count) {
    std::size_t got = 0;
    for (int ms = 1; ms < 10000; ++ms) {
        model.step();
        if ((got += said(model).size()) >= count)
            return ms;
    }
    return 10000;
}

} // namespace

class ModelLineTest : public QObject {
    Q_OBJECT
private slots:
    void its_bridge_says_something_each_latency_and_keeps_64_packets() {
        ModelFalcon model(falcon_image());
        UsbPacket packet;
        for (const int latency : {16, 1}) {
            if (latency != 16) // as it is switched on
                model.control(ftdi::latency(static_cast<std::uint16_t>(latency)));
            for (int ms = 0; ms < 16; ++ms)
                model.step();
            while (model.packet(packet)) {
            }
            int count = 0;
            for (int ms = 0; ms < 32; ++ms)
                model.step();
            for (; model.packet(packet); ++count) {
                QCOMPARE(packet.size, std::size_t(2));
                QCOMPARE(int(packet.bytes[0]), 0x01);
                QCOMPARE(int(packet.bytes[1]), 0x60);
            }
            QCOMPARE(count, 32 / latency);
        }
        for (int ms = 0; ms < 100; ++ms)
            model.step();
        int kept = 0;
        for (; model.packet(packet); ++kept) {
        }
        QCOMPARE(kept, 64);
    }

    /// 150 bytes are nine packets of 16; four replies come at once because a packet of the bus is full.
    void its_line_is_as_quick_as_its_baud_rate() {
        QuickFalcon quick;
        quick.model.control(ftdi::latency(16));
        for (int i = 0; i < 20; ++i) {
            quick.model.step();
            said(quick.model);
        }
        for (int i = 0; i < 20; ++i)
            quick.model.send(encode(Command{}));
        std::size_t replies = 0;
        int ms = 0;
        while (replies < 20 * packet_size && ++ms < 100) {
            quick.model.step();
            UsbPacket packet;
            while (quick.model.packet(packet)) {
                QVERIFY(packet.size <= 64);
                replies += packet.size - 2;
            }
            if (ms == 1)
                QCOMPARE(replies, std::size_t(2 * 62));
        }
        QCOMPARE(replies, std::size_t(20 * packet_size));
    }

    void it_takes_its_firmware_as_a_falcon_does() {
        std::vector<std::uint8_t> small(400);
        for (std::size_t i = 0; i < small.size(); ++i)
            small[i] = static_cast<std::uint8_t>(i * 7 + 1);
        constexpr std::array<std::uint8_t, 3> greeting{0x0A, 0x43, 0x0D};
        constexpr std::array<std::uint8_t, 1> knock{0x41};
        ModelFalcon model(small);
        model.control(ftdi::latency(1));
        model.control(ftdi::baud_9600);
        model.send(greeting);
        QCOMPARE(ms_until_said(model, 1), 10000); // DTR is low
        model.control(ftdi::baud_142857);
        model.control(ftdi::dtr_high);
        model.send(greeting);
        QCOMPARE(ms_until_said(model, 1), 10000); // at another rate it hears something else
        model.control(ftdi::baud_9600);
        model.send(std::vector<std::uint8_t>(150, 0)); // what the line had time for
        for (int i = 0; i < 200; ++i)
            model.step();
        model.control(ftdi::purge_to_send);
        ModelFalcon fresh(small);
        fresh.control(ftdi::latency(1));
        fresh.control(ftdi::baud_9600);
        fresh.control(ftdi::dtr_high);
        fresh.send(greeting);
        QCOMPARE(ms_until_said(fresh, 4), 4); // 0.96 bytes a millisecond
        fresh.control(ftdi::dtr_low);
        fresh.control(ftdi::baud_142857);
        fresh.send(knock); // before it is clear to send
        UsbPacket packet;
        for (int ms = 1; ms <= 60; ++ms) {
            fresh.step();
            while (fresh.packet(packet)) {
                QCOMPARE(packet.size, std::size_t(2));
                QCOMPARE((packet.bytes[0] & 0x10) != 0, ms >= 30);
            }
        }
        QVERIFY(fresh.loads_begun() == 0);
        fresh.send(knock);
        QCOMPARE(ms_until_said(fresh, 1), 1);
        QCOMPARE(fresh.loads_begun(), 1);
        fresh.send(small);
        const int loaded = ms_until_said(fresh, small.size());
        QVERIFY2(loaded >= 17 && loaded <= 19,
                 qPrintable(QString::number(loaded))); // 14.3 a ms, and 150 at once
        QVERIFY(!fresh.firmware_runs());
        for (int ms = 1; ms <= 40; ++ms) {
            fresh.step();
            QCOMPARE(fresh.firmware_runs(), ms == 40);
        }
        fresh.control(ftdi::dtr_low);
        fresh.control(ftdi::dtr_high); // the line of its reset
        QVERIFY(!fresh.firmware_runs());
        fresh.run_firmware(true);
        fresh.control(ftdi::dtr_high);
        QVERIFY(fresh.firmware_runs());
    }

    void its_loader_greets_with_a_zero_before_it_or_without() {
        for (const bool zero : {false, true}) {
            ModelFalcon model(falcon_image());
            model.troubles.eager_zero = zero;
            model.control(ftdi::latency(1));
            model.control(ftdi::baud_9600);
            model.control(ftdi::dtr_high);
            model.send(std::array<std::uint8_t, 3>{0x0A, 0x43, 0x0D});
            for (int ms = 0; ms < 20; ++ms)
                model.step();
            std::vector<std::uint8_t> greeting{0x0A, 0x44, 0x2C, 0x0D};
            if (zero)
                greeting.insert(greeting.begin(), 0);
            QVERIFY(said(model) == greeting);
        }
    }

    void what_is_purged_never_arrives() {
        QuickFalcon quick;
        quick.model.send(encode(Command{}));
        quick.model.control(ftdi::purge_to_send);
        quick.model.step();
        QVERIFY(!quick.heard());
        quick.model.control(ftdi::latency(16));
        for (int i = 0; i < 16; ++i)
            quick.model.step();
        quick.ask();
        quick.model.control(ftdi::purge_received);
        for (int i = 0; i < 20; ++i)
            quick.model.step();
        QVERIFY(!quick.heard());
    }

    // Its cable

    void a_cable_delays_each_way() {
        for (const unsigned delay : {0u, 3u}) {
            QuickFalcon quick;
            SimulatedFalconLink link(quick.model, delay);
            link.write(encode(Command{}));
            unsigned ms = 0;
            UsbPacket packet;
            while (ms < 100 && (link.read(packet, 0) != UsbGot::packet || packet.size < 3)) {
                link.advance();
                ++ms;
            }
            QCOMPARE(ms, 1 + 2 * delay);
        }
    }

    void a_cable_keeps_64_packets_and_waits_in_its_own_time() {
        QuickFalcon quick;
        SimulatedFalconLink link(quick.model);
        for (int ms = 0; ms < 100; ++ms)
            link.advance();
        UsbPacket packet;
        int kept = 0;
        for (; link.read(packet, 0) == UsbGot::packet; ++kept) {
        }
        QCOMPARE(kept, 64);
        int waited = 0;
        link.each_ms = [&] { ++waited; };
        QVERIFY(link.read(packet, 5) == UsbGot::packet);
        QCOMPARE(waited, 1);
        link.troubles.mute = true;
        QVERIFY(link.read(packet, 5) == UsbGot::nothing);
        QCOMPARE(waited, 6);
        link.troubles.mute = false;
        link.troubles.stalled = true;
        QVERIFY(link.read(packet, 5) == UsbGot::nothing);
        link.troubles.stalled = false;
        for (int i = 0; i < 5; ++i)
            QVERIFY(link.read(packet, 0) == UsbGot::packet);
        QVERIFY(link.read(packet, 0) == UsbGot::nothing);
    }

    void a_bad_cable_loses_cuts_and_changes_some() {
        QuickFalcon quick;
        SimulatedFalconLink link(quick.model);
        UsbPacket packet;
        const auto of_400 = [&](auto wanted) {
            int count = 0;
            for (int ms = 0; ms < 400; ++ms) {
                link.write(encode(Command{}));
                link.advance();
                while (link.read(packet, 0) == UsbGot::packet)
                    count += wanted(packet) ? 1 : 0;
            }
            return count;
        };
        QCOMPARE(of_400([](const UsbPacket& one) { return one.size == 18; }), 400);
        link.troubles.drop = 0.5; // half of the commands, and half of what comes back
        const int whole = of_400([](const UsbPacket& one) { return one.size == 18; });
        QVERIFY2(whole > 60 && whole < 140, qPrintable(QString::number(whole)));
        link.troubles = {};
        link.troubles.cut = 0.5;
        const int cut = of_400([](const UsbPacket& one) { return one.size < 18; });
        QVERIFY2(cut > 150 && cut < 250, qPrintable(QString::number(cut)));
        link.troubles = {};
        link.troubles.garble = 0.5;
        const std::vector<std::uint8_t> good = [] {
            QuickFalcon other;
            other.model.send(encode(Command{}));
            other.model.step();
            return said(other.model);
        }();
        int most = 0;
        const int changed = of_400([&](const UsbPacket& one) {
            const auto payload = ftdi::received(one.content()).payload;
            int bytes = (one.bytes[0] != 0x01 ? 1 : 0) + (one.bytes[1] != 0x60 ? 1 : 0);
            for (std::size_t i = 0; i < std::min(good.size(), payload.size()); ++i)
                bytes += payload[i] != good[i] ? 1 : 0;
            most = std::max(most, bytes);
            return bytes > 0;
        });
        QVERIFY2(changed > 150 && changed < 250, qPrintable(QString::number(changed)));
        QVERIFY2(most >= 3 && most <= 4, qPrintable(QString::number(most)));
        link.troubles = {};
        link.troubles.deaf = true;
        QCOMPARE(of_400([](const UsbPacket& one) { return one.size == 18; }), 0);
    }
};

} // namespace model_line_test

TP_TEST(model_line_test, ModelLineTest, nothing)
#include "model_line_test.moc"
