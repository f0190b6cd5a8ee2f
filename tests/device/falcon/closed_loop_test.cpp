// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/fault_schedules.hpp"
#include "../closed_loop/force_judge.hpp"
#include "falcon_bench.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace tp;
using namespace tp::testing;
using falcon::Pane;

namespace {

constexpr double slack = 0.06; ///< N: a motor unit at each arm, and what the grip moves until a force comes

Contour line_at(double y) { return contour_through("line", {{-40.0, y}, {40.0, y}}, false); }

FalconPlant firm_hand() {
    FalconPlant hand;
    hand.hand_stiffness = 500.0;
    hand.hand_damping = 5.0;
    return hand;
}

/// A firm hand that the Falcon has been pulling towards a line for a second.
struct HeldAboveALine : FalconBench {
    explicit HeldAboveALine(const FalconPlant& plant = firm_hand()) : FalconBench(plant) {
        render({line_at(0.0)});
        model.place_grip(falcon_place({0.0, 4.0}));
        run(1.0);
    }
};

enum Kind {
    drop,
    garble,
    cut,
    stalled,
    mute,
    deaf,
    unplugged,
    writer,
    restart,
    unhomed,
    leap,
    push,
    person,
    late,
    kinds,
    guard_steps_in,
    guard_ends
};

/// After it the Falcon may go in one step from an old command to the newest.
bool loses_commands_by(int kind) {
    return kind == drop || kind == deaf || kind == unplugged || kind == writer || kind == late;
}

void set(FalconBench& bench, const Trouble& trouble, bool on) {
    FalconTroubles& link = bench.link.troubles;
    switch (trouble.kind) {
    case drop:
        link.drop = on ? trouble.size : 0.0;
        break;
    case garble:
        link.garble = on ? trouble.size : 0.0;
        break;
    case cut:
        link.cut = on ? trouble.size : 0.0;
        break;
    case stalled:
        link.stalled = on;
        break;
    case mute:
        link.mute = on;
        break;
    case deaf:
        link.deaf = on;
        break;
    case unplugged:
        link.unplugged = true; // and stays so
        break;
    case writer:
        bench.writer_stalled = on;
        break;
    case restart:
        if (on)
            bench.model.restart();
        break;
    case unhomed:
        if (bench.model.firmware_runs()) // nobody loads it in mid-touch into one that had no power
            bench.model.run_firmware(!on);
        break;
    case leap:
        if (on)
            bench.model.place_grip(
                falcon_place({60.0 * trouble.size - 30.0, std::fmod(700.0 * trouble.size, 60.0) - 30.0},
                             20.0 * trouble.size - 10.0));
        break;
    case push:
        bench.model.move_hand(falcon_place(bench.grip_mm(), on ? -30.0 * trouble.size : 0.0));
        break;
    case guard_steps_in:
        bench.link.diary.word = on ? ForceGuard::Word::stepped_in : ForceGuard::Word::here;
        break;
    case guard_ends:
        bench.link.diary.word = ForceGuard::Word::gone; // and stays so
        break;
    case person:
        if (on)
            bench.loop->disengage();
        else
            bench.loop->engage();
        break;
    default:
        break; // a late tick, which the run itself makes
    }
}

} // namespace

class FalconClosedLoopTest : public QObject {
    Q_OBJECT
private slots:
    void a_released_grip_settles_on_the_line() {
        for (const unsigned delay : {0u, 1u})
            for (const double mass : {0.15, 0.3})
                for (const double start : {2.0, 4.0, 6.0, 7.5}) {
                    FalconPlant plant;
                    plant.mass = mass;
                    plant.coulomb = 0.02;
                    plant.damping = 0.5;
                    FalconBench bench(plant, delay);
                    QVERIFY2(bench.loop, bench.error.c_str());
                    bench.render({line_at(0.0)});
                    bench.model.place_grip(
                        falcon_place({0.0, 20.0})); // out of reach until the whole force is let in
                    bench.run(0.6);
                    bench.model.place_grip(falcon_place({0.0, start}));
                    ForceJudge judge(
                        *bench.loop, bench.can, [&] { return bench.felt(); }, slack);
                    bench.after_tick = [&] { judge.judge(); };
                    bench.run(4.0);
                    double least = 1e9;
                    double most = -1e9;
                    for (int i = 0; i < 1000; ++i) {
                        bench.tick();
                        least = std::min(least, bench.grip_mm().y);
                        most = std::max(most, bench.grip_mm().y);
                    }
                    const QString which = QString("%1 kg, %2 ms, from %3 mm: %4 … %5 mm")
                                              .arg(mass)
                                              .arg(delay)
                                              .arg(start)
                                              .arg(least)
                                              .arg(most);
                    QVERIFY2(std::max(std::abs(least), std::abs(most)) < 0.5,
                             qPrintable(which)); // friction holds it there
                    QVERIFY2(most - least < 0.05, qPrintable(which));
                    QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
                }
    }

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
        FalconBench bench(firm_hand());
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

