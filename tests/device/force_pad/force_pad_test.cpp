// SPDX-License-Identifier: Apache-2.0
#include "../until.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/pad_frames.hpp"
#include "device/open_problem.hpp"
#include "pad_bench.hpp"
#include "safe_force.hpp"

#include <QTest>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

using namespace tp;
using tp::testing::lend;
using tp::testing::PadBench;
using tp::testing::safe;
using tp::testing::until;

namespace {

/// A model pad that lives on whichever thread asks, with a gate at which a write hangs.
class GatedLink final : public ReportTransport {
public:
    std::atomic<bool> shut{false};
    std::atomic<bool> waiting{false}; ///< a write stands at the gate
    std::atomic<int> forces{0};
    std::atomic<int> last_x{0};
    std::atomic<bool> last_motors{true};

    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        const std::scoped_lock lock(mutex_);
        return link_.read(frame, wait_ms);
    }
    bool write(const pad::Frame& frame) noexcept override {
        while (shut.load()) {
            waiting.store(true);
            std::this_thread::yield();
        }
        pad::ForceFrame force;
        if (pad::decode(frame, force)) {
            last_x.store(force.x_mn);
            last_motors.store(force.motors);
            ++forces;
        }
        const std::scoped_lock lock(mutex_);
        return link_.write(frame);
    }
    void advance() {
        const std::scoped_lock lock(mutex_);
        link_.advance();
    }

private:
    std::mutex mutex_;
    ModelPad model_{pad::cable_pad()};
    SimulatedLink link_{model_};
};

/// Says what a test puts there.
struct StateScript final : ReportTransport {
    ModelPad model{pad::cable_pad()};
    SimulatedLink link{model};
    std::vector<pad::StateFrame> states;
    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        if (wait_ms > 0)
            return link.read(frame, wait_ms);
        if (states.empty())
            return Got::nothing;
        frame = pad::encode(states.front());
        states.erase(states.begin());
        return Got::report;
    }
    bool write(const pad::Frame& frame) noexcept override { return link.write(frame); }
    void say(std::uint16_t sequence, int x_um, std::uint32_t time_us = 0) {
        pad::StateFrame state;
        state.sequence = sequence;
        state.time_us = time_us;
        state.x_um = x_um;
        states.push_back(state);
    }
};

} // namespace

class ForcePadTest : public QObject {
    Q_OBJECT
private slots:
    void tells_what_the_pad_tells() {
        PadBench bench;
        QVERIFY(bench.loop);
        QCOMPARE(bench.can.serial_number, std::string("TPC-0001"));
        QCOMPARE(bench.can.name, std::string("force pad with cables"));
        QCOMPARE(bench.can.workspace.size(), std::size_t(4));
        QVERIFY(length(bench.can.workspace[2] - Vec2(100.0, 75.0)) < 1e-9);
        QCOMPARE(bench.can.max_force, 1.2);
        QCOMPARE(bench.can.resolution, 0.008);
        QCOMPARE(bench.can.delay, 0.001);
        QCOMPARE(bench.can.rate, 1000.0);
        PadBench other(pad::pantograph_pad());
        QVERIFY(other.loop);
        QCOMPARE(other.can.name, std::string("force pad with a pantograph"));
    }

    void says_where_the_knob_is() {
        PadBench bench;
        bench.model.place_knob({12.5, -34.25});
        bench.run(0.01);
        QVERIFY(length(bench.loop->snapshot().finger() - Vec2(12.5, -34.25)) < 0.01);
    }

    void opens_over_a_bad_line_too() {
        ModelPad model(pad::cable_pad());
        for (unsigned seed = 0; seed < 20; ++seed) {
            SimulatedLink link(model, 1, seed);
            link.troubles.drop = 0.2;
            link.troubles.garble = 0.2;
            ForcePad device(lend(link), LatestWriter::Thread::caller);
            const Result<Capabilities> can = device.open();
            QVERIFY2(can.ok(), can.error().c_str());
            QCOMPARE(can.value().workspace.size(), std::size_t(4));
        }
    }

