// SPDX-License-Identifier: Apache-2.0
// What a guard and a thread of its own do with a stick's forces.
#include "../until.hpp"
#include "joystick_to_open.hpp"
#include "resting_stick.hpp"
#include "safe_force.hpp"

#include <QTest>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>

using namespace tp;
using namespace tp::testing;

namespace {

/// What a stick takes from any thread.
struct Taken {
    std::atomic<int> forces{0};
    std::atomic<int> let_go_past_the_writer{0};
    std::atomic<bool> shut{false}; ///< a write hangs as long
    std::atomic<bool> waiting{false};
    std::atomic<bool> closed{false};
    GuardDiary diary;
};

class Taker final : public RestingStick {
public:
    explicit Taker(std::shared_ptr<Taken> taken) : taken_(std::move(taken)) {}
    ~Taker() override { taken_->closed.store(true); }
    Taker(const Taker&) = delete;
    Taker& operator=(const Taker&) = delete;
    Got read(hid::Report&, int) noexcept override { return Got::nothing; }
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

class WatchedJoystickTest : public QObject {
    Q_OBJECT
private slots:
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

    void what_its_guard_would_write_takes_the_force_away_data() { each_stick(); }
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

QTEST_APPLESS_MAIN(WatchedJoystickTest)
#include "watched_joystick_test.moc"