    void a_hand_is_led_across_from_line_to_line_within_all_limits() {
        FalconBench bench(firm_hand());
        bench.render({line_at(4.0), line_at(-4.0)});
        bench.model.place_grip(falcon_place({0.0, 6.0}));
        bench.run(1.0);
        QCOMPARE(bench.loop->snapshot().contour, 0);
        ForceJudge judge(
            *bench.loop, bench.can, [&] { return bench.felt(); }, slack);
        bench.after_tick = [&] { judge.judge(); };
        double strongest_up = 0.0;
        double strongest_down = 0.0;
        for (double y = 6.0; y > -6.0; y -= 0.03) { // 30 mm/s
            bench.model.move_hand(falcon_place({0.0, y}));
            bench.tick();
            strongest_up = std::max(strongest_up, bench.model.force().y);
            strongest_down = std::min(strongest_down, bench.model.force().y);
        }
        QCOMPARE(bench.loop->snapshot().contour, 1);
        QVERIFY(strongest_up > 0.4); // back to the first line, then on to the second
        QVERIFY(strongest_down < -0.25);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    void a_falcon_with_stronger_motors_than_anyone_published_is_the_bound() {
        // Where a newton takes 242 units, as libnifalcon has it, the person feels less and never more.
        FalconPlant hand = firm_hand();
        hand.units_per_newton_metre = 242.0 / 0.02418;
        HeldAboveALine weak(hand);
        HeldAboveALine as_believed;
        QVERIFY(length(as_believed.felt()) > 0.3);
        QVERIFY(length(weak.felt()) < 0.5 * length(as_believed.felt()));
        QVERIFY(!weak.can.calibrated);
    }

    void unplugged_in_mid_touch_a_reason_is_said_and_nothing_comes_back_by_itself() {
        FalconPlant hand = firm_hand();
        hand.watchdog_ms = 30;
        HeldAboveALine bench(hand);
        QVERIFY(length(bench.felt()) > 0.3);
        bench.link.troubles.unplugged = true;
        bench.tick();
        QCOMPARE(bench.loop->snapshot().fault, Fault::device_lost);
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bench.run(0.040);
        QVERIFY(bench.felt() == Vec2(0.0));
        bench.link.troubles.unplugged = false;
        bench.run(1.0);
        QVERIFY(bench.felt() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::device_lost);
    }

    void a_falcon_that_forgets_where_it_is_gets_no_force_and_says_what_to_do() {
        HeldAboveALine bench;
        bench.model.run_firmware(false);
        bench.run(0.003);
        QVERIFY(bench.felt() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("pull the grip out") != std::string::npos);
        bench.run(0.1);
        QVERIFY(bench.felt() == Vec2(0.0));
        bench.model.run_firmware(true);
        ForceJudge judge(
            *bench.loop, bench.can, [&] { return bench.felt(); }, slack);
        bench.after_tick = [&] { judge.judge(); };
        bench.run(0.8);
        QVERIFY(length(bench.felt()) > 0.3); // it came back, by the ramp
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
        QCOMPARE(bench.device.complaint(), std::string());
    }

    void every_way_out_leaves_no_force() {
        for (const int way : {0, 1, 2, 3}) {
            HeldAboveALine bench;
            bench.model.move_hand(falcon_place({0.0, 4.0}, -5.0));
            bench.run(0.3);
            QVERIFY(length(bench.felt()) > 0.3 && bench.model.force().z > 0.3);
            if (way == 0) {
                bench.device.halt();
                bench.device.deliver();
            } else if (way == 1) {
                bench.device.stop();
            } else if (way == 2) {
                bench.loop->stop();
            } else {
                bench.loop->disengage();
                for (int i = 0; i < 25; ++i)
                    bench.tick();
            }
            bench.link.advance();
            bench.link.advance();
            QVERIFY2(bench.model.force() == glm::dvec3(0.0), qPrintable(QString("way %1").arg(way)));
        }
    }

    void when_replies_stay_out_the_pane_and_the_force_go() {
        HeldAboveALine bench;
        bench.model.move_hand(falcon_place({0.0, 4.0}, -5.0));
        bench.run(0.3);
        bench.link.troubles.mute = true;
        bench.run(0.045);
        QCOMPARE(bench.loop->snapshot().fault, Fault::stale_input);
        QVERIFY(bench.model.force() == glm::dvec3(0.0));
    }

    void where_the_guard_has_stepped_in_the_force_comes_back_by_the_ramp() {
        HeldAboveALine bench;
        bench.link.diary.word = ForceGuard::Word::stepped_in;
        bench.run(0.002);
        QVERIFY(bench.felt() == Vec2(0.0));
        bench.link.diary.word = ForceGuard::Word::here;
        bench.tick();
        QVERIFY(bench.felt() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        ForceJudge judge(
            *bench.loop, bench.can, [&] { return bench.felt(); }, slack);
        bench.after_tick = [&] { judge.judge(); };
        bench.run(0.8);
        QVERIFY(length(bench.felt()) > 0.3);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
        QCOMPARE(bench.device.complaint(), std::string());
    }

    void without_a_guard_nothing_is_pulled_any_more() {
        HeldAboveALine bench;
        bench.link.diary.word = ForceGuard::Word::gone;
        bench.run(0.003);
        QVERIFY(bench.felt() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("watches over the motors") != std::string::npos);
        bench.link.diary.word = ForceGuard::Word::here; // one that has ended does not come back
        bench.run(1.0);
        QVERIFY(bench.felt() == Vec2(0.0));
        bench.loop->stop();
        QCOMPARE(bench.link.diary.dismissals, 0);
        QVERIFY(bench.device.open().ok());
        QCOMPARE(bench.device.complaint(), std::string());
    }

    /// Whatever goes wrong, and however much of it at once: no force beyond the limits, no hang, and for
    /// every force that goes a sentence.
    void random_troubles_never_hurt() {
        for (int number = first_schedule(); number < first_schedule() + schedules(); ++number) {
            std::mt19937 random(static_cast<unsigned>(number));
            std::uniform_real_distribution<double> share(0.0, 1.0);
            FalconPlant plant = number % 3 == 0 ? FalconPlant() : firm_hand();
            plant.watchdog_ms = number % 2 == 0 ? 0 : 30;
            FalconBench bench(plant, number % 4 < 2 ? 0u : 1u, static_cast<std::uint32_t>(random()));
            QVERIFY2(bench.loop, bench.error.c_str());
            bench.render({line_at(3.0), line_at(-3.0)});
            bench.model.place_grip(
                falcon_place({0.0, 16.0 * share(random) - 8.0}, 2.0 * share(random) - 2.0));

            constexpr int ticks = 600;
            std::vector<Trouble> troubles(1 + random() % 4);
            bool loses_commands = plant.watchdog_ms > 0;
            for (Trouble& trouble : troubles) {
                trouble = any_trouble(random, static_cast<int>(random() % kinds), ticks);
                loses_commands = loses_commands || loses_commands_by(trouble.kind) || trouble.kind == leap;
            }
            if (number % 4 == 0)
                troubles.push_back(
                    any_trouble(random, number % 16 == 0 ? guard_ends : guard_steps_in, ticks));
            // What a lost command leaves is judged by its size below.
            ForceJudge judge(
                *bench.loop, bench.can, [&] { return loses_commands ? Vec2(0.0) : bench.felt(); }, 0.15);
            for (int tick = 0; tick < ticks && judge.complaint.isEmpty(); ++tick) {
                double dt = 0.001;
                for (const Trouble& trouble : troubles) {
                    if (trouble.kind == person && (tick == trouble.from || tick == trouble.until))
                        judge.wanted = tick == trouble.until;
                    if (tick == trouble.from)
                        set(bench, trouble, true);
                    if (tick == trouble.until)
                        set(bench, trouble, false);
                    if (tick == trouble.from && trouble.kind == late)
                        dt = 0.001 * (2.0 + std::floor(80.0 * trouble.size));
                }
                bench.tick(dt);
                judge.judge(dt);
                const glm::dvec3 felt = bench.model.force();
                // A command that stays while the grip is carried elsewhere pushes there by other levers.
                const double bound = loses_commands ? 1.5 : 1.05;
                // Where its cable is out its last torques stay, which are any force at the ends of its reach.
                const bool within_reach = !bench.link.troubles.unplugged || plant.watchdog_ms > 0;
                if (judge.complaint.isEmpty() && within_reach &&
                    (std::hypot(felt.x, felt.y) > bound * Falcon::max_force + 0.15 ||
                     std::abs(felt.z) > bound * Pane::most + 0.15))
                    judge.complaint = QString("felt %1 %2 %3 at %4 s")
                                          .arg(felt.x)
                                          .arg(felt.y)
                                          .arg(felt.z)
                                          .arg(bench.clock.now());
            }
            QVERIFY2(judge.complaint.isEmpty(),
                     qPrintable(QString("schedule %1: %2").arg(number).arg(judge.complaint)));
        }
    }
};

QTEST_APPLESS_MAIN(FalconClosedLoopTest)
#include "closed_loop_test.moc"