    void what_does_not_answer_is_no_force_pad() {
        ModelPad model(pad::cable_pad());
        for (int trouble = 0; trouble < 3; ++trouble) {
            SimulatedLink link(model);
            link.troubles.mute = trouble == 0;
            link.troubles.garble = trouble == 1 ? 1.0 : 0.0;
            link.troubles.odd = trouble == 2 ? 1.0 : 0.0;
            ForcePad device(lend(link), LatestWriter::Thread::caller);
            const Result<Capabilities> can = device.open();
            QVERIFY(!can.ok());
            QVERIFY(can.error().find("does not answer like a force pad") != std::string::npos);
            QVERIFY(!device.read(0.0));
            QVERIFY(!device.write(SafeForce{}));
            device.halt();
            device.stop();
        }
    }

    void capabilities_that_cannot_be_are_refused() {
        const std::vector<Vec2> outline{{-100, -75}, {100, -75}, {100, 75}, {-100, 75}};
        pad::CapabilitiesFrame good;
        good.max_force_mn = 1200;
        good.continuous_force_mn = 5000;
        good.rate_hz = 1000;
        good.watchdog_ms = 30;
        const Result<Capabilities> made = capabilities_of(good, "X", outline);
        QVERIFY(made.ok());
        QCOMPARE(made.value().continuous_force, 1.2); // never above the largest
        std::set<std::string> sentences;
        const auto refuse = [&](auto change) {
            pad::CapabilitiesFrame can = good;
            std::vector<Vec2> corners = outline;
            change(can, corners);
            const Result<Capabilities> refused = capabilities_of(can, "X", corners);
            QVERIFY(!refused.ok());
            sentences.insert(refused.error());
        };
        refuse([](auto& can, auto&) { can.max_force_mn = 0; });
        refuse([](auto& can, auto&) { can.max_force_mn = 20001; });
        refuse([](auto& can, auto&) { can.rate_hz = 0; });
        refuse([](auto& can, auto&) { can.delay_us = 60000; });
        refuse([](auto& can, auto&) { can.watchdog_ms = 0; });
        refuse([](auto& can, auto&) { can.watchdog_ms = 255; });
        refuse([](auto&, auto& corners) { corners.clear(); });
        refuse([](auto&, auto& corners) { corners = {{0, 0}, {100, 0}, {200, 0}}; });
        refuse([](auto&, auto& corners) { corners[1].x = 1e6; });
        QCOMPARE(sentences.size(), std::size_t(6));
    }

    void other_programs_may_have_it_once_it_is_not_used() {
        ModelPad model(pad::cable_pad());
        SimulatedLink link(model);
        const auto users = std::make_shared<int>(0);
        ForcePad device(lend(link, users), LatestWriter::Thread::caller);
        QVERIFY(device.open().ok());
        QCOMPARE(*users, 1);
        device.stop();
        QCOMPARE(*users, 0);
        link.troubles.mute = true; // it does not say what it is
        QVERIFY(!device.open().ok());
        QCOMPARE(*users, 0);
        link.troubles.mute = false;
        {
            ForcePad forgotten(lend(link, users), LatestWriter::Thread::caller);
            QVERIFY(forgotten.open().ok());
        }
        QCOMPARE(*users, 0);
    }

    void a_force_is_rounded_towards_none() {
        const pad::ForceFrame frame = force_frame(safe({0.79996, -0.2509}));
        QCOMPARE(frame.x_mn, std::int16_t(799));
        QCOMPARE(frame.y_mn, std::int16_t(-250));
        QVERIFY(frame.motors);
        QCOMPARE(force_frame(safe({99.0, -99.0}, 100.0)).x_mn, std::int16_t(32767));
    }

    void bad_frames_are_counted_and_old_ones_do_not_move_the_finger() {
        PadBench bench;
        bench.run(0.05);
        QCOMPARE(bench.device.bad_frames(), std::uint64_t(0));
        bench.link.troubles.garble = 0.5;
        bench.run(0.1);
        QVERIFY(bench.device.bad_frames() > 10);
        QVERIFY(length(bench.loop->snapshot().finger()) < 0.1);
    }

