// SPDX-License-Identifier: Apache-2.0
// What is asked of a Falcon, how often, and what is made of its replies: each packet written by hand.
#include "device/falcon/falcon.hpp"
#include "device/guard/simulated_guard.hpp"
#include "falcon_bench.hpp"
#include "safe_force.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dialogue_test {

using namespace tp;
using namespace tp::falcon;
using namespace tp::testing;

namespace {

Reply reply_at(const Place& place) {
    Reply reply;
    const Angles angles = *angles_at(place);
    for (std::size_t i = 0; i < 3; ++i)
        reply.encoders[i] = static_cast<std::int16_t>(std::lround(counts_of(angles[static_cast<int>(i)])));
    reply.homed = 7;
    return reply;
}

/// A Falcon whose firmware runs: says what a test puts there, keeps what it was told.
struct Script final : FalconLink {
    std::optional<Reply> answers = reply_at(middle); ///< to each command; nothing: it is silent
    std::deque<UsbPacket> to_say;
    std::vector<Command> commands;
    GuardDiary diary;
    std::size_t falls_silent_after = SIZE_MAX; ///< commands
    bool reads_fail = false;
    bool writes_fail = false;
    int reads = 0;
    int waited_ms = 0;

    void say(const Packet& packet) {
        UsbPacket usb;
        usb.bytes[0] = 0x01;
        usb.bytes[1] = 0x60;
        std::copy(packet.begin(), packet.end(), usb.bytes.begin() + 2);
        usb.size = 2 + packet_size;
        to_say.push_back(usb);
    }
    bool control(const ftdi::Request&) noexcept override { return true; }
    UsbGot read(UsbPacket& packet, int wait_ms) noexcept override {
        ++reads;
        waited_ms += wait_ms;
        if (reads_fail)
            return UsbGot::lost;
        if (to_say.empty())
            return UsbGot::nothing;
        packet = to_say.front();
        to_say.pop_front();
        return UsbGot::packet;
    }
    bool write(std::span<const std::uint8_t> bytes) noexcept override {
        if (writes_fail)
            return false;
        Packet packet{};
        std::copy_n(bytes.begin(), std::min(bytes.size(), packet_size), packet.begin());
        if (const std::optional<Command> command = decode_command(packet))
            commands.push_back(*command);
        if (answers && commands.size() <= falls_silent_after)
            say(encode(*answers));
        return true;
    }
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const std::uint8_t>) override {
        return std::unique_ptr<ForceGuard>(std::make_unique<SimulatedGuard>(diary));
    }
};

/// Says whether it is still held.
struct CountedLink final : BorrowedFalconLink {
    int& held;
    CountedLink(FalconLink& lent, int& count) : BorrowedFalconLink(lent), held(count) { ++held; }
    ~CountedLink() override { --held; }
};

struct Bench {
    Script script;
    Falcon device{lend(script), [] { return falcon_image(); }, "F-1", LatestWriter::Thread::caller};
    double now = 0.0;

    Result<Capabilities> open() {
        Result<Capabilities> can = device.open();
        script.answers.reset(); // from here on a test says what comes
        script.to_say.clear();
        return can;
    }
    std::optional<DeviceState> hear(const Reply& reply) {
        script.say(encode(reply));
        return device.read(now += 0.001);
    }
    void write(const SafeForce& force) {
        device.write(force);
        device.deliver();
    }
    bool pulls() const { return script.commands.back().motors != std::array<std::int16_t, 3>{}; }
};

} // namespace

class FalconDialogueTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_what_it_can() {
        Bench bench;
        const Result<Capabilities> can = bench.open();
        QVERIFY2(can.ok(), can.error().c_str());
        QCOMPARE(can->name, std::string("Novint Falcon"));
        QCOMPARE(can->max_force, 2.0);
        QCOMPARE(can->continuous_force, 2.0);
        QCOMPARE(can->resolution, 0.05);
        QCOMPARE(can->rate, 1000.0);
        QCOMPARE(can->delay, 0.002);
        QCOMPARE(can->workspace.size(), std::size_t(16));
        for (std::size_t i = 0; i < 16; ++i) {
            const double angle = std::numbers::pi / 8.0 * static_cast<double>(i);
            QVERIFY(length(can->workspace[i] - 50.0 * Vec2(std::cos(angle), std::sin(angle))) < 1e-9);
        }
    }

    void each_button_is_the_one_that_was_pressed() {
        Bench bench;
        QVERIFY(bench.open().ok());
        const std::array<std::uint8_t, 4> pressed{button::centre, button::plus, button::forward,
                                                  button::minus};
        for (std::size_t i = 0; i < pressed.size(); ++i) {
            Reply reply = reply_at(middle);
            reply.buttons = pressed[i];
            const std::optional<DeviceState> state = bench.hear(reply);
            QVERIFY(state);
            QCOMPARE(state->buttons, 1u << i);
            QCOMPARE(state->time, bench.now);
        }
        Reply all = reply_at(middle);
        all.buttons = 15;
        QCOMPARE(bench.hear(all)->buttons, 15u);
    }

    /// 3 mm a millisecond are three metres a second.
    void a_hand_gets_three_millimetres_on_between_two_writes() {
        for (const double mm : {2.8, 3.2}) {
            Bench bench;
            QVERIFY(bench.open().ok());
            QVERIFY(bench.hear(reply_at(middle)));
            QCOMPARE(bench.hear(reply_at(falcon_place({mm, 0.0}))).has_value(), mm < 3.0);
            QCOMPARE(bench.device.bad_readings(), std::uint64_t(mm < 3.0 ? 0 : 1));
        }
        for (const double mm : {8.7, 9.3}) { // two writes were not answered
            Bench bench;
            QVERIFY(bench.open().ok());
            QVERIFY(bench.hear(reply_at(middle)));
            bench.write(SafeForce{});
            bench.write(SafeForce{});
            QCOMPARE(bench.hear(reply_at(falcon_place({0.0, mm}))).has_value(), mm < 9.0);
        }
    }

    void the_eighth_reply_from_a_new_place_is_believed() {
        Bench bench;
        QVERIFY(bench.open().ok());
        QVERIFY(bench.hear(reply_at(middle)));
        for (int i = 1; i <= 8; ++i)
            QCOMPARE(bench.hear(reply_at(falcon_place({30.0, 0.0}))).has_value(), i == 8);
        QVERIFY(bench.hear(reply_at(falcon_place({31.0, 0.0}))));
        for (int i = 1; i <= 7; ++i) // and the count begins anew
            QVERIFY(!bench.hear(reply_at(falcon_place({0.0, 0.0}))));
    }

    void only_where_all_three_arms_are_homed_it_knows_its_place() {
        for (std::uint8_t homed = 0; homed < 8; ++homed) {
            Bench bench;
            QVERIFY(bench.open().ok());
            Reply reply = reply_at(falcon_place({10.0, 0.0}));
            reply.homed = homed;
            QVERIFY(bench.hear(reply));
            bench.write(SafeForce{});
            QCOMPARE(bench.device.motors_off(), homed != 7);
            QCOMPARE(bench.device.complaint().empty(), homed == 7);
            bench.write(safe({1.0, 0.0}));
            QCOMPARE(bench.pulls(), homed == 7);
            QCOMPARE(bench.script.commands.back().homing, homed != 7);
            QCOMPARE(bench.script.commands.back().leds, homed == 7 ? led::green : led::red);
        }
    }

    /// However the arms lose their places: no force until the servo has once sent none.
    void after_it_lost_its_marks_it_wants_no_force_first() {
        Bench bench;
        QVERIFY(bench.open().ok());
        QVERIFY(bench.hear(reply_at(middle)));
        bench.write(safe({1.0, 0.0}));
        QVERIFY(!bench.pulls()); // nor at the beginning
        bench.write(SafeForce{});
        bench.write(safe({1.0, 0.0}));
        QVERIFY(bench.pulls());
        Reply lost = reply_at(middle);
        lost.homed = 6;
        QVERIFY(bench.hear(lost));
        bench.write(safe({1.0, 0.0}));
        QVERIFY(!bench.pulls());
        QVERIFY(bench.hear(reply_at(middle)));
        bench.write(safe({1.0, 0.0}));
        QVERIFY(!bench.pulls());
        bench.write(SafeForce{});
        bench.write(safe({1.0, 0.0}));
        QVERIFY(bench.pulls());
    }

    /// Its pane may push then, and that is a force too.
    void a_share_that_is_let_in_is_no_word_of_no_force() {
        Bench bench;
        QVERIFY(bench.open().ok());
        QVERIFY(bench.hear(reply_at(falcon_place({0.0, 0.0}, -4.0))));
        bench.write(safe({0.0, 0.0}));
        QVERIFY(bench.device.motors_off());
        QVERIFY(!bench.pulls());
        bench.write(SafeForce{});
        bench.write(safe({0.0, 0.0}));
        QVERIFY(bench.pulls());
    }

    void where_its_marks_are_found_again_it_is_believed_at_once() {
        Bench bench;
        QVERIFY(bench.open().ok());
        QVERIFY(bench.hear(reply_at(middle)));
        Reply lost = reply_at(middle);
        lost.homed = 0;
        QVERIFY(bench.hear(lost));
        const std::optional<DeviceState> state = bench.hear(reply_at(falcon_place({30.0, 0.0})));
        QVERIFY(state);
        QVERIFY(length(state->position - Vec2(30.0, 0.0)) < 0.1);
    }

    /// The pane's speed too: 100 mm/s out of it take away what its spring gives.
    void without_replies_a_grip_that_went_out_of_the_pane_is_held_to_stand() {
        Bench bench;
        QVERIFY(bench.open().ok());
        const auto pushes = [&] {
            return bench.script.commands.back().motors != std::array<std::int16_t, 3>{};
        };
        for (int ms = 0; ms <= 40; ++ms) {
            QVERIFY(bench.hear(reply_at(falcon_place({0.0, 0.0}, -5.0 + 0.1 * ms))));
            bench.write(ms == 0 ? SafeForce{} : safe({0.0, 0.0}));
        }
        QVERIFY(!pushes());
        for (int ms = 0; ms < 30; ++ms) {
            QVERIFY(!bench.device.read(bench.now += 0.001));
            bench.write(safe({0.0, 0.0}));
        }
        QVERIFY(pushes());
    }

    /// Where it was, what it heard and what it pulled belong to what was before.
    void opened_again_it_lets_go_and_begins_as_new() {
        Bench bench;
        QVERIFY(bench.open().ok());
        bench.now = 100.0;
        QVERIFY(bench.hear(reply_at(middle)));
        bench.write(SafeForce{});
        bench.write(safe({1.0, 0.0}));
        QVERIFY(bench.pulls());
        bench.script.say(encode(reply_at(middle)));
        bench.script.to_say.back().size = 9; // the rest of it never comes
        QVERIFY(!bench.device.read(bench.now));
        bench.script.answers = reply_at(middle);
        QVERIFY(bench.open().ok());
        QCOMPARE(bench.script.diary.dismissals, 1);
        QCOMPARE(bench.script.diary.ends, 1);
        QCOMPARE(bench.device.bad_readings(), std::uint64_t(0));
        bench.now = 0.0;
        const std::optional<DeviceState> state = bench.hear(reply_at(falcon_place({30.0, 0.0}, -4.0)));
        QVERIFY(state);
        QVERIFY(length(state->position - Vec2(30.0, 0.0)) < 0.1);
        QVERIFY(bench.device.motors_off());
        bench.write(safe({1.0, 0.0}));
        QVERIFY(!bench.pulls());
        bench.write(SafeForce{});
        bench.write(safe({0.0, 0.0})); // only the pane
        QVERIFY(bench.pulls());
    }

    void what_was_unplugged_is_free_and_said_so_at_once() {
        Script script;
        int held = 0;
        Falcon device(
            [&]() -> Result<std::unique_ptr<FalconLink>> {
                return std::unique_ptr<FalconLink>(std::make_unique<CountedLink>(script, held));
            },
            [] { return falcon_image(); }, "F-1", LatestWriter::Thread::caller);
        device.halt(); // of nothing
        QVERIFY(device.open().ok());
        QCOMPARE(held, 1);
        QVERIFY(device.motors_off());
        QVERIFY(!device.lost());
        script.reads_fail = true;
        QVERIFY(!device.read(0.001));
        QVERIFY(device.lost());
        device.stop();
        QCOMPARE(held, 0);
        QVERIFY(!device.motors_off());
        script.reads = 0;
        QVERIFY(device.open().error().find("unplugged") != std::string::npos);
        QCOMPARE(script.reads, 1);
        QCOMPARE(held, 0);
        QVERIFY(!device.lost());
        script.reads_fail = false;
        script.writes_fail = true;
        script.reads = 0;
        QVERIFY(device.open().error().find("unplugged") != std::string::npos);
        QCOMPARE(script.reads, 0);
        script.writes_fail = false;
        script.to_say.clear();
        script.commands.clear();
        script.falls_silent_after = 1; // its firmware was found
        QVERIFY(device.open().error().find("does not answer") != std::string::npos);
        QCOMPARE(held, 0);
        script.falls_silent_after = SIZE_MAX;
        QVERIFY(device.open().ok());
        script.reads_fail = true; // while a person homes it
        script.reads = 0;
        QVERIFY(device.home().error().find("does not answer") != std::string::npos);
        QCOMPARE(script.reads, 1);
        script.writes_fail = true;
        QVERIFY(!device.home().ok());
        QCOMPARE(script.reads, 1);
    }

    void halted_it_lets_go() {
        Bench bench;
        QVERIFY(bench.open().ok());
        QVERIFY(bench.hear(reply_at(middle)));
        bench.write(SafeForce{});
        bench.write(safe({1.0, 0.0}));
        QVERIFY(bench.pulls());
        bench.device.halt();
        bench.device.deliver();
        QVERIFY(!bench.pulls());
    }

    void a_person_has_twenty_thousand_replies_to_home_it() {
        Bench bench;
        QVERIFY(bench.open().ok());
        bench.script.commands.clear();
        bench.script.answers = reply_at(middle);
        bench.script.answers->homed = 3;
        QVERIFY(!bench.device.home().ok());
        QCOMPARE(bench.script.commands.size(), std::size_t(20000));
        bench.script.answers->homed = 7;
        QVERIFY(bench.device.home().ok());
        QVERIFY(bench.script.commands.back() == Command{}); // its light goes out
    }

    void nineteen_packets_with_nothing_in_them_are_waited_through() {
        for (const std::size_t empty : {19U, 20U}) {
            Bench bench;
            QVERIFY(bench.open().ok());
            bench.script.commands.clear();
            UsbPacket nothing;
            nothing.size = 2;
            bench.script.to_say.assign(empty, nothing);
            bench.script.answers = reply_at(middle);
            QVERIFY(bench.device.home().ok());
            QCOMPARE(bench.script.commands.size(), std::size_t(empty == 19 ? 2 : 3));
        }
    }

    void after_fifty_writes_without_a_place_its_motors_are_off() {
        Bench bench;
        QVERIFY(bench.open().ok());
        bench.hear(reply_at(middle));
        bench.write(SafeForce{});
        QVERIFY(bench.hear(reply_at(middle)));
        for (int i = 1; i <= 60; ++i) {
            bench.write(safe({1.0, 0.0}));
            QCOMPARE(bench.pulls(), i <= 50);
        }
        QVERIFY(bench.hear(reply_at(middle)));
        bench.write(safe({1.0, 0.0}));
        QVERIFY(bench.pulls());
    }

    /// However much has gathered: a read ends, and the next goes on where it did.
    void one_read_takes_64_packets() {
        Bench bench;
        QVERIFY(bench.open().ok());
        for (int i = 0; i < 70; ++i)
            bench.script.say(encode(reply_at(falcon_place({0.02 * i, 0.0}))));
        QVERIFY(bench.device.read(0.001));
        QCOMPARE(bench.script.to_say.size(), std::size_t(6));
        QVERIFY(bench.device.read(0.002));
        QVERIFY(bench.script.to_say.empty());
        QVERIFY(!bench.device.read(0.003));
    }

    void replies_that_are_none_are_counted() {
        Bench bench;
        QVERIFY(bench.open().ok());
        Packet odd = encode(reply_at(middle));
        odd[13] = 0x40; // flags that there are not
        bench.script.say(odd);
        QVERIFY(!bench.device.read(0.001));
        QCOMPARE(bench.device.bad_readings(), std::uint64_t(1));
        Packet torn = encode(reply_at(middle));
        torn[0] = 'x';
        bench.script.say(torn);
        QVERIFY(!bench.device.read(0.002));
        QCOMPARE(bench.device.bad_readings(), std::uint64_t(17));
        bench.hear(Reply{{32767, 32767, -32768}, 0, 7}); // where no grip is
        QCOMPARE(bench.device.bad_readings(), std::uint64_t(18));
    }

    void what_does_not_answer_any_more_is_asked_ten_times_before_it_is_said() {
        Bench bench;
        QVERIFY(bench.open().ok());
        bench.script.commands.clear();
        bench.script.reads = bench.script.waited_ms = 0;
        QVERIFY(bench.device.home().error().find("does not answer") != std::string::npos);
        QCOMPARE(bench.script.commands.size(), std::size_t(10));
        QCOMPARE(bench.script.waited_ms, 50);
        for (const Command& command : bench.script.commands) {
            QVERIFY(command.homing);
            QCOMPARE(command.leds, led::blue);
        }
    }
};

} // namespace dialogue_test

TP_TEST(dialogue_test, FalconDialogueTest, nothing)
#include "dialogue_test.moc"
