// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/falcon.hpp"
#include "falcon_bench.hpp"
#include "safe_force.hpp"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::testing;

namespace {

/// A model and a back end on a simulated cable, not open, nothing rendered.
struct Bench {
    ModelFalcon model{falcon_image()};
    SimulatedFalconLink link{model};
    std::vector<std::uint8_t> image = falcon_image();
    std::string image_error;
    Falcon device{lend(link),
                  [this]() -> Result<std::vector<std::uint8_t>> {
                      if (!image_error.empty())
                          return Error{image_error};
                      return image;
                  },
                  "F-1", LatestWriter::Thread::caller};
    double now = 0.0;

    /// A millisecond in which nothing is wanted of it.
    std::optional<DeviceState> idle() {
        now += 0.001;
        const std::optional<DeviceState> state = device.read(now);
        device.write(SafeForce{});
        device.deliver();
        link.advance();
        return state;
    }
};

/// Open and homed, and armed by no force.
struct GuardedBench : Bench {
    GuardedBench() {
        model.run_firmware(true);
        opened = device.open().ok();
        for (int i = 0; i < 10; ++i)
            idle();
    }
    /// A millisecond in which it is to pull.
    void pull() {
        now += 0.001;
        device.read(now);
        device.write(safe({1.0, -1.0}));
        device.deliver();
        link.advance();
        link.advance();
    }
    bool pulls() const { return model.command().motors != std::array<std::int16_t, 3>{}; }
    bool opened = false;
};

} // namespace

class FalconTest : public QObject {
    Q_OBJECT
private slots:
    void it_is_loaded_and_says_what_it_can() {
        Bench bench;
        const Result<Capabilities> can = bench.device.open();
        QVERIFY2(can.ok(), can.error().c_str());
        QVERIFY(bench.model.firmware_runs());
        QCOMPARE(can->serial_number, std::string("F-1"));
        QVERIFY(!can->calibrated);
        QVERIFY(can->max_force <= 2.0 && can->max_force > 0.8);
        for (const Vec2 corner : can->workspace) // every corner is reached, before the plane and behind it
            for (const double before : {-25.0, 0.0, 20.0})
                QVERIFY(falcon::angles_at(falcon_place(corner, before)));
    }

    void what_keeps_it_from_starting_is_said() {
        {
            Bench bench;
            bench.image.clear();
            QVERIFY(bench.device.open().error().find("firmware.bin") != std::string::npos);
        }
        {
            Bench bench;
            bench.image_error = "The file is a picture.";
            QCOMPARE(bench.device.open().error(), bench.image_error);
            bench.model.run_firmware(true); // where it runs the file does not matter
            QVERIFY(bench.device.open().ok());
        }
        {
            Bench bench;
            bench.link.troubles.unplugged = true;
            QVERIFY(bench.device.open().error().find("unplugged") != std::string::npos);
            QVERIFY(!bench.device.write(SafeForce{}));
            QVERIFY(!bench.device.read(0.0));
        }
        Falcon refused([]() -> Result<std::unique_ptr<FalconLink>> { return Error{"It is busy."}; },
                       [] { return falcon_image(); }, "", LatestWriter::Thread::caller);
        QCOMPARE(refused.open().error(), std::string("It is busy."));
    }

    void without_a_guard_it_is_not_opened() {
        Bench bench;
        bench.link.troubles.no_guard = true;
        const Result<Capabilities> can = bench.device.open();
        QVERIFY2(can.error().find("nothing would watch over its motors") != std::string::npos,
                 can.error().c_str());
        QVERIFY(!bench.device.write(SafeForce{}));
    }

    void its_guard_hears_before_and_after_each_message_whether_it_pulls() {
        GuardedBench bench;
        QVERIFY(bench.opened);
        QVERIFY(!bench.link.diary.pulls);
        int before = bench.link.diary.beats;
        bench.pull();
        QVERIFY(bench.pulls());
        QVERIFY(bench.link.diary.pulls);
        QCOMPARE(bench.link.diary.beats, before + 2);
        before = bench.link.diary.beats;
        bench.idle();
        QVERIFY(!bench.link.diary.pulls);
        QCOMPARE(bench.link.diary.beats, before + 1); // no force needs no leave
        bench.pull();
        bench.device.stop();
        QVERIFY(!bench.link.diary.pulls);
        QCOMPARE(bench.link.diary.dismissals, 1);
        QCOMPARE(bench.link.diary.ends, 1);
    }

