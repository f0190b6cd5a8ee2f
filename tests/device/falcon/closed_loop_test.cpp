// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/closed_loop_test.hpp"

#include "falcon_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <functional>

namespace closed_loop_test {

using namespace tp;
using namespace tp::testing;
using falcon::Pane;

namespace {

constexpr double slack = 0.06; ///< N: a motor unit at each arm, and what the grip moves until a force comes
constexpr double slack_in_trouble = 0.15;

FalconPlant plant_of(const Handle& handle) { return handle.plant<FalconPlant>(1000.0); }

/// A command that stays while the grip is carried elsewhere pushes there by other levers. Where its cable is out
/// its last torques stay, which are any force at the ends of its reach.
const char* beyond_its_limits(FalconBench& bench, double slack_now) {
    const double bound = slack_now == unbounded ? 1.5 : 1.05;
    const glm::dvec3 felt = bench.model.force();
    const bool within_reach = !bench.unplugged() || bench.has_watchdog;
    return within_reach && (std::hypot(felt.x, felt.y) > bound * Falcon::max_force + slack_in_trouble ||
                            std::abs(felt.z) > bound * Pane::most + slack_in_trouble)
               ? "the grip feels more than the Falcon's limits"
               : nullptr;
}

void guard_steps_in(FalconBench& bench) { bench.link.diary.word = ForceGuard::Word::stepped_in; }
void guard_is_here(FalconBench& bench) { bench.link.diary.word = ForceGuard::Word::here; }
void guard_ends(FalconBench& bench) { bench.link.diary.word = ForceGuard::Word::gone; }

/// After what loses commands the Falcon may go in one step from an old command to the newest; `breach` judges then.
std::vector<TroubleKind> falcon_troubles() {
    return {
        trouble(&FalconBench::link, &FalconTroubles::drop, unbounded),
        trouble(&FalconBench::link, &FalconTroubles::garble),
        trouble(&FalconBench::link, &FalconTroubles::cut),
        trouble(&FalconBench::link, &FalconTroubles::stalled),
        trouble(&FalconBench::link, &FalconTroubles::mute),
        trouble(&FalconBench::link, &FalconTroubles::deaf, unbounded),
        pulled_cable(unbounded),
        stalled_writer(unbounded),
        {.set = of<FalconBench>([](FalconBench& bench, double, bool on) {
             if (on)
                 bench.model.restart();
         })},
        {.set = of<FalconBench>([](FalconBench& bench, double, bool on) {
             if (bench.model.firmware_runs()) // nobody loads it in mid-touch into one that had no power
                 bench.model.run_firmware(!on);
         })},
        {.set = of<FalconBench>([](FalconBench& bench, double size, bool on) {
             if (on)
                 bench.model.place_grip(falcon_place(
                     {60.0 * size - 30.0, std::fmod(700.0 * size, 60.0) - 30.0}, 20.0 * size - 10.0));
         }),
         .slack = unbounded},
        {.set = of<FalconBench>([](FalconBench& bench, double size, bool on) {
             bench.model.move_hand(falcon_place(bench.handle(), on ? -30.0 * size : 0.0));
         })},
        letting_go(),
        late_tick(unbounded),
    };
}

std::vector<Interruption> falcon_interruptions() {
    return {
        {.name = "it forgets where it is",
         .begin = of<FalconBench>([](FalconBench& bench) { bench.model.run_firmware(false); }),
         .words = "pull the grip out",
         .end = of<FalconBench>([](FalconBench& bench) { bench.model.run_firmware(true); })},
        {.name = "the guard steps in",
         .begin = of<FalconBench>(guard_steps_in),
         .end = of<FalconBench>(guard_is_here)},
        {.name = "the guard ends",
         .begin = of<FalconBench>(guard_ends),
         .words = "watches over the motors",
         .end = of<FalconBench>(guard_is_here), // one that has ended does not come back
         .back_after = 0.0},
        {.name = "replies stay out",
         .begin = of<FalconBench>([](FalconBench& bench) { bench.link.troubles.mute = true; }),
         .within = 0.045,
         .fault = Fault::stale_input,
         .end = of<FalconBench>([](FalconBench& bench) { bench.link.troubles.mute = false; })},
    };
}

DeviceUnderTest the_falcon() {
    DeviceUnderTest device;
    device.variants = {"without a watchdog", "with a watchdog"};
    device.watchdogs = {0.0, 0.040};
    device.make = [](std::size_t variant, const Handle& handle, unsigned delay_ms, std::uint32_t seed) {
        FalconPlant plant = plant_of(handle);
        plant.watchdog_ms = variant == 1 ? 30 : 0;
        return std::make_unique<FalconBench>(plant, delay_ms, seed);
    };
    device.slack = [](LoopBench& bench, bool troubled) {
        return !troubled                                        ? slack
               : dynamic_cast<FalconBench&>(bench).has_watchdog ? unbounded
                                                                : slack_in_trouble;
    };
    device.lean = of<FalconBench>([](FalconBench& bench) { // on the pane
        bench.model.move_hand(falcon_place({0.0, 4.0}, -5.0));
        bench.run(0.3);
    });
    device.settling = {.masses = {0.15, 0.3},
                       .starts = {2.0, 4.0, 6.0, 7.5},
                       .coulombs = {0.02},
                       .damping = 0.5,
                       .farthest = 0.5, // friction holds it there
                       .to_and_fro = 0.05};
    device.interruptions = falcon_interruptions();
    device.ticks = 600;
    device.in_turn = true;
    device.grip = Held::firmly;
    device.start = [](LoopBench& bench, const std::function<double()>& share) {
        const double into = 2.0 * share() - 2.0; // mm into the pane
        dynamic_cast<FalconBench&>(bench).model.place_grip(falcon_place({0.0, 16.0 * share() - 8.0}, into));
    };
    device.troubles = falcon_troubles();
    device.guards = {{.set = of<FalconBench>([](FalconBench& bench, double, bool on) {
                          on ? guard_steps_in(bench) : guard_is_here(bench);
                      })},
                     {.set = of<FalconBench>([](FalconBench& bench, double, bool) { guard_ends(bench); })}};
    device.breach = [](LoopBench& bench, double slack_now) {
        return beyond_its_limits(dynamic_cast<FalconBench&>(bench), slack_now);
    };
    device.heal = of<FalconBench>([](FalconBench& bench) {
        const bool out = bench.unplugged();
        bench.link.troubles = {};
        bench.unplugged() = out;
    });
    return device;
}

} // namespace

class FalconClosedLoopTest : public ClosedLoopTest {
    Q_OBJECT
public:
    FalconClosedLoopTest() : ClosedLoopTest(the_falcon()) {}

private slots:
    void a_grip_that_is_let_go_in_the_pane_comes_out_and_rests() {
        for (const double mass : {0.15, 0.3}) {
            FalconPlant plant;
            plant.mass = mass;
            FalconBench bench(plant);
            bench.render({line_at(0.0)});
            bench.run(0.6);
            bench.model.place_grip(falcon_place({0.0, 0.0}, -4.0));
            double strongest = 0.0;
            for (int i = 0; i < 4000; ++i) {
                bench.tick();
                strongest = std::max(strongest, bench.model.force().z);
                QVERIFY(bench.model.force().z > -slack);
            }
            QVERIFY(strongest > 0.5);
            const double before = 1000.0 * (bench.model.grip().z - falcon::plane_z);
            QVERIFY2(before > -0.5 && before < 20.0, qPrintable(QString::number(before)));
            QVERIFY(std::abs(bench.model.force().z) < slack);
            bench.run(0.5);
            QVERIFY(std::abs(1000.0 * (bench.model.grip().z - falcon::plane_z) - before) < 0.05);
        }
    }

