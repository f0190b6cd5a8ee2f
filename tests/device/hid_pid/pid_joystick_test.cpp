// SPDX-License-Identifier: Apache-2.0
#include "../until.hpp"
#include "joystick_bench.hpp"
#include "safe_force.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace tp;
using tp::testing::BorrowedJoystickLink;
using tp::testing::JoystickBench;
using tp::testing::safe;

namespace {

/// A stick that is opened when a test wants it.
struct JoystickToOpen {
    ModelJoystick model;
    SimulatedJoystickLink link{model};
    PidJoystick device;

    explicit JoystickToOpen(const JoystickWire& wire = open_controller(), const JoystickScale& scale = {},
                            LatestWriter::Thread thread = LatestWriter::Thread::caller)
        : model(wire),
          device(
              [this]() -> Result<std::unique_ptr<PidTransport>> {
                  return std::unique_ptr<PidTransport>(std::make_unique<BorrowedJoystickLink>(link));
              },
              {"a stick", "0001"}, scale, thread) {}
};

/// An open controller whose effects have no direction, but axes that they are of.
JoystickWire with_axes_alone() {
    static const std::vector<std::uint8_t> descriptor = [] {
        const JoystickWire wire = open_controller();
        std::vector<std::uint8_t> bytes(wire.descriptor.begin(), wire.descriptor.end());
        const std::array<std::uint8_t, 4> direction{0x09, 0x57, 0xA1, 0x02};
        const auto at = std::search(bytes.begin(), bytes.end(), direction.begin(), direction.end());
        at[1] = 0x58;
        return bytes;
    }();
    JoystickWire wire = open_controller();
    wire.descriptor = descriptor;
    return wire;
}

/// What a stick takes from any thread.
struct Taken {
    std::atomic<int> forces{0};
    std::atomic<int> let_go_past_the_writer{0};
    std::atomic<bool> shut{false}; ///< a write hangs as long
    std::atomic<bool> waiting{false};
    std::atomic<bool> closed{false};
    GuardDiary diary;
};

class Taker final : public PidTransport {
public:
    explicit Taker(std::shared_ptr<Taken> taken) : taken_(std::move(taken)) {}
    ~Taker() override { taken_->closed.store(true); }
    Taker(const Taker&) = delete;
    Taker& operator=(const Taker&) = delete;
    std::vector<std::uint8_t> descriptor() override {
        const JoystickWire wire = open_controller();
        return {wire.descriptor.begin(), wire.descriptor.end()};
    }
    Got read(hid::Report&, int) noexcept override { return Got::nothing; }
    Got input_now(hid::Report& report) noexcept override {
        report = {};
        report.bytes[0] = 1;
        report.size = 13;
        return Got::report;
    }
    bool write(const hid::Report& report) noexcept override {
        taken_->waiting.store(true);
        while (taken_->shut.load())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        taken_->forces.fetch_add(report.bytes[0] == 5 ? 1 : 0);
        return true;
    }
    void write_from_signal(const hid::Report& report) noexcept override {
        const bool none = report.bytes[0] == 5 && report.bytes[2] == 0 && report.bytes[3] == 0;
        taken_->let_go_past_the_writer.fetch_add(none ? 1 : 0);
    }
    bool set_feature(const hid::Report&) noexcept override { return true; }
    bool get_feature(hid::Report& report) noexcept override {
        report.bytes[1] = static_cast<std::uint8_t>(++loaded_);
        report.bytes[2] = 1;
        return true;
    }
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report>,
                                              std::span<const hid::Report>) override {
        return std::unique_ptr<ForceGuard>(std::make_unique<SimulatedGuard>(taken_->diary));
    }

private:
    std::shared_ptr<Taken> taken_;
    int loaded_ = 0;
};

PidJoystick::Opener lend(std::shared_ptr<Taken> taken) {
    return [taken]() -> Result<std::unique_ptr<PidTransport>> {
        return std::unique_ptr<PidTransport>(std::make_unique<Taker>(taken));
    };
}

} // namespace

class PidJoystickTest : public QObject {
    Q_OBJECT

