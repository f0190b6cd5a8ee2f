// SPDX-License-Identifier: Apache-2.0
// What a Steam pad's back end says on the line, message by message, and how much it reads.
#include "steam_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

namespace steam_line_test {

using namespace tp;
using tp::testing::lend;

namespace {

const Tick click(0.8, 1.0, 0.01);

/// Keeps what it was told, says what a test puts there, and counts how long it was waited for.
class ScriptedLink final : public SteamTransport {
public:
    steam::Kind its_kind = steam::Kind::deck;
    std::vector<std::vector<std::uint8_t>> to_say; ///< the last one first
    std::vector<steam::Feature> told;
    bool babbles = false; ///< something each time that tells nothing
    int reads = 0;
    int waited_ms = 0;
    int takes = 1000000; ///< messages, then none

    steam::Kind kind() const override { return its_kind; }
    Got read(Input& report, int wait_ms) noexcept override {
        ++reads;
        waited_ms += wait_ms;
        if (to_say.empty() && !babbles)
            return Got::nothing;
        report.size = report.bytes.size();
        report.bytes = {};
        if (!to_say.empty()) {
            std::copy(to_say.back().begin(), to_say.back().end(), report.bytes.begin());
            to_say.pop_back();
        }
        return Got::report;
    }
    bool send(const steam::Feature& report) noexcept override {
        told.push_back(report);
        return takes-- > 0;
    }
    int count(std::uint8_t command) const {
        return static_cast<int>(std::count_if(
            told.begin(), told.end(), [command](const steam::Feature& one) { return one[1] == command; }));
    }
};

} // namespace

class SteamLineTest : public QObject {
    Q_OBJECT
private slots:
    /// Two seconds of silence; however much else it says.
    void a_receiver_is_asked_ten_times() {
        ScriptedLink silent;
        silent.its_kind = steam::Kind::receiver;
        SteamPad pad({lend(silent)}, {}, LatestWriter::Thread::caller);
        QVERIFY(!pad.open().ok());
        QCOMPARE(silent.count(0xB4), 10);
        QCOMPARE(silent.reads, 10);
        QCOMPARE(silent.waited_ms, 200);
        QCOMPARE(silent.count(0x85) + silent.count(0x8E), 2); // left as it was
        QVERIFY(!pad.read(0.0));
        ScriptedLink busy;
        busy.its_kind = steam::Kind::receiver;
        busy.babbles = true;
        SteamPad other({lend(busy)}, {}, LatestWriter::Thread::caller);
        QVERIFY(!other.open().ok());
        QCOMPARE(busy.reads, 500);
        ScriptedLink there;
        there.its_kind = steam::Kind::receiver;
        there.to_say = {{1, 0, 3, 1, 2}};
        SteamPad third({lend(there)}, {}, LatestWriter::Thread::caller);
        QVERIFY(third.open().ok());
        QCOMPARE(there.count(0xB4), 1);
        ScriptedLink half; // takes one of the two that keep it from imitating a mouse
        half.takes = 1;
        SteamPad fourth({lend(half)}, {}, LatestWriter::Thread::caller);
        QVERIFY(!fourth.open().ok());
    }

    /// Its numbers of ticks and of renewals run round.
    void each_of_many_ticks_is_told_once_and_the_mouse_kept_off_each_second() {
        ScriptedLink link;
        SteamPad pad({lend(link)}, {}, LatestWriter::Thread::caller);
        QVERIFY(pad.open().ok());
        link.told.clear();
        double now = 0.0;
        for (int i = 0; i < 4; ++i) {
            pad.read(now += 0.5);
            pad.deliver();
        }
        QCOMPARE(link.count(0x81), 1);
        QCOMPARE(link.count(0x8F), 0); // nothing was to be felt yet
        link.told.clear();
        now = 0.0;
        for (int i = 0; i < 300; ++i)
            for (int part = 0; part < 2; ++part) {
                pad.read(now += 0.5);
                QVERIFY(pad.tick(click));
                pad.deliver();
            }
        QCOMPARE(link.count(0x8F), 600);
        QVERIFY2(std::abs(link.count(0x81) - 299) <= 1, qPrintable(QString::number(link.count(0x81))));
        QCOMPARE(link.count(0x87), link.count(0x81));
        link.told.clear();
        QVERIFY(pad.tick(Tick{}));
        pad.deliver();
        QCOMPARE(link.count(0x8F), 0);
        pad.halt();
        pad.deliver();
        QCOMPARE(link.count(0x8F), 1); // both pads still
        pad.stop();
        QCOMPARE(link.count(0x85), 1);
        QCOMPARE(link.count(0x8E), 1);
        QVERIFY(!pad.read(now));
        QVERIFY(!pad.tick(click));
    }

    void why_it_cannot_be_opened_is_passed_on() {
        const auto gone = []() -> Result<std::unique_ptr<SteamTransport>> { return Error{"It is gone."}; };
        SteamPad pad({gone, gone}, {}, LatestWriter::Thread::caller);
        QCOMPARE(pad.open().error(), std::string("It is gone."));
        QVERIFY(!pad.tick(click));
        QVERIFY(!pad.read(0.0));
    }

    void gone_without_a_stop_it_leaves_the_mouse_as_it_was() {
        ScriptedLink link;
        const auto users = std::make_shared<int>(0);
        {
            SteamPad pad({lend(link, users)}, {}, LatestWriter::Thread::caller);
            QVERIFY(pad.open().ok());
            QCOMPARE(link.count(0x85), 0);
        }
        QCOMPARE(link.count(0x85), 1);
        QCOMPARE(link.count(0x8E), 1);
        QCOMPARE(*users, 0);
    }

    void a_tick_is_sent_as_it_was_made() {
        for (const steam::Kind kind : {steam::Kind::deck, steam::Kind::controller})
            for (const Tick& tick : {click, Tick(0.05, 0.0, 0.05), Tick(0.3, 0.7, 0.02)}) {
                ScriptedLink link;
                link.its_kind = kind;
                SteamPad pad({lend(link)}, {}, LatestWriter::Thread::caller);
                QVERIFY(pad.open().ok());
                QVERIFY(pad.tick(tick));
                pad.deliver();
                QVERIFY(link.told.back() == steam::play(steam::Side::right, steam::pulses_of(tick, kind)));
            }
    }

    void one_read_takes_64_reports() {
        ScriptedLink link;
        SteamPad pad({lend(link)}, {}, LatestWriter::Thread::caller);
        QVERIFY(pad.open().ok());
        std::vector<std::uint8_t> state(64);
        state[0] = 1;
        state[2] = 9;
        link.to_say.assign(70, state);
        QVERIFY(pad.read(0.0));
        QCOMPARE(link.to_say.size(), std::size_t(6));
        const std::optional<PadTouch> touch = pad.read(0.25);
        QVERIFY(touch);
        QCOMPARE(touch->time, 0.25);
        QCOMPARE(touch->buttons, 0u);
        QVERIFY(!pad.read(0.3));
        link.to_say = {{1, 0, 3, 1, 2}}; // tells of no thumb
        QVERIFY(!pad.read(0.35));
    }
};

} // namespace steam_line_test

TP_TEST(steam_line_test, SteamLineTest, nothing)
#include "steam_line_test.moc"