    void an_older_state_does_not_move_the_finger_until_eight_say_that_the_pad_was_restarted() {
        StateScript script;
        ForcePad device(lend(script), LatestWriter::Thread::caller);
        QVERIFY(device.open().ok());
        script.say(500, 1000);
        script.say(499, 9000);
        script.say(500, 9000);
        const std::optional<DeviceState> first = device.read(0.0);
        QVERIFY(first && first->position.x == 1.0);
        QCOMPARE(device.bad_frames(), std::uint64_t(2));
        for (int i = 0; i < 7; ++i) {
            script.say(static_cast<std::uint16_t>(10 + i), 2000);
            const std::optional<DeviceState> next = device.read(0.0);
            QVERIFY(!next); // the two before do not lead up to them
        }
        script.say(17, 3000); // the eighth
        const std::optional<DeviceState> last = device.read(0.0);
        QVERIFY(last && last->position.x == 3.0);
    }

    /// Numbers that do not go on, as of a pad whose firmware hangs with one or a few states in its buffers.
    void a_pad_that_repeats_its_states_says_nothing_newer() {
        for (const int states : {1, 2, 3, 7}) {
            StateScript script;
            ForcePad device(lend(script), LatestWriter::Thread::caller);
            QVERIFY(device.open().ok());
            for (int i = 0; i < states; ++i)
                script.say(static_cast<std::uint16_t>(500 + i), i);
            QVERIFY(device.read(0.0));
            for (int i = 0; i < 1000; ++i) {
                script.say(static_cast<std::uint16_t>(500 + i % states), i % states);
                QVERIFY2(!device.read(0.001 * i), qPrintable(QString("%1 of %2").arg(i).arg(states)));
            }
            QCOMPARE(device.bad_frames(), std::uint64_t(1000));
        }
    }

    void a_pad_that_was_restarted_is_heard_though_each_state_comes_twice() {
        StateScript script;
        ForcePad device(lend(script), LatestWriter::Thread::caller);
        QVERIFY(device.open().ok());
        script.say(500, 1000);
        QVERIFY(device.read(0.0));
        for (std::uint16_t i = 0; i < 16; ++i) {
            script.say(static_cast<std::uint16_t>(10 + i / 2), 2000);
            QCOMPARE(device.read(0.0).has_value(), i == 14); // the eighth
        }
    }

    /// It wraps after 71.6 minutes.
    void a_reading_has_the_pads_own_clock_for_a_stamp() {
        StateScript script;
        ForcePad device(lend(script), LatestWriter::Thread::caller);
        QVERIFY(device.open().ok());
        script.say(1, 0, 0xFFFFFFFFu - 1499u);
        const std::optional<DeviceState> before = device.read(0.0);
        QVERIFY(before && std::abs(before->time - 4294.965796) < 1e-9);
        script.say(2, 0, 0xFFFFFFFFu - 499u);
        script.say(3, 0, 500u);
        const std::optional<DeviceState> after = device.read(100.0);
        QVERIFY(after && std::abs(after->time - before->time - 0.002) < 1e-9);
        script.say(4, 0, 500u); // a clock that stands still is no matter of the number
        const std::optional<DeviceState> still = device.read(100.001);
        QVERIFY(still && still->time == after->time);
    }