    /// The program stood still between its sign of life and what it wrote.
    void a_force_that_comes_after_its_guard_has_let_go_is_taken_back() {
        GuardedBench bench;
        bench.link.diary.before_that = {ForceGuard::Word::here, ForceGuard::Word::stepped_in};
        bench.pull();
        QVERIFY(!bench.pulls());
        QVERIFY(!bench.link.diary.pulls);
        bench.pull(); // before the servo hears of it
        QVERIFY(!bench.pulls());
        QVERIFY(bench.device.motors_off());
        bench.idle();
        QVERIFY(!bench.device.motors_off());
        bench.pull();
        QVERIFY(bench.pulls());
    }

    void what_its_guard_would_write_takes_the_force_away() {
        GuardedBench bench;
        bench.pull();
        QVERIFY(bench.pulls());
        bench.model.send(bench.link.guard_takes_away);
        bench.model.step();
        QVERIFY(!bench.pulls());
    }

    void not_homed_it_has_no_motors_and_says_how_to_home_it() {
        Bench bench;
        bench.model.run_firmware(false);
        QVERIFY(bench.device.open().ok());
        for (int i = 0; i < 20; ++i)
            bench.idle();
        QVERIFY(bench.device.motors_off());
        QVERIFY(bench.idle().has_value()); // it does speak
        QVERIFY(bench.device.complaint().find("pull the grip out as far as it goes, then push it in") !=
                std::string::npos);
        QVERIFY(bench.model.command().homing);
        QCOMPARE(bench.model.command().leds, falcon::led::red);
    }

    void homing_waits_for_the_person_and_then_knows_every_place() {
        Bench bench;
        bench.model.run_firmware(false);
        QVERIFY(bench.device.open().ok());
        int ms = 0;
        // A hand that pulls and pushes while home() waits: the model is moved by the clock of its cable.
        bench.link.each_ms = [&] {
            if (++ms == 300)
                bench.model.pull_and_push();
        };
        const Result<bool> homed = bench.device.home();
        QVERIFY2(homed.ok(), homed.error().c_str());
        QVERIFY(ms >= 300);
        QCOMPARE(bench.device.complaint(), std::string());
        bench.link.each_ms = [] {};
        const falcon::Place there = falcon_place({12.0, -7.0});
        bench.model.place_grip(there);
        std::optional<DeviceState> state;
        for (int i = 0; i < 20; ++i)
            if (const std::optional<DeviceState> now = bench.idle())
                state = now;
        QVERIFY(state);
        QVERIFY(length(state->position - Vec2(12.0, -7.0)) < 0.1);
        QVERIFY(!bench.device.motors_off());
    }

    void homing_that_nobody_helps_ends_and_says_what_to_do() {
        Bench bench;
        bench.model.run_firmware(false);
        QVERIFY(bench.device.open().ok());
        const std::string words = bench.device.home().error();
        QVERIFY2(words.find("pull the grip out as far as it goes, then push it in") != std::string::npos,
                 words.c_str());
        QVERIFY(bench.model.command().motors == (std::array<std::int16_t, 3>{}));
        QCOMPARE(bench.model.command().leds, falcon::led::blue);
        bench.link.troubles.mute = true;
        QVERIFY(bench.device.home().error().find("does not answer") != std::string::npos);
        Falcon closed(
            lend(bench.link), [] { return falcon_image(); }, "", LatestWriter::Thread::caller);
        QVERIFY(!closed.home().ok());
    }

    void a_place_that_no_hand_gets_to_is_not_believed_at_once() {
        Bench bench;
        bench.model.run_firmware(true);
        QVERIFY(bench.device.open().ok());
        std::optional<DeviceState> state;
        for (int i = 0; i < 5; ++i)
            state = bench.idle();
        QVERIFY(state && length(state->position) < 0.1);
        bench.model.place_grip(falcon_place({30.0, 0.0}));
        int ticks = 0;
        const std::uint64_t bad = bench.device.bad_readings();
        while (!(state = bench.idle()) || state->position.x < 20.0) {
            QVERIFY(!state || length(state->position) < 0.1);
            QVERIFY(++ticks < 30);
        }
        QVERIFY(ticks >= 5);
        QVERIFY(bench.device.bad_readings() > bad);
    }

