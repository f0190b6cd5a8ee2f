// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/closed_loop_test.hpp"

#include "../closed_loop/force_judge.hpp"
#include "joystick_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace closed_loop_test {

using namespace tp;
using namespace tp::testing;

namespace {

constexpr std::size_t speaks_at_rest = 3;

JoystickWire wire_of(std::size_t variant) {
    return variant == 1 ? plain_controller() : variant == 2 ? sidewinder() : open_controller();
}

/// What the smallest step of a stick's force is, of each axis at once, and what a direction of 8 bits is off
/// by.
double slack_of(const JoystickBench& bench) {
    const double step = bench.model.newtons_at_full / bench.model.wire().magnitude_full;
    return 0.005 + 2.0 * step + (bench.model.wire().direction_bytes == 1 ? 0.02 : 0.0);
}

void guard_steps_in(JoystickBench& bench) { bench.link.diary.word = ForceGuard::Word::stepped_in; }
void guard_is_here(JoystickBench& bench) { bench.link.diary.word = ForceGuard::Word::here; }
void guard_ends(JoystickBench& bench) { bench.link.diary.word = ForceGuard::Word::gone; }

std::vector<TroubleKind> joystick_troubles() {
    return {
        trouble(&JoystickBench::link, &JoystickLinkTroubles::drop),
        trouble(&JoystickBench::link, &JoystickLinkTroubles::garble),
        trouble(&JoystickBench::link, &JoystickLinkTroubles::cut),
        trouble(&JoystickBench::link, &JoystickLinkTroubles::mute),
        trouble(&JoystickBench::link, &JoystickLinkTroubles::deaf),
        pulled_cable(),
        stalled_writer(),
        trouble(&JoystickBench::model, &ModelJoystick::Troubles::safety_switch),
        {.set = of<JoystickBench>([](JoystickBench& bench, double, bool on) {
             if (on)
                 bench.model.disable();
         })},
        {.set = of<JoystickBench>([](JoystickBench& bench, double size, bool on) {
             if (on)
                 bench.place({80.0 * size - 40.0, 80.0 * std::fmod(7.0 * size, 1.0) - 40.0});
         })},
        letting_go(),
        late_tick(),
        trouble(&JoystickBench::model, &ModelJoystick::Troubles::no_power),
    };
}

std::vector<Interruption> joystick_interruptions() {
    return {
        {.name = "a writer hangs",
         .begin = [](LoopBench& bench) { bench.writer_stalled = true; },
         .within = 0.060,
         .words = "does not take",
         .fault = Fault::stale_input, // a stick at rest says that it is alive by taking what is sent
         .end = [](LoopBench& bench) { bench.writer_stalled = false; },
         .back_after = 1.0,
         .keeps_its_force = true},
        {.name = "the guard steps in",
         .begin = of<JoystickBench>(guard_steps_in),
         .end = of<JoystickBench>(guard_is_here),
         .back_after = 1.0},
        {.name = "the guard ends",
         .begin = of<JoystickBench>(guard_ends),
         .within = 0.002,
         .words = "watches over the motors",
         .end = of<JoystickBench>(guard_is_here), // one that has ended does not come back
         .back_after = 0.0},
        {.name = "the safety switch",
         .begin = of<JoystickBench>([](JoystickBench& bench) { bench.model.troubles.safety_switch = true; }),
         .words = "safety switch",
         .end = of<JoystickBench>([](JoystickBench& bench) { bench.model.troubles.safety_switch = false; }),
         .back_after = 1.0},
        {.name = "its motors go off",
         .begin = of<JoystickBench>([](JoystickBench& bench) { bench.model.disable(); }),
         .within = 0.005,
         .words = "switched its motors off",
         .lasts = 0.0,
         .end = [](LoopBench&) {}, // they are enabled again without any force first
         .back_after = 1.5},
    };
}

DeviceUnderTest force_joystick() {
    DeviceUnderTest device;
    device.variants = {"open controller", "plain controller", "sidewinder", "one that speaks at rest"};
    device.watchdogs = {0.0, 0.0, 0.0, 0.0};
    device.make = [](std::size_t variant, const Handle& handle, unsigned delay_ms, std::uint32_t seed) {
        auto bench =
            std::make_unique<JoystickBench>(wire_of(variant), handle.plant<HandlePlant>(), delay_ms, seed);
        bench->model.speaks_at_rest = variant == speaks_at_rest;
        return bench;
    };
    device.slack = [](LoopBench& bench, bool) { return slack_of(dynamic_cast<JoystickBench&>(bench)); };
    device.may_follow = [](LoopBench& bench, Vec2 before, Vec2 now, double dt) {
        const JoystickBench& stick = dynamic_cast<JoystickBench&>(bench);
        return stick.may_be_felt(before, now, dt, slack_of(stick));
    };
    device.settling = {.masses = {0.1, 0.3},
                       .starts = {2.0, 6.0},
                       .coulombs = {0.05},
                       .damping = 0.3,
                       .farthest = 0.5, // Coulomb friction over stiffness, twice
                       .to_and_fro = 0.1};
    device.interruptions = joystick_interruptions();
    device.troubles = joystick_troubles();
    device.guards = {
        {.set = of<JoystickBench>([](JoystickBench& bench, double, bool on) {
             on ? guard_steps_in(bench) : guard_is_here(bench);
         })},
        {.set = of<JoystickBench>([](JoystickBench& bench, double, bool) { guard_ends(bench); })}};
    device.heal = of<JoystickBench>([](JoystickBench& bench) {
        const bool out = bench.unplugged();
        bench.link.troubles = {};
        bench.model.troubles = {};
        bench.unplugged() = out;
    });
    return device;
}

} // namespace

