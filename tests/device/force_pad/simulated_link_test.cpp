// SPDX-License-Identifier: Apache-2.0
// The cable in simulated time: when a frame arrives, and what becomes of it.
#include "device/force_pad/simulated_link.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstdint>

namespace simulated_link_test {

using namespace tp;
using Got = ReportTransport::Got;

namespace {

const pad::Frame question = pad::encode(pad::AskFrame{1, pad::FrameType::identity, 0});

/// Milliseconds until the answer to a question is there; 0 where it is not within a second.
int answered_after(SimulatedLink& link) {
    link.write(question);
    for (int ms = 1; ms <= 1000; ++ms) {
        link.advance();
        pad::Frame frame;
        while (link.read(frame, 0) == Got::report)
            if (pad::IdentityFrame identity; pad::decode(frame, identity))
                return ms;
    }
    return 0;
}

/// When the pad said the state that is read next, ms since it was switched on; 0 where there is none.
int next_state_ms(SimulatedLink& link, int wait_ms = 0) {
    pad::Frame frame;
    pad::StateFrame state;
    if (link.read(frame, wait_ms) != Got::report || !pad::decode(frame, state))
        return 0;
    return static_cast<int>(state.time_us / 1000);
}

} // namespace

class SimulatedLinkTest : public QObject {
    Q_OBJECT
private slots:
    void a_frame_takes_its_delay_each_way() {
        for (const unsigned delay : {0u, 1u, 3u, 10u}) {
            ModelPad model(pad::cable_pad());
            SimulatedLink link(model, delay);
            QCOMPARE(answered_after(link), static_cast<int>(1 + 2 * delay));
        }
    }

    void without_a_wait_no_time_passes_and_a_wait_is_as_long_as_it_says() {
        ModelPad model(pad::cable_pad());
        SimulatedLink link(model);
        QCOMPARE(next_state_ms(link), 0);
        QCOMPARE(next_state_ms(link), 0);
        QCOMPARE(next_state_ms(link, 5), 1); // as soon as there is something
        link.troubles.mute = true;
        QCOMPARE(next_state_ms(link, 5), 0);
        link.troubles.mute = false;
        link.advance();
        QCOMPARE(next_state_ms(link), 7);
    }

    void of_what_nobody_reads_the_last_64_reports_are_kept() {
        ModelPad model(pad::cable_pad());
        SimulatedLink link(model);
        for (int i = 0; i < 100; ++i)
            link.advance();
        for (int ms = 37; ms <= 100; ++ms)
            QCOMPARE(next_state_ms(link), ms);
        QCOMPARE(next_state_ms(link), 0);
    }

    void a_line_spoils_each_frame_that_it_is_told_to() {
        ModelPad model(pad::cable_pad());
        SimulatedLink link(model);
        link.troubles.garble = 1.0;
        int whole = 0; // a byte may be replaced by the same
        for (int i = 0; i < 400; ++i) {
            link.advance();
            pad::Frame frame;
            pad::StateFrame state;
            QCOMPARE(link.read(frame, 0), Got::report);
            whole += pad::decode(frame, state) ? 1 : 0;
        }
        QVERIFY2(whole < 10, qPrintable(QString::number(whole)));
        int heard = 0; // and to the pad too
        for (int i = 0; i < 100; ++i) {
            link.troubles.garble = 1.0;
            link.write(question);
            link.troubles.garble = 0.0;
            link.advance();
            pad::Frame frame;
            while (link.read(frame, 0) == Got::report)
                heard += pad::type_of(frame) == pad::FrameType::identity ? 1 : 0;
        }
        QVERIFY2(heard < 5, qPrintable(QString::number(heard)));
    }

    /// Of a half, a half; of none, none.
    void what_is_lost_or_odd_is_the_share_that_is_told() {
        ModelPad model(pad::cable_pad());
        for (const double share : {0.0, 0.5, 1.0})
            for (const bool dropped : {true, false}) {
                SimulatedLink link(model);
                (dropped ? link.troubles.drop : link.troubles.odd) = share;
                int whole = 0;
                int odd = 0;
                for (int i = 0; i < 400; ++i) {
                    link.advance();
                    pad::Frame frame;
                    const Got got = link.read(frame, 0);
                    whole += got == Got::report ? 1 : 0;
                    odd += got == Got::odd ? 1 : 0;
                }
                QVERIFY(whole > 400 * (1.0 - share) - 60 && whole < 400 * (1.0 - share) + 60);
                QCOMPARE(odd, dropped ? 0 : 400 - whole);
            }
    }

    void each_way_can_be_cut() {
        ModelPad model(pad::cable_pad());
        SimulatedLink link(model);
        link.troubles.deaf = true;
        QVERIFY(link.write(question)); // nobody notices
        link.advance();
        pad::Frame frame;
        QCOMPARE(link.read(frame, 0), Got::report);
        QCOMPARE(pad::type_of(frame), pad::FrameType::state);
        QCOMPARE(link.read(frame, 0), Got::nothing);
        link.troubles = {};
        link.troubles.drop = 1.0;
        QVERIFY(link.write(question));
        link.troubles = {};
        link.troubles.mute = true;
        link.advance();
        QCOMPARE(link.read(frame, 0), Got::nothing);
        link.troubles = {};
        QCOMPARE(answered_after(link), 1);
        while (link.read(frame, 0) == Got::report)
            ;
        link.troubles.unplugged = true;
        QVERIFY(!link.write(question));
        QCOMPARE(link.read(frame, 100), Got::lost);
        link.advance();
        link.troubles = {};
        QCOMPARE(link.read(frame, 0), Got::nothing);
    }
};

} // namespace simulated_link_test

TP_TEST(simulated_link_test, SimulatedLinkTest, nothing)
#include "simulated_link_test.moc"