    void noise_is_counted_and_changes_nothing() {
        Bench bench;
        bench.model.run_firmware(true);
        QVERIFY(bench.device.open().ok());
        bench.link.troubles.garble = 0.5;
        int heard = 0;
        for (int i = 0; i < 500; ++i)
            if (const std::optional<DeviceState> state = bench.idle()) {
                ++heard;
                QVERIFY2(length(state->position) < 5.0, qPrintable(QString::number(length(state->position))));
            }
        QVERIFY(heard > 100);
        QVERIFY(bench.device.bad_readings() > 100);
    }

    void motors_keep_the_direction_where_they_cannot_give_all() {
        const std::optional<falcon::Angles> angles = falcon::angles_at(falcon::middle);
        QVERIFY(angles);
        const std::optional<glm::dmat3> j = falcon::jacobian(falcon::middle, *angles);
        QVERIFY(j);
        const std::array<std::int16_t, 3> weak = falcon::motors_for(*j, {1.0, 2.0, 0.5});
        const std::array<std::int16_t, 3> strong = falcon::motors_for(*j, {1000.0, 2000.0, 500.0});
        int largest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            largest = std::max(largest, std::abs(strong[i]));
            QVERIFY(std::abs(strong[i] * std::abs(static_cast<double>(weak[0])) / std::abs(strong[0]) -
                             weak[i]) < 2.0);
        }
        QVERIFY(largest >= falcon::most_motor - 1 && largest <= falcon::most_motor);
        QVERIFY(falcon::motors_for(*j, {std::nan(""), 0.0, 0.0}) == (std::array<std::int16_t, 3>{}));
        const double infinite = std::numeric_limits<double>::infinity();
        QVERIFY(falcon::motors_for(*j, {0.0, infinite, 0.0}) == (std::array<std::int16_t, 3>{}));
    }

    void the_pane_only_pushes_and_is_bounded() {
        falcon::Pane pane;
        QCOMPARE(pane.force(1.0), 0.0); // nothing known
        pane.feed(0.0, falcon::plane_z + 0.001);
        QCOMPARE(pane.force(1.0), 0.0);
        double time = 0.0;
        double last = 0.0;
        for (int i = 0; i < 200; ++i) {
            pane.feed(time += 0.001, falcon::plane_z - 0.1);
            const double force = pane.force(1.0);
            QVERIFY(force - last <= falcon::Pane::most_rise + 1e-12);
            last = force;
        }
        QCOMPARE(last, 1.5); // N, however far behind it the hand is
        QVERIFY(std::abs(pane.force(0.5) - 0.5 * falcon::Pane::most) < 1e-12);
        QCOMPARE(pane.force(0.0), 0.0);
        pane.feed(time += 0.001, std::nan(""));
        QVERIFY(pane.force(1.0) <= falcon::Pane::most_rise + 1e-12);
        for (int i = 0; i < 50; ++i) // drawn out quickly, still behind the plane
            pane.feed(time += 0.001, falcon::plane_z - 0.05 + 0.001 * i);
        QCOMPARE(pane.force(1.0), 0.0);
    }

    void without_places_its_motors_go_off_even_where_the_servo_does_not_notice() {
        Bench bench;
        bench.model.run_firmware(true);
        const Result<Capabilities> can = bench.device.open();
        QVERIFY2(can.ok(), can.error().c_str());
        bench.idle();
        SafetyChain chain(SafetyLimits{}, *can, 0.001);
        SafetyInput input;
        input.fresh = true;
        input.force = {1.0, 0.0};
        chain.engage(0.0);
        const auto tick = [&] {
            bench.device.read(input.now += 0.001);
            bench.device.write(chain.pass(input));
            bench.device.deliver();
            bench.link.advance();
        };
        constexpr std::array<std::int16_t, 3> none{};
        for (int i = 0; i < 600; ++i)
            tick();
        QVERIFY(bench.model.command().motors != none);
        bench.link.troubles.mute = true;
        for (int i = 0; i < Falcon::most_unanswered + 5; ++i)
            tick();
        QVERIFY(bench.model.command().motors == none);
    }

    void its_writer_may_have_a_thread_of_its_own() {
        Bench bench;
        bench.model.run_firmware(true);
        Falcon device(
            lend(bench.link), [] { return falcon_image(); }, "F-2");
        QVERIFY(device.open().ok());
        device.halt();
        device.stop();
        device.stop();
        QVERIFY(!device.write(SafeForce{}));
    }
};

QTEST_APPLESS_MAIN(FalconTest)
#include "falcon_test.moc"