class PidJoystickClosedLoopTest : public ClosedLoopTest {
    Q_OBJECT

    static void each_joystick() {
        QTest::addColumn<std::size_t>("stick");
        for (const std::size_t stick : {0u, 1u, 2u})
            QTest::addRow("stick %zu", stick) << stick;
    }

public:
    PidJoystickClosedLoopTest() : ClosedLoopTest(force_joystick()) {}

private slots:
    /// An "infinite" effect ends after 65.5 s on this stick: two and a half minutes of a held grip, and no
    /// gap.
    void the_force_outlasts_the_end_of_its_effects() {
        const auto bench = held<JoystickBench>();
        QVERIFY2(bench->loop, bench->error.c_str());
        QCOMPARE(bench->model.last_duration, 0xFFFF);
        const Vec2 held = bench->model.force();
        QVERIFY(length(held) > 0.3);
        const double slack = slack_of(*bench);
        ForceJudge judge(
            *bench->loop, bench->can, [&bench] { return bench->felt(); }, slack);
        judge.may_follow = [&](Vec2 before, Vec2 now, double dt) {
            return bench->may_be_felt(before, now, dt, slack);
        };
        double weakest = length(held);
        bench->after_tick = [&] {
            judge.judge();
            weakest = std::min(weakest, length(bench->model.force()));
        };
        bench->run(150.0);
        QVERIFY2(weakest > 0.95 * length(held), qPrintable(QString::number(weakest)));
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    void a_grip_that_does_not_move_keeps_its_force_though_the_joystick_says_nothing() {
        const auto bench = held<JoystickBench>();
        bench->run(5.0);
        bench->link.troubles.mute = true; // which cannot be told from it
        bench->run(5.0);
        QCOMPARE(bench->loop->snapshot().fault, Fault::none);
        QVERIFY(length(bench->model.force()) > 0.3);
    }

    void a_joystick_that_spoke_at_rest_and_falls_silent_lets_go() {
        const auto bench = held<JoystickBench>(speaks_at_rest);
        QVERIFY2(bench->loop, bench->error.c_str());
        bench->run(3.0);
        QCOMPARE(bench->loop->snapshot().fault, Fault::none);
        QVERIFY(length(bench->model.force()) > 0.3);
        bench->link.troubles.mute = true;
        bench->run(0.023);
        QCOMPARE(bench->loop->snapshot().fault, Fault::stale_input);
        bench->run(0.023);
        QVERIFY(bench->loop->snapshot().force() == Vec2(0.0) && bench->lets_go());
        bench->run(1.0);
        QCOMPARE(bench->loop->snapshot().fault, Fault::stale_input);
        bench->link.troubles.mute = false;
        bench->run(1.0);
        QCOMPARE(bench->loop->snapshot().fault, Fault::none);
        QVERIFY(length(bench->model.force()) > 0.3);
    }

    /// A stick that only reports changes cannot be told from one at rest; its old velocity is not held.
    void a_joystick_that_falls_silent_at_200_mm_per_s_pulls_as_the_law_has_it() {
        const auto bench = held<JoystickBench>();
        for (double y = 4.0; y > 0.5; y -= 0.2) {
            bench->move_hand(bench->middle() + Vec2(0.0, y));
            bench->tick();
        }
        bench->link.troubles.mute = true;
        bench->run(0.1);
        const ServoSnapshot view = bench->loop->snapshot();
        QCOMPARE(view.fault, Fault::none);
        constexpr double stiffness = 0.2; // N/mm, up to 4 mm
        QVERIFY(view.distance > 0.1 && view.distance < 4.0);
        QVERIFY2(std::abs(length(view.force()) - stiffness * view.distance) < 1e-3,
                 qPrintable(QString("%1 N at %2 mm").arg(length(view.force())).arg(view.distance)));
    }

    void a_guard_that_has_ended_is_not_sent_away() {
        const auto bench = held<JoystickBench>();
        guard_ends(*bench);
        bench->run(0.002);
        guard_is_here(*bench);
        bench->loop->stop();
        QCOMPARE(bench->link.diary.dismissals, 0);
    }

    void stopped_in_mid_touch_nothing_is_left_on_the_joystick_data() { each_joystick(); }
    void stopped_in_mid_touch_nothing_is_left_on_the_joystick() {
        QFETCH(std::size_t, stick);
        const auto bench = held<JoystickBench>(stick);
        QCOMPARE(bench->model.effects(), std::size_t(2));
        bench->loop->stop();
        bench->pass();
        QCOMPARE(bench->model.effects(), std::size_t(0));
    }

    void halted_while_a_writer_hangs_nothing_pulls() { // as while a signal ends the program
        const auto bench = held<JoystickBench>();
        bench->writer_stalled = true;
        bench->device.halt();
        bench->pass();
        QVERIFY(bench->lets_go());
    }
};

} // namespace closed_loop_test

TP_TEST(closed_loop_test, PidJoystickClosedLoopTest, nothing)
#include "closed_loop_test.moc"