    void a_hand_that_leans_on_the_pane_feels_it_and_never_more_than_its_bound() {
        FalconBench bench(plant_of({.held = Held::firmly}));
        bench.render({line_at(20.0)});
        bench.run(0.6);
        double last = 0.0;
        for (double depth = 0.0; depth < 25.0; depth += 0.02) { // 20 mm/s
            bench.model.move_hand(falcon_place({0.0, 0.0}, -depth));
            bench.tick();
            const double felt = bench.model.force().z;
            QVERIFY(felt < Pane::most + slack && felt > -slack);
            QVERIFY(std::abs(felt - last) < Pane::most_rise + slack);
            last = felt;
            if (depth > 2.0 && depth < 3.0)
                QVERIFY(felt > 0.1);
        }
        QVERIFY(last > Pane::most - slack);
        bench.loop->disengage(); // as by Escape: the pane goes with everything else
        bench.run(0.025);
        QVERIFY(std::abs(bench.model.force().z) < 1e-9);
        bench.loop->engage();
        bench.run(0.1);
        QVERIFY(bench.model.force().z < 0.25 * Pane::most); // and comes again by the ramp
        bench.run(0.6);
        QVERIFY(bench.model.force().z > Pane::most - slack);
        for (double depth = 25.0; depth > -10.0; depth -= 0.1) { // 100 mm/s: nothing holds a hand back
            bench.model.move_hand(falcon_place({0.0, 0.0}, -depth));
            bench.tick();
            QVERIFY(bench.model.force().z > -slack);
        }
    }

    void a_falcon_with_stronger_motors_than_anyone_published_is_the_bound() {
        // Where a newton takes 242 units, as libnifalcon has it, the person feels less and never more.
        FalconPlant plant = plant_of({.held = Held::firmly});
        plant.units_per_newton_metre = 242.0 / 0.02418;
        FalconBench weak(plant);
        weak.render({line_at(0.0)});
        weak.place({0.0, 4.0});
        weak.run(1.0);
        const auto as_believed = held<FalconBench>();
        QVERIFY(length(as_believed->felt()) > 0.3);
        QVERIFY(length(weak.felt()) < 0.5 * length(as_believed->felt()));
        QVERIFY(!weak.can.calibrated);
    }

    void a_guard_that_has_ended_is_not_sent_away_and_a_new_one_comes_with_the_next_start() {
        const auto bench = held<FalconBench>();
        guard_ends(*bench);
        bench->run(0.003);
        guard_is_here(*bench);
        bench->loop->stop();
        QCOMPARE(bench->link.diary.dismissals, 0);
        QVERIFY(bench->device.open().ok());
        QCOMPARE(bench->device.complaint(), std::string());
    }
};

} // namespace closed_loop_test

TP_TEST(closed_loop_test, FalconClosedLoopTest, nothing)
#include "closed_loop_test.moc"
