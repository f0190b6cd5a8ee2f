// SPDX-License-Identifier: Apache-2.0
#include "haptics_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace haptic_pad_test {

using namespace tp;
using tp::testing::HapticsBench;

namespace {

const Tick click(0.8, 1.0, 0.01);

/// A pad whose ordinals are the highest that a byte has; keeps what it was sent last.
struct HighOrdinals final : HapticsTransport {
    explicit HighOrdinals(haptics::Output& sent) : last(sent) {}
    std::vector<std::uint8_t> descriptor() override {
        const auto model = ModelHapticPad::descriptor();
        std::vector<std::uint8_t> bytes(model.begin(), model.end());
        const auto put = [&bytes](const std::vector<std::uint8_t>& from,
                                  const std::vector<std::uint8_t>& to) {
            std::copy(to.begin(), to.end(),
                      std::search(bytes.begin(), bytes.end(), from.begin(), from.end()));
        };
        put({0x19, 0x03, 0x29, 0x06, 0x15}, {0x19, 0xFA, 0x29, 0xFD, 0x15});
        put({0x15, 0x00, 0x25, 0x07, 0x75, 0x08}, {0x14, 0x26, 0xFF, 0x00, 0x75, 0x08}); // to 255
        return bytes;
    }
    std::vector<std::uint8_t> feature(std::uint8_t id, std::size_t) override {
        return ModelHapticPad().feature(id);
    }
    Got read(Input&, int) noexcept override { return Got::nothing; }
    bool send(const haptics::Output& report) noexcept override {
        last = report;
        return true;
    }
    haptics::Output& last;
};

/// A pad that has `left` reports of one finger to tell to who does not wait, and then is as `after` says; counts how often it is
/// asked.
struct Talker final : HapticsTransport {
    Talker(int& has, int& was_asked, Got& then) : left(has), asked(was_asked), after(then) {}
    std::vector<std::uint8_t> descriptor() override {
        return {ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end()};
    }
    std::vector<std::uint8_t> feature(std::uint8_t id, std::size_t) override {
        return ModelHapticPad().feature(id);
    }
    Got read(Input& report, int wait_ms) noexcept override {
        ++asked;
        report.bytes = {1, 1};
        report.size = 12;
        return wait_ms == 0 && left-- > 0 ? Got::report : after;
    }
    bool send(const haptics::Output&) noexcept override { return true; }
    int& left;
    int& asked;
    Got& after;
};

template <typename Transport, typename... Lent>
HapticPad nameless(Lent&... lent) {
    return HapticPad(
        [&]() -> Result<std::unique_ptr<HapticsTransport>> {
            return std::unique_ptr<HapticsTransport>(std::make_unique<Transport>(lent...));
        },
        {}, LatestWriter::Thread::caller);
}

} // namespace

class HapticPadTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_what_it_can_do() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        QCOMPARE(bench.can.name, std::string("model pad"));
        QCOMPARE(bench.can.serial_number, std::string("HP-0001"));
        QVERIFY(bench.can.means == TouchMeans::ticks && bench.can.pad);
        QVERIFY(std::abs(bench.can.pad->width() - 100.0) < 1e-9 &&
                std::abs(bench.can.pad->height() - 60.0) < 1e-9);
    }

    void a_finger_is_read_and_felt() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        bench.model.touch(0, {10.0, 5.0}, true);
        bench.run(0.02);
        QVERIFY(bench.touch && bench.touch->touched && bench.touch->buttons == 1);
        QVERIFY(distance(bench.touch->place, Vec2(10.0, 5.0)) < 0.04);
        QVERIFY(bench.pad.tick(click));
        bench.run(0.002);
        QCOMPARE(bench.model.waveform(), 0x1003);
        QVERIFY(std::abs(bench.model.felt() - 0.8) < 0.01);
        bench.run(0.02);
        QCOMPARE(bench.model.felt(), 0.0);
        QVERIFY(bench.pad.tick(Tick(0.3, 0.0, 0.02)));
        bench.run(0.002);
        QCOMPARE(bench.model.waveform(), 0x1008);
        QVERIFY(std::abs(bench.model.felt() - 0.3) < 0.01);
        QCOMPARE(bench.model.ticks(), 2ul);
    }

    void it_says_how_late_and_how_often_it_ticks() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        QCOMPARE(bench.can.rate, 50.0);
        QCOMPARE(bench.can.shortest_s, 0.01);
        QCOMPARE(bench.can.delay, 0.015);
        QVERIFY(!bench.pad.read(0.0)); // nobody has touched it yet
        QVERIFY(std::abs(bench.can.pad->min.x + 50.0) < 1e-9 && std::abs(bench.can.pad->min.y + 30.0) < 1e-9);
    }

    /// Its number of ticks runs round.
    void each_of_many_ticks_is_felt_once() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        for (int i = 0; i < 300; ++i) {
            QVERIFY(bench.pad.tick(click));
            bench.run(0.002);
            bench.pad.deliver();
            if (i < 150)
                continue;
            bench.pad.halt(); // also where one was halted before
            bench.run(0.002);
        }
        bench.run(0.01);
        QCOMPARE(bench.model.ticks(), 300ul);
        QVERIFY(bench.pad.tick(Tick{}));
        bench.run(0.01);
        QCOMPARE(bench.model.ticks(), 300ul);
    }

    void a_waveform_may_have_any_ordinal_of_a_byte() {
        haptics::Output last;
        HapticPad pad = nameless<HighOrdinals>(last);
        const auto can = pad.open();
        QVERIFY(can.ok());
        QCOMPARE(can.value().name, std::string("touch pad with haptics")); // it has no name of its own
        QVERIFY(pad.tick(click));
        pad.deliver();
        QCOMPARE(int(last.bytes[1]), 0xFB); // the second of its list
        QCOMPARE(int(last.bytes[2]), 80);
    }

    /// One that talks without end, such as a broken one, does not hold up the rest.
    void so_many_reports_are_read_at_a_time() {
        int left = 0, asked = 0;
        HapticsTransport::Got after = HapticsTransport::Got::nothing;
        HapticPad pad = nameless<Talker>(left, asked, after);
        QVERIFY(pad.open().ok());
        for (const auto& [there, read] : {std::pair{1000, 64}, {63, 64}, {2, 3}, {0, 1}}) {
            left = there;
            asked = 0;
            QCOMPARE(pad.read(0.0).has_value(), there > 0);
            QCOMPARE(asked, read);
        }
        left = 3;
        after = HapticsTransport::Got::lost;
        QVERIFY(!pad.read(0.0) && pad.lost()); // where the finger was is nowhere any more
    }

    void opened_again_what_it_complained_of_is_over() {
        for (const bool hangs : {false, true}) {
            HapticsBench bench;
            QCOMPARE(bench.open(), std::string());
            bench.writer_stalled = hangs;
            bench.link.troubles.refuse = hangs ? 0.0 : 1.0;
            bench.pad.tick(click);
            bench.run(0.3);
            QVERIFY(!bench.pad.tick(click) && !bench.pad.complaint().empty());
            bench.link.troubles.refuse = 0.0;
            QCOMPARE(bench.open(), std::string());
            QCOMPARE(bench.pad.complaint(), std::string());
            QVERIFY(bench.pad.tick(click));
            QVERIFY(bench.pad.resist(1.0));
        }
    }

    void opened_again_no_finger_is_there() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        bench.model.touch(1, {10.0, 5.0}, true);
        bench.run(0.02);
        QVERIFY(bench.touch && bench.touch->touched);
        QCOMPARE(bench.open(), std::string());
        bench.model.lift(1);
        bench.run(0.02);
        QVERIFY(!bench.touch->touched);
        QVERIFY(bench.touch->place == Vec2(0.0));
        QCOMPARE(bench.touch->buttons, 0u);
        QVERIFY(bench.now - bench.touch->time < 0.02);
        bench.pad.stop();
        QVERIFY(!bench.pad.read(bench.now));
    }

    void a_second_finger_does_not_take_over_before_the_first_is_lifted() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        bench.model.touch(1, {10.0, 5.0});
        bench.run(0.02);
        bench.model.touch(0, {-40.0, 0.0});
        bench.run(0.02);
        QVERIFY(distance(bench.touch->place, Vec2(10.0, 5.0)) < 0.04);
        bench.model.lift(1);
        bench.run(0.02);
        QVERIFY(distance(bench.touch->place, Vec2(-40.0, 0.0)) < 0.04);
        bench.model.lift(0);
        bench.run(0.02);
        QVERIFY(!bench.touch->touched);
        bench.model.touch(1, {10.0, 5.0});
        bench.run(0.02);
        bench.model.touch(0, {-40.0, 0.0});
        QCOMPARE(bench.open(), std::string()); // of two that are there already nobody knows who came first
        bench.run(0.02);
        QVERIFY(distance(bench.touch->place, Vec2(-40.0, 0.0)) < 0.04);
    }

    void what_another_program_left_playing_is_stopped_at_the_start() {
        HapticsBench bench;
        const std::array<std::uint8_t, 6> goes_on{3, 6, 100, 0, 0, 0};
        bench.model.receive(goes_on);
        bench.link.advance();
        QVERIFY(bench.model.felt() > 0.0);
        QCOMPARE(bench.open(), std::string());
        bench.run(0.003);
        QCOMPARE(bench.model.felt(), 0.0);
    }

    void halted_and_stopped_nothing_is_felt() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        QVERIFY(bench.pad.tick(Tick(1.0, 0.0, 0.05)));
        bench.run(0.003);
        QVERIFY(bench.model.felt() > 0.0);
        bench.pad.halt();
        bench.run(0.002);
        QCOMPARE(bench.model.felt(), 0.0);
        QVERIFY(bench.pad.tick(click));
        bench.pad.halt();
        bench.run(0.1);
        QCOMPARE(bench.model.ticks(), 1ul);
        QVERIFY(bench.pad.tick(click));
        bench.run(0.003);
        QVERIFY(bench.model.felt() > 0.0);
        bench.pad.stop();
        bench.link.advance();
        QCOMPARE(bench.model.felt(), 0.0);
        QVERIFY(!bench.pad.tick(click));
        bench.pad.stop();
    }

    void gone_without_a_stop_nothing_is_felt_of_it() {
        ModelHapticPad model;
        SimulatedHapticsLink link(model);
        int users = 0;
        {
            HapticPad pad(tp::testing::lend(link, users), {}, LatestWriter::Thread::caller);
            QVERIFY(pad.open().ok());
            QVERIFY(pad.tick(click));
            pad.deliver();
            link.advance();
            QVERIFY(model.felt() > 0.0);
        }
        QCOMPARE(users, 0);
        link.advance();
        QCOMPARE(model.felt(), 0.0);
    }

    /// Else it would be busy with itself.
    void opened_again_it_has_let_go_of_the_device_before() {
        ModelHapticPad model;
        SimulatedHapticsLink link(model);
        int users = 0;
        int found_busy = 0;
        const HapticPad::Opener opener = tp::testing::lend(link, users);
        HapticPad pad(
            [&] {
                found_busy += users;
                return opener();
            },
            {}, LatestWriter::Thread::caller);
        QVERIFY(pad.open().ok() && pad.open().ok());
        QCOMPARE(found_busy, 0);
    }

    void one_that_ticks_by_itself_only_is_refused_with_a_sentence() {
        HapticsBench bench;
        bench.link.troubles.lie = ModelHapticPad::descriptor_without_trigger();
        QCOMPARE(
            bench.open(),
            std::string("The touch pad with haptics cannot be used: it ticks by itself only and takes no "
                        "ticks from a program."));
    }

    void why_it_cannot_be_opened_is_passed_on() {
        HapticPad pad([]() -> Result<std::unique_ptr<HapticsTransport>> { return Error{"It is gone."}; }, {},
                      LatestWriter::Thread::caller);
        QCOMPARE(pad.complaint(), std::string()); // nobody has asked for it yet
        QCOMPARE(pad.open().error(), std::string("It is gone."));
        QVERIFY(!pad.tick(click));
    }

    void a_descriptor_that_lies_ends_in_a_sentence() {
        HapticsBench bench;
        bench.link.troubles.lie = {0xC0};
        QVERIFY(bench.open().find("cannot be read") != std::string::npos);
        QCOMPARE(bench.users, 0);
        bench.link.troubles.lie.clear();
        bench.model.waveforms = {0x1004, 0x1005, 0x100B, 0x100C};
        QVERIFY(bench.open().find("no tick that ends by itself") != std::string::npos);
        bench.model.waveforms[2] = 0x1003;
        for (bool CableTroubles::*silent :
             {&CableTroubles::mute, &CableTroubles::deaf, &CableTroubles::unplugged}) {
            bench.link.troubles.*silent = true; // it does not answer what it is asked
            QVERIFY(bench.open().find("no tick that ends by itself") != std::string::npos);
            bench.link.troubles.*silent = false;
        }
        bench.link.troubles.refuse = 1.0;
        QVERIFY(bench.open().find("could not be opened") != std::string::npos);
        QCOMPARE(bench.users, 0); // other programs may have it
        bench.link.troubles.refuse = 0.0;
        QCOMPARE(bench.open(), std::string());
        QCOMPARE(bench.users, 1);
        bench.pad.stop();
        QCOMPARE(bench.users, 0);
    }

    void nobody_calls_the_system_but_the_writer_and_one_that_hangs_is_told() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        bench.run(0.01);
        bench.writer_stalled = true;
        const unsigned long before = bench.link.sends();
        QVERIFY(bench.pad.tick(click));
        bench.run(0.3);
        QVERIFY(!bench.pad.tick(click));
        bench.pad.halt();
        QCOMPARE(bench.link.sends(), before);
        QVERIFY(bench.pad.complaint().find("does not take the ticks") != std::string::npos);
        bench.writer_stalled = false;
        bench.run(0.01);
        QCOMPARE(bench.link.sends(), before + 1); // of all that, only that it was halted
        QCOMPARE(bench.model.ticks(), 0ul);
        QCOMPARE(bench.pad.complaint(), std::string());
        QVERIFY(bench.pad.tick(click));
    }

    void one_that_refuses_is_told() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        bench.link.troubles.refuse = 1.0;
        bench.pad.tick(click);
        bench.run(0.01);
        QVERIFY(!bench.pad.tick(click));
        QVERIFY(!bench.pad.complaint().empty() && !bench.pad.lost());
    }

    void unplugged_in_mid_touch_a_reason_is_said_and_it_can_be_opened_again() {
        HapticsBench bench;
        QCOMPARE(bench.open(), std::string());
        bench.link.troubles.unplugged = true;
        bench.run(0.002);
        QVERIFY(bench.pad.lost() && !bench.pad.tick(click) && !bench.pad.resist(1.0));
        QCOMPARE(bench.pad.complaint(),
                 std::string("The touch pad with haptics was unplugged. Plug it in again."));
        bench.link.troubles.unplugged = false;
        bench.link.troubles.lie = {0xC0};
        QVERIFY(!bench.open().empty());
        QVERIFY(!bench.pad.lost() &&
                bench.pad.complaint().empty()); // it is there, and why it cannot be used was said
        bench.link.troubles.lie.clear();
        QCOMPARE(bench.open(), std::string());
        QVERIFY(!bench.pad.lost() && bench.pad.complaint().empty());
    }
};

} // namespace haptic_pad_test

TP_TEST(haptic_pad_test, HapticPadTest, nothing)
#include "haptic_pad_test.moc"
