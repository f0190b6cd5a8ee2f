// SPDX-License-Identifier: Apache-2.0
#include "../../until.hpp"
#include "steam_bench.hpp"

#include <QTest>

#include <atomic>
#include <mutex>

using namespace tp;
using tp::testing::lend;
using tp::testing::SteamBench;

namespace {

const Tick click(0.8, 1.0, 0.01);

void every_controller() {
    QTest::addColumn<int>("kind");
    QTest::newRow("deck") << static_cast<int>(steam::Kind::deck);
    QTest::newRow("controller") << static_cast<int>(steam::Kind::controller);
    QTest::newRow("receiver") << static_cast<int>(steam::Kind::receiver);
}

/// A transport whose sending hangs in the system until it is let go.
class HangingLink final : public SteamTransport {
public:
    explicit HangingLink(ModelSteamPad& model) : model_(model) {}
    steam::Kind kind() const override { return model_.kind(); }
    Got read(Input&, int) noexcept override { return Got::nothing; }
    bool send(const steam::Feature& report) noexcept override {
        inside.store(true);
        while (hangs.load())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        inside.store(false);
        const std::lock_guard lock(mutex);
        return model_.receive(report);
    }
    std::atomic<bool> hangs{false};
    std::atomic<bool> inside{false};
    std::mutex mutex; ///< of the model

private:
    ModelSteamPad& model_;
};

} // namespace

class SteamPadTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_what_it_can_do() {
        const SteamBench deck;
        QCOMPARE(deck.error, std::string());
        QCOMPARE(deck.can.name, std::string("Steam Deck"));
        QCOMPARE(deck.can.serial_number, std::string("SD-0001"));
        QVERIFY(deck.can.means == TouchMeans::ticks && deck.can.pad);
        QCOMPARE(deck.can.pad->width(), 32.5);
        QCOMPARE(SteamBench(steam::Kind::controller).can.pad->width(), 40.0);
        QVERIFY(SteamBench(steam::Kind::receiver).can.delay > deck.can.delay);
    }

    void it_says_how_late_and_how_often_it_ticks() {
        for (const steam::Kind kind : {steam::Kind::deck, steam::Kind::controller, steam::Kind::receiver}) {
            const SteamBench bench(kind);
            const bool by_radio = kind == steam::Kind::receiver;
            QCOMPARE(bench.can.rate, by_radio ? 50.0 : 125.0);
            QCOMPARE(bench.can.delay, by_radio ? 0.020 : 0.008);
            QCOMPARE(bench.can.shortest_s, 0.002);
            const double half = kind == steam::Kind::deck ? 16.25 : 20.0;
            QVERIFY(bench.can.pad->min == Vec2(-half) && bench.can.pad->max == Vec2(half));
        }
    }

    void the_pad_that_is_touched_tells_and_ticks_data() { every_controller(); }
    void the_pad_that_is_touched_tells_and_ticks() {
        QFETCH(int, kind);
        SteamBench bench{static_cast<steam::Kind>(kind)};
        QCOMPARE(bench.error, std::string());
        bench.model.touch(steam::Side::left, {-5.0, 2.0}, true);
        bench.run(0.01);
        QVERIFY(bench.touch && bench.touch->touched);
        QCOMPARE(bench.touch->buttons, 1u);
        QVERIFY(distance(bench.touch->place, Vec2(-5.0, 2.0)) < 0.01);
        QVERIFY(bench.pad.tick(click));
        bench.pad.deliver();
        bench.link.advance();
        QVERIFY(bench.model.felt(steam::Side::left) > 0.5);
        QCOMPARE(bench.model.felt(steam::Side::right), 0.0);
        bench.run(0.02);
        QCOMPARE(bench.felt(), 0.0);

        // A second thumb does not take over before the first is lifted.
        bench.model.touch(steam::Side::right, {6.0, -3.0});
        bench.run(0.01);
        QVERIFY(distance(bench.touch->place, Vec2(-5.0, 2.0)) < 0.01);
        bench.model.lift(steam::Side::left);
        bench.run(0.01);
        QVERIFY(bench.touch->touched);
        QVERIFY(distance(bench.touch->place, Vec2(6.0, -3.0)) < 0.01);
        QVERIFY(bench.pad.tick(click));
        bench.pad.deliver();
        bench.link.advance();
        QVERIFY(bench.model.felt(steam::Side::right) > 0.5);
        bench.model.lift(steam::Side::right);
        bench.run(0.01);
        QVERIFY(!bench.touch->touched);
        QVERIFY(distance(bench.touch->place, Vec2(6.0, -3.0)) < 0.01);
    }

    void no_mouse_is_imitated_while_it_is_open_and_one_again_when_it_is_not_data() { every_controller(); }
    void no_mouse_is_imitated_while_it_is_open_and_one_again_when_it_is_not() {
        QFETCH(int, kind);
        SteamBench bench{static_cast<steam::Kind>(kind)};
        bench.run(0.002);
        for (int i = 0; i < 20000; ++i) { // 20 s: longer than a Deck remembers
            bench.tick();
            QVERIFY(!bench.model.imitates());
        }
        QCOMPARE(bench.model.ticks(), 0ul);
        QCOMPARE(*bench.users, 1);
        bench.pad.stop();
        bench.run(0.002);
        QVERIFY(bench.model.imitates());
        QCOMPARE(*bench.users, 0);
        bench.link.troubles.refuse = 1.0;
        QVERIFY(!bench.pad.open().ok());
        QCOMPARE(*bench.users, 0); // other programs may have it
    }

    void a_tick_is_not_felt_twice_when_the_mouse_is_turned_off_again() {
        SteamBench bench;
        bench.run(0.1);
        QVERIFY(bench.pad.tick(click));
        bench.run(5.0);
        QCOMPARE(bench.model.ticks(), 1ul);
    }

    void the_newest_tick_takes_the_place_of_one_under_way() {
        SteamBench bench;
        QVERIFY(bench.pad.tick(Tick(0.1, 0.0, 0.05)));
        QVERIFY(bench.pad.tick(click));
        bench.run(0.002);
        QCOMPARE(bench.model.ticks(), 1ul);
        QVERIFY(bench.felt() > 0.5);
    }

    void halted_nothing_is_felt_and_what_was_not_yet_felt_never_is() {
        SteamBench bench;
        QVERIFY(bench.pad.tick(Tick(1.0, 0.0, 0.05)));
        bench.run(0.005);
        QVERIFY(bench.felt() > 0.0);
        bench.pad.halt();
        bench.run(0.002);
        QCOMPARE(bench.felt(), 0.0);
        bench.writer_stalled = true;
        QVERIFY(bench.pad.tick(click));
        bench.pad.halt();
        bench.run(0.01);
        bench.writer_stalled = false;
        bench.run(3.0); // the mouse is turned off again meanwhile
        QCOMPARE(bench.model.ticks(), 1ul);
        QVERIFY(bench.pad.tick(click));
        bench.run(0.003);
        QVERIFY(bench.felt() > 0.0);
    }

    void nobody_calls_the_system_but_the_writer() {
        SteamBench bench;
        bench.writer_stalled = true;
        const unsigned long before = bench.link.sends();
        for (int i = 0; i < 3000; ++i) {
            bench.tick();
            bench.pad.tick(click);
            bench.pad.halt();
        }
        QCOMPARE(bench.link.sends(), before);
        bench.writer_stalled = false;
        bench.tick();
        QCOMPARE(bench.link.sends(), before + 1); // that nothing is felt
    }

    void a_writer_that_hangs_is_told_and_nothing_is_felt_late() {
        SteamBench bench;
        bench.run(0.1);
        bench.writer_stalled = true;
        QVERIFY(bench.pad.tick(click));
        bench.run(0.3);
        QVERIFY(!bench.pad.tick(click));
        QVERIFY(bench.pad.complaint().find("does not take the ticks") != std::string::npos);
        bench.writer_stalled = false;
        bench.run(0.01);
        QCOMPARE(bench.pad.complaint(), std::string());
        QVERIFY(bench.pad.tick(click));
    }

    void one_that_refuses_is_told_and_used_again_when_it_does_not() {
        SteamBench bench;
        bench.link.troubles.refuse = 1.0;
        bench.pad.tick(click);
        bench.run(0.01);
        QVERIFY(bench.pad.complaint().find("Close other programs") != std::string::npos);
        QVERIFY(!bench.pad.tick(click));
        QVERIFY(!bench.pad.lost());
        bench.link.troubles.refuse = 0.0;
        bench.run(0.01);
        bench.pad.tick(click);
        bench.run(0.01);
        QCOMPARE(bench.pad.complaint(), std::string());
        QVERIFY(bench.pad.tick(click));
        bench.link.troubles.refuse = 1.0;
        bench.pad.tick(click);
        bench.run(0.01);
        QVERIFY(!bench.pad.tick(click));
        bench.link.troubles.refuse = 0.0;
        QVERIFY(bench.pad.open().ok()); // begins anew
        QVERIFY(bench.pad.tick(click));
    }

    void unplugged_in_mid_touch_a_reason_is_said_and_it_can_be_opened_again() {
        SteamBench bench;
        bench.run(0.1);
        bench.link.troubles.unplugged = true;
        bench.run(0.002);
        QVERIFY(bench.pad.lost());
        QVERIFY(!bench.pad.tick(click));
        QVERIFY(!bench.pad.resist(1.0));
        QCOMPARE(bench.pad.complaint(), std::string("The Steam Deck was unplugged. Plug it in again."));
        QVERIFY(!bench.pad.open().ok());
        QVERIFY(!bench.pad.lost()); // there is nothing that could be
        bench.link.troubles.unplugged = false;
        QVERIFY(bench.pad.open().ok());
        QVERIFY(!bench.pad.lost());
        QCOMPARE(bench.pad.complaint(), std::string());
    }

    void a_receiver_without_a_controller_says_so() {
        SteamBench bench(steam::Kind::receiver);
        bench.model.switch_on(false);
        bench.run(0.01);
        QVERIFY(bench.pad.lost());
        QVERIFY(bench.pad.complaint().find("switched off") != std::string::npos);
        QVERIFY(bench.pad.open().error().find("Press its middle button") != std::string::npos);
        bench.model.switch_on(true);
        QVERIFY(bench.pad.open().ok());
    }

    void of_a_receivers_places_the_one_with_a_controller_is_used() {
        ModelSteamPad off(steam::Kind::receiver);
        off.switch_on(false);
        ModelSteamPad on(steam::Kind::receiver);
        SimulatedSteamLink first(off);
        SimulatedSteamLink second(on);
        SteamPad pad({lend(first), lend(second)}, {}, LatestWriter::Thread::caller);
        QVERIFY(pad.open().ok());
        QVERIFY(pad.tick(click));
        pad.deliver();
        second.advance();
        QCOMPARE(on.ticks(), 1ul);
        QCOMPARE(off.ticks(), 0ul);
    }

    void one_that_does_not_answer_is_not_opened() {
        ModelSteamPad model(steam::Kind::deck);
        SimulatedSteamLink link(model);
        link.troubles.refuse = 1.0;
        SteamPad pad({lend(link)}, {}, LatestWriter::Thread::caller);
        QVERIFY(pad.open().error().find("The Steam Deck does not answer") != std::string::npos);
        QVERIFY(!pad.tick(click));
    }

    void a_receiver_that_says_nothing_at_all_is_not_opened() {
        ModelSteamPad model(steam::Kind::receiver);
        SimulatedSteamLink link(model);
        link.troubles.mute = true;
        SteamPad pad({lend(link)}, {}, LatestWriter::Thread::caller);
        QVERIFY(pad.open().error().find("does not answer") != std::string::npos);
    }

    /// With a thread of its own, as it is used.
    void a_transport_that_hangs_keeps_nobody_but_its_writer() {
        ModelSteamPad model(steam::Kind::deck);
        HangingLink link(model);
        SteamPad pad({lend(link)});
        QVERIFY(pad.open().ok());
        link.hangs.store(true);
        QVERIFY(pad.tick(click));
        tp::testing::until([&] { return link.inside.load(); });
        for (int i = 0; i < 100; ++i) {
            pad.read(0.001 * i);
            pad.tick(click);
        }
        pad.halt();
        link.hangs.store(false);
        pad.stop();
        const std::lock_guard lock(link.mutex);
        QCOMPARE(model.felt(steam::Side::right), 0.0);
        QVERIFY(model.imitates());
    }
};

QTEST_APPLESS_MAIN(SteamPadTest)
#include "steam_pad_test.moc"
