// SPDX-License-Identifier: Apache-2.0
// What is told to a force stick, how often, and what is made of what it tells: each report written by hand.
#include "device/guard/simulated_guard.hpp"
#include "device/hid_pid/pid_joystick.hpp"
#include "recorded_descriptors.hpp"
#include "resting_stick.hpp"
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
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dialogue_test {

using namespace tp;
using tp::testing::bytes_of;
using tp::testing::RestingStick;
using tp::testing::safe;

namespace {

/// An open controller that keeps what it was told, and says what a test puts there.
struct Script final : RestingStick {
    std::vector<std::vector<std::uint8_t>> told;
    std::deque<std::vector<std::uint8_t>> to_say;
    std::vector<std::uint8_t> block_load{0x12, 0, 1, 0, 0}; ///< its block is counted up from 1
    int asked = 0;
    int not_ready_for = 0; ///< questions after a load that it leaves unanswered
    bool same_block = false;
    bool makes_sense = true; ///< what it says of itself
    int opened = 0;          ///< times that somebody has it open
    GuardDiary diary;

    std::vector<std::uint8_t> descriptor() override {
        std::vector<std::uint8_t> bytes = RestingStick::descriptor();
        bytes.resize(bytes.size() - (makes_sense ? 0 : 1));
        return bytes;
    }
    Got read(hid::Report& report, int) noexcept override {
        if (to_say.empty())
            return Got::nothing;
        report = {};
        std::copy(to_say.front().begin(), to_say.front().end(), report.bytes.begin());
        report.size = to_say.front().size();
        to_say.pop_front();
        return Got::report;
    }
    bool write(const hid::Report& report) noexcept override {
        told.emplace_back(report.all().begin(), report.all().end());
        return true;
    }
    void write_from_signal(const hid::Report& report) noexcept override { write(report); }
    bool set_feature(const hid::Report&) noexcept override {
        asked = 0;
        block_load[1] = same_block ? 1 : static_cast<std::uint8_t>(block_load[1] + 1);
        return true;
    }
    bool get_feature(hid::Report& report) noexcept override {
        if (asked++ < not_ready_for)
            return false;
        std::copy(block_load.begin(), block_load.end(), report.bytes.begin());
        return true;
    }
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report>,
                                              std::span<const hid::Report>) override {
        return std::unique_ptr<ForceGuard>(std::make_unique<SimulatedGuard>(diary));
    }
    /// Reports told since the last time, that begin so.
    int count(std::string_view hex) const {
        const std::vector<std::uint8_t> start = bytes_of(hex);
        return static_cast<int>(std::count_if(told.begin(), told.end(), [&](const auto& report) {
            return report.size() >= start.size() && std::equal(start.begin(), start.end(), report.begin());
        }));
    }
};

struct Borrowed final : PidTransport {
    explicit Borrowed(Script& lent) : script(lent) { ++script.opened; }
    ~Borrowed() override { --script.opened; }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    std::vector<std::uint8_t> descriptor() override { return script.descriptor(); }
    Got read(hid::Report& report, int wait_ms) noexcept override { return script.read(report, wait_ms); }
    Got input_now(hid::Report& report) noexcept override { return script.input_now(report); }
    bool write(const hid::Report& report) noexcept override { return script.write(report); }
    void write_from_signal(const hid::Report& report) noexcept override { script.write_from_signal(report); }
    bool set_feature(const hid::Report& report) noexcept override { return script.set_feature(report); }
    bool get_feature(hid::Report& report) noexcept override { return script.get_feature(report); }
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report> no_force,
                                              std::span<const hid::Report> at_the_end) override {
        return script.guard(no_force, at_the_end);
    }
    Script& script;
};

struct Bench {
    Script script;
    PidJoystick device;
    double now = 0.0;

    explicit Bench(const JoystickScale& scale = {8.0, {1.0, 1.0}, true})
        : device(
              [this]() -> Result<std::unique_ptr<PidTransport>> {
                  return std::unique_ptr<PidTransport>(std::make_unique<Borrowed>(script));
              },
              {"a stick", "0001"}, scale, LatestWriter::Thread::caller) {}