    void a_pad_that_was_restarted_is_heard_again_and_wants_to_be_homed() {
        PadBench bench;
        bench.run(0.5);
        bench.model.restart();
        bench.run(0.1);
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("home the pad") != std::string::npos);
        bench.loop.reset();
        QVERIFY(bench.device.open().ok());
        QVERIFY(bench.device.home().ok());
        bench.loop = std::make_unique<ServoLoop>(bench.device, bench.can, bench.clock, ServoSettings{});
        bench.run(0.1);
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
    }

    void the_writer_sends_only_the_latest_and_halt_and_stop_switch_off() {
        GatedLink link;
        ForcePad device(lend(link));
        QVERIFY(device.open().ok());
        const int before = link.forces.load();
        QVERIFY(device.write(safe({0.1, 0.0})));
        until([&] { return link.forces.load() == before + 1; });
        QCOMPARE(link.last_x.load(), 100);
        link.shut.store(true);
        QVERIFY(device.write(safe({0.2, 0.0})));
        until([&] { return link.waiting.load(); });
        for (int i = 3; i <= 9; ++i)
            QVERIFY(device.write(safe({0.1 * i, 0.0}))); // none of them waits
        link.shut.store(false);
        until([&] { return link.last_x.load() == 900 || link.last_x.load() == 899; });
        until([&] { return link.forces.load() >= before + 3; });
        QCOMPARE(link.forces.load(), before + 3); // the one in the gate and the latest
        device.halt();
        until([&] { return !link.last_motors.load(); });
        device.write(safe({0.2, 0.0}));
        until([&] { return link.last_motors.load(); });
        device.stop();
        QVERIFY(!link.last_motors.load());
        QVERIFY(!device.write(SafeForce{}));
        device.stop();
    }

    void a_stop_does_not_wait_for_a_write_that_hangs() {
        auto link = std::make_shared<GatedLink>();
        struct Shared final : ReportTransport {
            std::shared_ptr<GatedLink> held;
            std::shared_ptr<std::atomic<bool>> gone;
            ~Shared() override { gone->store(true); }
            Got read(pad::Frame& frame, int wait_ms) noexcept override { return held->read(frame, wait_ms); }
            bool write(const pad::Frame& frame) noexcept override { return held->write(frame); }
        };
        const auto gone = std::make_shared<std::atomic<bool>>(false);
        {
            ForcePad device([&]() -> Result<std::unique_ptr<ReportTransport>> {
                auto shared = std::make_unique<Shared>();
                shared->held = link;
                shared->gone = gone;
                return std::unique_ptr<ReportTransport>(std::move(shared));
            });
            QVERIFY(device.open().ok());
            link->shut.store(true);
            device.write(SafeForce{});
            until([&] { return link->waiting.load(); });
            device.stop();
            QVERIFY(!gone->load()); // still in use by the write
        }
        link->shut.store(false);
        until([&] { return gone->load(); });
    }

    void a_loop_of_its_own_threads_reads_and_writes() {
        GatedLink link;
        SteadyClock clock;
        ForcePad device(lend(link));
        Result<Capabilities> can = device.open();
        QVERIFY(can.ok());
        ServoLoop loop(device, can.value(), clock, {});
        loop.start();
        loop.engage();
        for (int i = 0; i < 200; ++i) {
            const std::uint64_t ticks = loop.snapshot().ticks;
            link.advance();
            until([&] { return loop.snapshot().ticks > ticks; });
        }
        until([&] { return link.forces.load() > 10; }); // a writer that was kept waiting sends fewer
        loop.stop();
        QVERIFY(!link.last_motors.load());
    }

    void every_reason_has_a_sentence_that_says_what_to_do() {
        std::set<std::string> sentences;
        int count = 0;
        for (const System system : {System::linux_system, System::windows, System::macos})
            for (const OpenProblem problem : {OpenProblem::permission, OpenProblem::wrong_driver}) {
                sentences.insert(sentence(problem, system, "force pad"));
                ++count;
            }
        for (const System system : {System::linux_system, System::windows}) {
            sentences.insert(sentence(OpenProblem::wrong_usb_driver, system, "force pad"));
            ++count;
        }
        for (const OpenProblem problem : {OpenProblem::busy, OpenProblem::gone, OpenProblem::other}) {
            sentences.insert(sentence(problem, System::linux_system, "force pad"));
            ++count;
        }
        for (const std::uint16_t status :
             {pad::status::not_homed, pad::status::unsure, pad::status::hot, pad::status::over_current,
              pad::status::watchdog, std::uint16_t(0)}) {
            sentences.insert(pad_sentence(status));
            ++count;
        }
        QCOMPARE(sentences.size(), static_cast<std::size_t>(count));
        for (const std::string& words : sentences)
            QVERIFY(words.ends_with('.') && words.find("pad") != std::string::npos);
        QCOMPARE(pad_sentence(pad::status::armed), std::string());
        QCOMPARE(open_problem_of(EACCES), OpenProblem::permission);
        QCOMPARE(open_problem_of(EBUSY), OpenProblem::busy);
        QCOMPARE(open_problem_of(ENODEV), OpenProblem::gone);
        QCOMPARE(sentence(OpenProblem::wrong_usb_driver, System::macos, "force pad"),
                 sentence(OpenProblem::wrong_driver, System::macos, "force pad"));
    }
};

QTEST_APPLESS_MAIN(ForcePadTest)
#include "force_pad_test.moc"