    static void sticks() {
        QTest::addColumn<int>("stick");
        QTest::newRow("open controller") << 0;
        QTest::newRow("plain controller") << 1;
        QTest::newRow("sidewinder") << 2;
        QTest::newRow("axes without directions") << 3;
    }
    static JoystickWire wire_of(int stick) {
        return stick == 0   ? open_controller()
               : stick == 1 ? plain_controller()
               : stick == 2 ? tp::testing::sidewinder()
                            : with_axes_alone();
    }

private slots:
    void it_says_what_it_can_and_that_its_newtons_are_none() {
        JoystickToOpen stick;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY2(can.ok(), can.error().c_str());
        QCOMPARE(can->serial_number, std::string("0001"));
        QVERIFY(!can->calibrated);
        QCOMPARE(can->max_force, PidJoystick::most_newtons_unmeasured);
        QCOMPARE(can->workspace.size(), std::size_t(4));
        QVERIFY(can->resolution > 0.001 && can->resolution < 0.002); // 120 mm in 65 534 steps
        QCOMPARE(stick.model.effects(), std::size_t(2));
    }

    void forces_along_each_axis_have_their_size_and_their_sign_data() { sticks(); }
    void forces_along_each_axis_have_their_size_and_their_sign() {
        QFETCH(int, stick);
        for (const Vec2 sign : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)}) {
            JoystickToOpen bench(wire_of(stick), {8.0, sign, true});
            bench.model.sign = sign;
            QVERIFY(bench.device.open().ok());
            for (const Vec2 newtons :
                 {Vec2(2.0, 0.0), Vec2(-2.0, 0.0), Vec2(0.0, 1.5), Vec2(0.0, -1.5), Vec2(1.0, -2.0)}) {
                bench.device.read(0.001);
                QVERIFY(bench.device.write(safe(newtons, 100.0)));
                bench.device.deliver();
                bench.link.advance();
                const Vec2 felt = bench.model.force();
                QVERIFY2(length(felt - newtons) < 0.05, qPrintable(QString("%1 %2").arg(felt.x).arg(felt.y)));
                QVERIFY(length(felt) < length(newtons) + 0.02);
            }
        }
    }

    void a_force_that_was_lost_does_not_stay_while_the_other_axis_goes_on() {
        JoystickToOpen stick(open_controller(), {8.0, {-1, -1}, true});
        QVERIFY(stick.device.open().ok());
        const auto pull = [&](Vec2 newtons) {
            stick.device.read(0.001);
            QVERIFY(stick.device.write(safe(newtons, 100.0)));
            stick.device.deliver();
            stick.link.advance();
        };
        pull({2.0, 0.5});
        stick.link.troubles.deaf = true;
        pull({0.0, 0.6});
        stick.link.troubles.deaf = false;
        QVERIFY(stick.model.force().x > 1.9);
        int ticks = 0;
        while (std::abs(stick.model.force().x) > 0.01 && ticks < 100)
            pull({0.0, ++ticks % 2 == 0 ? 0.6 : 0.7});
        QVERIFY2(ticks <= 16, qPrintable(QString::number(ticks)));
    }

    void one_that_was_not_measured_pulls_less_than_it_is_asked_to() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.device.read(0.001);
        stick.device.write(safe({1.5, 0.0}));
        stick.device.deliver();
        stick.link.advance();
        QVERIFY(stick.model.force().x > 0.1 &&
                stick.model.force().x < 0.3); // 1.5 N of 60 N, of a stick of 8 N
    }

    // The model, of which nothing is read back through what it is to try

    void a_stick_s_endless_effect_ends_after_65_s_of_16_bits() {
        for (const bool expires : {true, false}) {
            JoystickToOpen stick;
            stick.model.troubles.expires = expires;
            QVERIFY(stick.device.open().ok());
            stick.device.read(0.001);
            stick.device.write(safe({1.0, 0.0}));
            stick.device.deliver();
            stick.link.advance(); // with the first of them
            for (int ms = 2; ms < 65535; ++ms)
                stick.model.step();
            QVERIFY(stick.model.force() != Vec2(0.0));
            stick.model.step();
            QCOMPARE(stick.model.force() == Vec2(0.0), expires);
            stick.model.receive({}); // which is no report
        }
    }
    void a_stick_that_is_stopped_or_reset_pulls_nothing_more() {
        for (const std::uint8_t command : {std::uint8_t{3}, std::uint8_t{4}}) {
            JoystickToOpen stick;
            stick.model.troubles.keeps_after_reset = true;
            QVERIFY(stick.device.open().ok());
            stick.device.read(0.001);
            stick.device.write(safe({1.0, 0.0}));
            stick.device.deliver();
            stick.link.advance();
            QVERIFY(stick.model.force() != Vec2(0.0));
            stick.model.receive(std::array<std::uint8_t, 2>{stick.model.wire().control, command});
            stick.model.receive(std::array<std::uint8_t, 2>{stick.model.wire().control, 1}); // motors on
            stick.model.step();
            QVERIFY(stick.model.motors_on() && stick.model.effects() == 2);
            QVERIFY(stick.model.force() == Vec2(0.0));
            stick.model.troubles.keeps_after_reset = false;
            stick.model.receive(std::array<std::uint8_t, 2>{stick.model.wire().control, command});
            QCOMPARE(stick.model.effects(), std::size_t(command == 4 ? 0 : 2));
        }
    }
    /// For how long a grip may feel an old force, of whichever axis, is known to who judges it.
    void a_force_that_does_not_arrive_is_lacked_until_one_of_its_axis_does() {
        ModelJoystick model(open_controller());
        SimulatedJoystickLink link(model);
        const auto force = [](std::uint8_t block) {
            hid::Report report;
            report.bytes = {5, block};
            report.size = 4;
            return report;
        };
        link.troubles.deaf = true;
        QVERIFY(link.write(force(1)));
        link.troubles.deaf = false;
        for (unsigned ms = 1; ms <= 5; ++ms) {
            QVERIFY(link.write(force(2)));
            link.advance();
            QCOMPARE(link.silent_ms(), 1 + ms);
        }
        QVERIFY(link.write(force(1)));
        link.advance();
        QCOMPARE(link.silent_ms(), 0u);
        link.advance();
        QCOMPARE(link.silent_ms(), 1u);
    }
    void a_stick_says_bit_for_bit_why_its_motors_are_off() {
        ModelJoystick model(open_controller());
        const auto said = [&model] {
            model.step();
            std::vector<std::uint8_t> bytes;
            return model.report(bytes) ? bytes : std::vector<std::uint8_t>{};
        };
        using Bytes = std::vector<std::uint8_t>;
        QVERIFY(said().empty()); // nothing has changed
        model.troubles.safety_switch = true;
        QVERIFY(said() == (Bytes{2, 0x0A}));
        model.troubles.no_power = true;
        QVERIFY(said() == (Bytes{2, 0x02}));
        model.disable();
        QVERIFY(said() == (Bytes{2, 0x00}));
        model.troubles = {};
        QVERIFY(said() == (Bytes{2, 0x0C}));
        QVERIFY(said().empty());
    }

    void where_it_stands_is_known_from_the_first_moment_data() { sticks(); }
    void where_it_stands_is_known_from_the_first_moment() {
        QFETCH(int, stick);
        for (const Vec2 place : {Vec2(30.0, -15.0), Vec2(-58.0, 45.0), Vec2(60.0, -60.0)}) {
            JoystickToOpen bench(wire_of(stick));
            bench.model.place_grip(place);
            QVERIFY(bench.device.open().ok());
            const std::optional<DeviceState> state = bench.device.read(0.001);
            QVERIFY(state.has_value());
            QVERIFY(length(state->position - place) < 0.2);
        }
    }
    void or_from_its_first_report_where_it_does_not_tell() {
        JoystickToOpen stick;
        stick.link.troubles.no_input_now = true;
        QVERIFY(stick.device.open().ok());
        QVERIFY(!stick.device.read(0.001).has_value());
        stick.model.place_grip({10.0, 0.0});
        stick.link.advance();
        QVERIFY(stick.device.read(0.002).has_value());
    }

    void a_full_memory_is_emptied_once() {
        JoystickToOpen stick;
        stick.model.troubles.room = 4;
        std::vector<std::uint8_t> answer;
        QVERIFY(stick.model.get_feature(stick.model.wire().block_load, answer));
        QCOMPARE(int(answer[2]), 3);  // nothing is loaded that was not asked for
        stick.model.leave_effects(3); // a reset empties it
        QCOMPARE(stick.model.effects(), std::size_t(3));
        QVERIFY(stick.device.open().ok());
        QCOMPARE(stick.model.effects(), std::size_t(2));
        stick.device.stop();
        stick.link.advance();

        stick.model.troubles.keeps_after_reset = true; // only freeing does
        stick.model.leave_effects(3);
        QVERIFY(stick.device.open().ok());
    }
    void a_memory_without_room_is_said() {
        JoystickToOpen stick;
        stick.model.troubles.room = 1;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("no room") != std::string::npos, can.error().c_str());
        stick.link.advance();
        QCOMPARE(stick.model.effects(), std::size_t(0)); // the one that had room is not left on it
        QVERIFY(!stick.model.motors_on());
        QVERIFY(!stick.device.write(SafeForce{}));
    }
    void an_effect_that_is_refused_is_said() {
        JoystickToOpen stick;
        stick.model.troubles.refuses = true;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("does not take up a force") != std::string::npos, can.error().c_str());
    }
    void an_answer_may_take_a_while() {
        JoystickToOpen stick;
        stick.link.troubles.block_load_late = 5;
        QVERIFY(stick.device.open().ok());
    }
    void unplugged_while_it_is_opened_is_said() {
        JoystickToOpen stick;
        stick.link.troubles.unplugged = true;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("unplugged") != std::string::npos, can.error().c_str());
    }
    void what_cannot_be_used_is_said_with_its_reason() {
        JoystickWire wire = open_controller();
        wire.descriptor = wire.descriptor.first(wire.descriptor.size() - 1);
        JoystickToOpen cut(wire);
        QVERIFY(cut.device.open().error().find("makes no sense") != std::string::npos);
        static const std::vector<std::uint8_t> rumble =
            tp::testing::bytes_of(tp::testing::saitek_rumble_pad.hex);
        wire.descriptor = rumble;
        JoystickToOpen rumbles(wire);
        QVERIFY(rumbles.device.open().error().find("its force has no direction") != std::string::npos);
    }

    void without_a_guard_it_is_not_opened_and_nothing_is_left_on_it() {
        JoystickToOpen stick;
        stick.link.troubles.no_guard = true;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY2(can.error().find("nothing would watch over its motors") != std::string::npos,
                 can.error().c_str());
        stick.link.advance();
        QCOMPARE(stick.model.effects(), std::size_t(0));
        QVERIFY(!stick.model.motors_on());
        QVERIFY(!stick.device.write(safe({1.0, 0.0})));
    }

    void its_guard_hears_before_and_after_each_message_whether_it_pulls() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        double now = 0.0;
        const auto write = [&](Vec2 newtons) {
            stick.device.read(now += 0.001);
            stick.device.write(safe(newtons, 100.0));
            stick.device.deliver();
        };
        write({1.0, 0.0});
        QVERIFY(stick.link.diary.pulls);
        QCOMPARE(stick.link.diary.beats, 2);
        write({0.0, 0.0});
        QVERIFY(!stick.link.diary.pulls);
        QCOMPARE(stick.link.diary.beats, 3); // no force needs no leave
        write({0.0, -1.0});
        QVERIFY(stick.link.diary.pulls);
        stick.device.stop();
        QVERIFY(!stick.link.diary.pulls);
        QCOMPARE(stick.link.diary.dismissals, 1);
        QCOMPARE(stick.link.diary.ends, 1);
    }

    /// The program stood still between its sign of life and what it wrote.
    void a_force_that_comes_after_its_guard_has_let_go_is_taken_back() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.link.diary.before_that = {ForceGuard::Word::here, ForceGuard::Word::stepped_in};
        stick.device.read(0.001);
        stick.device.write(safe({1.0, -1.0}));
        stick.device.deliver();
        stick.link.advance();
        QVERIFY(stick.model.force() == Vec2(0.0));
        QVERIFY(!stick.link.diary.pulls);
        stick.device.write(safe({1.0, -1.0})); // before the servo hears of it
        stick.device.deliver();
        stick.link.advance();
        QVERIFY(stick.model.force() == Vec2(0.0));
        stick.device.read(0.002);
        QVERIFY(stick.device.motors_off());
        stick.device.write(SafeForce{});
        stick.device.deliver();
        stick.device.read(0.003);
        stick.device.write(SafeForce{});
        QVERIFY(!stick.device.motors_off());
        stick.device.write(safe({1.0, -1.0}));
        stick.device.deliver();
        stick.link.advance();
        QVERIFY(stick.model.force() != Vec2(0.0));
    }

    void what_its_guard_would_write_takes_the_force_away_data() { sticks(); }
    void what_its_guard_would_write_takes_the_force_away() {
        QFETCH(int, stick);
        JoystickToOpen bench(wire_of(stick));
        QVERIFY(bench.device.open().ok());
        bench.device.read(0.001);
        bench.device.write(safe({1.0, -1.0}));
        bench.device.deliver();
        bench.link.advance();
        QVERIFY(bench.model.force() != Vec2(0.0));
        for (const hid::Report& report : bench.link.guard_takes_away)
            bench.model.receive(report.all());
        bench.model.step();
        QVERIFY(bench.model.force() == Vec2(0.0));
        QVERIFY(bench.model.motors_on());
        QCOMPARE(bench.model.effects(), std::size_t(2)); // the program may go on
        for (const hid::Report& report : bench.link.guard_leaves)
            bench.model.receive(report.all());
        QVERIFY(!bench.model.motors_on());
        QCOMPARE(bench.model.effects(), std::size_t(0));
    }

    void it_opens_again_after_it_was_unplugged() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.device.read(0.001);
        stick.device.write(safe({1.0, 0.0}));
        stick.device.deliver();
        stick.link.troubles.unplugged = true;
        stick.device.read(0.002);
        QVERIFY(stick.device.lost());
        QVERIFY(!stick.device.write(safe({1.0, 0.0})));
        stick.link.troubles.unplugged = false;
        QVERIFY(stick.device.open().ok());
        QVERIFY(!stick.device.lost());
        QCOMPARE(stick.link.diary.dismissals, 0); // the guard of one that is lost does what it still can
        QCOMPARE(stick.link.diary.ends, 1);
        stick.link.troubles.unplugged = true;
        stick.device.read(0.003);
        QVERIFY(stick.device.lost());
        stick.link.troubles.unplugged = false;
        stick.model.troubles.refuses = true;
        QVERIFY(!stick.device.open().ok());
        QVERIFY(!stick.device.lost()); // there is nothing that could be
        stick.device.stop();
        stick.device.stop();
    }

    /// Its motors and its place belong to what was before.
    void opened_again_it_begins_as_new() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.model.troubles.safety_switch = true;
        stick.link.advance();
        QVERIFY(stick.device.read(0.001));
        QVERIFY(stick.device.motors_off());
        QVERIFY(stick.device.complaint().find("safety switch") != std::string::npos);
        stick.model.troubles.safety_switch = false;
        stick.link.troubles.no_input_now = true;
        stick.link.troubles.mute = true;
        QVERIFY(stick.device.open().ok());
        QVERIFY(!stick.device.motors_off());
        QCOMPARE(stick.device.complaint(), std::string());
        QVERIFY(!stick.device.read(100.0)); // nobody knows yet where it is
        QCOMPARE(stick.device.complaint(), std::string());
        QVERIFY(!stick.device.motors_off());
    }

    /// The writer's own thread, with the servo's and one that halts: for the thread sanitizer.
    void a_thread_of_its_own_delivers() {
        const auto taken = std::make_shared<Taken>();
        PidJoystick device(lend(taken), {"a stick", ""});
        QVERIFY(device.open().ok());
        std::thread halter([&device] {
            for (int i = 0; i < 20; ++i)
                device.halt();
        });
        for (int i = 0; i < 200; ++i) {
            device.read(0.001 * i);
            const int before = taken->forces.load(); // the writer may be done before write() has returned
            QVERIFY(device.write(safe({0.01 * (i % 7), 0.0})));
            while (taken->forces.load() == before) // CTest ends a test that waits for ever
                std::this_thread::yield();
        }
        halter.join();
        device.stop();
    }

    /// What pulls is taken away past the writer, which keeps the stick and its guard until it comes back.
    void stopped_while_a_write_hangs_it_lets_go() {
        const auto taken = std::make_shared<Taken>();
        {
            PidJoystick device(lend(taken), {"a stick", ""});
            QVERIFY(device.open().ok());
            device.read(0.0);
            taken->waiting.store(false);
            taken->shut.store(true);
            QVERIFY(device.write(safe({1.0, 0.0})));
            tp::testing::until([&] { return taken->waiting.load(); });
            device.stop();
            QCOMPARE(taken->let_go_past_the_writer.load(), 2); // along each axis
            QVERIFY(!taken->closed.load());
            QCOMPARE(taken->diary.ends, 0);
            QVERIFY(!device.write(safe({1.0, 0.0})));
        }
        taken->shut.store(false);
        tp::testing::until([&] { return taken->closed.load(); });
        QCOMPARE(taken->diary.dismissals, 0);
    }
};

QTEST_APPLESS_MAIN(PidJoystickTest)
#include "pid_joystick_test.moc"