    std::optional<DeviceState> tick(Vec2 newtons, double dt = 0.001) {
        const std::optional<DeviceState> state = device.read(now += dt);
        device.write(safe(newtons, 100.0));
        device.deliver();
        return state;
    }
};

} // namespace

class JoystickDialogueTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_what_it_can_data() {
        QTest::addColumn<double>("newtons");
        QTest::addColumn<bool>("measured");
        QTest::addColumn<double>("most");
        QTest::newRow("weak") << 3.0 << true << 3.0;
        QTest::newRow("strong") << 60.0 << true << 20.0;
        QTest::newRow("unmeasured") << 60.0 << false << 2.0;
    }
    void it_says_what_it_can() {
        QFETCH(double, newtons);
        QFETCH(bool, measured);
        QFETCH(double, most);
        Bench bench({newtons, {1.0, 1.0}, measured});
        const Result<Capabilities> can = bench.device.open();
        QVERIFY2(can.ok(), can.error().c_str());
        QCOMPARE(can->name, std::string("force stick"));
        QCOMPARE(can->max_force, most);
        QCOMPARE(can->continuous_force, most);
        QCOMPARE(can->calibrated, measured);
        QCOMPARE(can->rate, 1000.0);
        QCOMPARE(can->delay, 0.004);
        QVERIFY(std::abs(can->resolution - 120.0 / 65534.0) < 1e-6);
        QVERIFY(can->workspace == (std::vector<Vec2>{{-60, -60}, {60, -60}, {60, 60}, {-60, 60}}));
    }

    void a_place_is_turned_so_that_away_is_up() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        bench.script.to_say.push_back(bytes_of("01 05 00 00 00 00 00 00 00 FF 7F 01 80"));
        const std::optional<DeviceState> state = bench.tick({0, 0});
        QVERIFY(state && state->position == Vec2(60.0, 60.0)); // to the right, and away from the person
        QCOMPARE(state->buttons, 5u);
        QCOMPARE(state->time, bench.now);
    }

    /// Many devices end an "infinite" effect after 65.5 s.
    void each_effect_is_started_anew_each_30_s_and_never_both_at_once() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        bench.script.told.clear();
        std::array<std::vector<double>, 2> starts;
        for (int i = 0; i < 10'000; ++i) {
            bench.tick({0, 0}, 0.01);
            const int first = bench.script.count("0a 01 01 01");
            const int second = bench.script.count("0a 02 01 01");
            QVERIFY(first + second <= 1);
            if (first + second == 1)
                starts[static_cast<std::size_t>(second)].push_back(bench.now);
            bench.script.told.clear();
        }
        for (const auto& [which, from] : {std::pair{0, 30.0}, {1, 15.0}}) {
            QCOMPARE(starts[static_cast<std::size_t>(which)].size(), std::size_t(3));
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY(std::abs(starts[static_cast<std::size_t>(which)][i] -
                                 (from + 30.0 * static_cast<double>(i))) < 0.05);
        }
    }

    void motors_that_are_off_are_switched_on_four_times_a_second_while_no_force_is_wanted() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        bench.tick({0, 0});
        bench.script.told.clear();
        bench.script.to_say.push_back(bytes_of("02 0C")); // actuators off
        for (int i = 0; i < 10'100; ++i)
            bench.tick({0, 0});
        QCOMPARE(bench.script.count("0c 01"), 40);
        QVERIFY(bench.script.count("0a 01 01 01") >= 40 &&
                bench.script.count("0a 02 01 01") >= 40); // and played
        QVERIFY(bench.device.motors_off());
        QVERIFY(bench.device.complaint().find("switched its motors off") != std::string::npos);
        bench.script.told.clear();
        for (int i = 0; i < 1000; ++i)
            bench.tick({1, 0});
        QCOMPARE(bench.script.count("0c 01"), 0);
        bench.script.to_say.push_back(bytes_of("02 0E")); // on again
        for (int i = 0; i < 1000; ++i)
            bench.tick({0, 0});
        QCOMPARE(bench.script.count("0c 01"), 0);
        QVERIFY(!bench.device.motors_off());
    }

    /// Each message tells one force as a sign of life, in turns; one that does not change is told each
    /// sixteenth time.
    void what_does_not_change_is_told_again() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        bench.tick({2, 0.5});
        bench.script.told.clear();
        for (int i = 0; i < 100; ++i)
            bench.tick({2, 0.5});
        QCOMPARE(bench.script.told.size(), std::size_t(100));
        QCOMPARE(bench.script.count("05 01"), 50);
        QCOMPARE(bench.script.count("05 02"), 50);
        bench.tick({2, 0.6});
        bench.script.told.clear();
        for (int i = 0; i < 160; ++i)
            bench.tick({2, i % 2 == 0 ? 0.5 : 0.6});
        QCOMPARE(bench.script.count("05 02"), 160);
        QCOMPARE(bench.script.count("05 01"), 10);
    }

    /// A quarter of 8 N is a quarter of 32767; a sign of the person's.
    void a_share_never_grows_by_rounding() {
        Bench bench({8.0, {1.0, -1.0}, true});
        QVERIFY(bench.device.open().ok());
        bench.script.told.clear();
        bench.tick({2.0, 2.0});
        QCOMPARE(bench.script.count("05 01 ff 1f"), 1); // 8191 of 8191.75
        QCOMPARE(bench.script.count("05 02 01 e0"), 1); // −8191
        bench.tick({50.0, 0.0});
        QCOMPARE(bench.script.count("05 01 ff 7f"), 1);
        bench.tick({-50.0, 0.0}); // no more of it than all
        QCOMPARE(bench.script.count("05 01 01 80"), 1);
        QVERIFY(bench.device.assume(16.0, {-1.0, 1.0}));
        bench.script.told.clear();
        bench.tick({4.0, 4.0});
        QCOMPARE(bench.script.count("05 01 01 e0"), 1);
        QCOMPARE(bench.script.count("05 02 ff 1f"), 1);
    }

    /// A writer that hangs in the system for 20 ms.
    void one_that_takes_nothing_is_said_and_gets_no_force_until_it_is_let_go() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        bench.tick({1, 0});
        bench.device.read(bench.now + 0.001); // what was taken is heard of here
        bench.device.read(bench.now + 0.0205);
        QVERIFY(!bench.device.motors_off());
        bench.device.read(bench.now + 0.0215);
        QVERIFY(bench.device.motors_off());
        QVERIFY(bench.device.complaint().find("does not take what this computer sends") != std::string::npos);
        bench.script.told.clear();
        bench.now += 0.0215;
        bench.tick({2, 0});
        QCOMPARE(bench.script.count("05 01 00 00"), 1);
        bench.tick({0, 0});
        bench.tick({0, 0});
        QVERIFY(!bench.device.motors_off());
        QCOMPARE(bench.device.complaint(), std::string());
        bench.tick({2, 0});
        QCOMPARE(bench.script.count("05 01 ff 1f"), 1);
    }

    void without_its_guard_it_pulls_no_more_and_says_so() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        bench.tick({1, 0});
        bench.script.diary.word = ForceGuard::Word::gone;
        bench.tick({1, 0.5});
        bench.script.told.clear();
        for (const Vec2 newtons : {Vec2(2, 0), Vec2(0, 0), Vec2(2, 1)}) {
            bench.tick(newtons);
            QVERIFY(bench.device.motors_off());
        }
        QVERIFY(bench.device.complaint().find("that watches over the motors") != std::string::npos);
        QCOMPARE(bench.script.count("05 01"), bench.script.count("05 01 00 00"));
        QCOMPARE(bench.script.count("05 02"), bench.script.count("05 02 00 00"));
    }

    void one_read_takes_64_reports() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        for (int i = 0; i < 70; ++i)
            bench.script.to_say.push_back(bytes_of("02 0E"));
        bench.tick({0, 0});
        QCOMPARE(bench.script.to_say.size(), std::size_t(6));
        bench.tick({0, 0});
        QVERIFY(bench.script.to_say.empty());
    }

    void an_effect_is_asked_for_twenty_times() {
        Bench late;
        late.script.not_ready_for = 19;
        QVERIFY(late.device.open().ok());
        Bench never;
        never.script.not_ready_for = 20;
        QVERIFY(never.device.open().error().find("does not take up a force") != std::string::npos);
        QCOMPARE(never.script.asked, 20);
    }

    void two_forces_at_one_place_are_none() {
        Bench bench;
        bench.script.same_block = true;
        QVERIFY(bench.device.open().error().find("does not take up a force") != std::string::npos);
    }

    void why_it_cannot_be_opened_is_passed_on() {
        PidJoystick device([]() -> Result<std::unique_ptr<PidTransport>> { return Error{"It is gone."}; },
                           {"a stick", "0001"}, {}, LatestWriter::Thread::caller);
        QCOMPARE(device.open().error(), std::string("It is gone."));
        QVERIFY(!device.write(SafeForce{}));
    }

    void gone_without_a_stop_it_leaves_no_force_and_no_effect() {
        Script script;
        {
            PidJoystick device(
                [&script]() -> Result<std::unique_ptr<PidTransport>> {
                    return std::unique_ptr<PidTransport>(std::make_unique<Borrowed>(script));
                },
                {"a stick", "0001"}, {8.0, {1.0, 1.0}, true}, LatestWriter::Thread::caller);
            QVERIFY(device.open().ok());
            device.read(0.001);
            device.write(safe({2.0, 2.0}, 100.0));
            device.deliver();
            script.told.clear();
        }
        for (const char* last : {"05 01 00 00", "05 02 00 00", "0b 01", "0b 02", "0c 02"})
            QVERIFY2(script.count(last) >= 1, last);
        QCOMPARE(script.opened, 0);
    }

    void other_programs_may_have_it_once_it_is_not_used() {
        Bench used;
        QVERIFY(used.device.open().ok());
        QCOMPARE(used.script.opened, 1);
        used.device.stop();
        QCOMPARE(used.script.opened, 0);
        Bench refused;
        refused.script.same_block = true;
        QVERIFY(!refused.device.open().ok());
        QCOMPARE(refused.script.opened, 0);
        Bench strange;
        strange.script.makes_sense = false;
        QVERIFY(!strange.device.open().ok());
        QCOMPARE(strange.script.opened, 0);
    }

    void opened_again_it_starts_nothing_anew() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        bench.script.to_say.push_back(bytes_of("02 0C")); // its motors are off
        for (int i = 0; i < 7000; ++i)
            bench.tick({0, 0}, 0.01);
        QVERIFY(bench.device.open().ok());
        bench.script.told.clear();
        for (int i = 0; i < 10; ++i)
            bench.tick({0, 0});
        QCOMPARE(bench.script.count("0a"), 0);
        QCOMPARE(bench.script.count("0c"), 0);
    }

    void before_it_is_opened_there_is_nothing_to_halt() {
        Bench bench;
        bench.device.halt();
        bench.device.deliver();
        bench.device.stop();
        QVERIFY(!bench.device.lost() && !bench.device.motors_off());
        QVERIFY(!bench.device.read(0.001));
        QVERIFY(bench.script.told.empty());
        QVERIFY(bench.device.open().ok());
        bench.device.stop();
        bench.script.told.clear();
        bench.device.halt(); // nor after it
        QVERIFY(bench.script.told.empty());
    }

    void what_another_program_left_ends_before_a_force_is_loaded() {
        Bench bench;
        QVERIFY(bench.device.open().ok());
        std::vector<std::vector<std::uint8_t>> first(bench.script.told.begin(),
                                                     bench.script.told.begin() + 4);
        const std::vector<std::vector<std::uint8_t>> wanted{bytes_of("0c 03"), bytes_of("0c 04"),
                                                            bytes_of("0c 01"), bytes_of("0d ff")};
        QVERIFY(first == wanted);
        for (const char* force : {"05 01 00 00", "05 02 00 00"})
            QCOMPARE(bench.script.count(force), 1);
        QCOMPARE(bench.script.count("0b"), 0); // nothing is freed that a reset has ended
        bench.script.told.clear();
        bench.device.stop();
        for (const char* last : {"0a 01 03", "0a 02 03", "0b 01", "0b 02", "0c 02"})
            QVERIFY2(bench.script.count(last) == 1, last);
    }
};

} // namespace dialogue_test

TP_TEST(dialogue_test, JoystickDialogueTest, nothing)
#include "dialogue_test.moc"
