// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/fault_schedules.hpp"
#include "../closed_loop/force_judge.hpp"
#include "board_bench.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace tp;
using tp::testing::any_trouble;
using tp::testing::BoardBench;
using tp::testing::first_schedule;
using tp::testing::ForceJudge;
using tp::testing::schedules;
using tp::testing::Trouble;

namespace {

Contour line_at(Vec2 centre, double y) {
    return contour_through("line", {{centre.x - 40.0, centre.y + y}, {centre.x + 40.0, centre.y + y}}, false);
}

class Judge : public ForceJudge {
public:
    Judge(BoardBench& bench, double slack)
        : ForceJudge(
              *bench.loop, bench.can, [&bench] { return bench.model.force(); }, slack) {}
};

HaplyPlant firm_hand() {
    HaplyPlant hand;
    hand.hand_stiffness = 0.5;
    hand.hand_damping = 5.0;
    return hand;
}

Vec2 middle_of(HaplyGeneration generation) { return Pantograph(generation).middle(); }

/// A firm hand that the device has been pulling towards a line for a second.
struct HeldAboveALine : BoardBench {
    HeldAboveALine() : BoardBench(HaplyGeneration::third, firm_hand()) {
        const Vec2 centre = middle_of(HaplyGeneration::third);
        render({line_at(centre, 0.0)});
        model.place_handle(centre + Vec2(0.0, 4.0));
        run(1.0);
    }
};

constexpr int kinds = 13;

/// Whether commands are lost or late on the way to the board, which has no watchdog.
bool beyond_reach(int kind) { return kind == 1 || kind == 4 || kind == 5 || kind == 7 || kind == 8; }

void set(BoardBench& bench, const Trouble& trouble, bool on) {
    SerialTroubles& line = bench.line.troubles;
    switch (trouble.kind) {
    case 0:
        line.drop_from_board = on ? 0.2 * trouble.size : 0.0;
        break;
    case 1:
        line.drop_to_board = on ? trouble.size : 0.0;
        break;
    case 2:
        line.garbage = on ? trouble.size : 0.0;
        break;
    case 3:
        line.half = on ? trouble.size : 0.0;
        break;
    case 4:
        line.half_write = on;
        break;
    case 5:
        line.stall = on;
        break;
    case 6:
        line.mute = on;
        break;
    case 7:
        line.unplugged = true; // and stays so
        break;
    case 8:
        bench.writer_stalled = on;
        break;
    case 9:
        if (on)
            bench.model.power_off();
        break;
    case 10:
        if (on)
            bench.guard.word = ForceGuard::Word::gone;
        break;
    case 11:
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

class HaplyClosedLoopTest : public QObject {
    Q_OBJECT

    static void both_generations() {
        QTest::addColumn<bool>("third");
        QTest::newRow("first") << false;
        QTest::newRow("third") << true;
    }
    static HaplyGeneration of(bool third) { return third ? HaplyGeneration::third : HaplyGeneration::first; }

private slots:
    /// With the quantum of the encoders, answers after one and two milliseconds, and the dry friction of the
    /// facts and a tenth of it.
    void a_released_handle_settles_on_the_line_data() { both_generations(); }
    void a_released_handle_settles_on_the_line() {
        QFETCH(bool, third);
        const Vec2 centre = middle_of(of(third));
        for (const unsigned later : {0u, 1u})
            for (const double mass : {0.05, 0.2})
                for (const double coulomb : {0.003, 0.03})
                    for (const double start : {4.0, 7.0}) {
                        HaplyPlant plant;
                        plant.mass = mass;
                        plant.coulomb = coulomb;
                        BoardBench bench(of(third), plant, later);
                        QVERIFY(bench.loop);
                        bench.render({line_at(centre, 0.0)});
                        bench.model.place_handle(centre +
                                                 Vec2(0.0, 20.0)); // out of reach until the whole force is in
                        bench.run(0.6);
                        bench.model.place_handle(centre + Vec2(0.0, start));
                        bench.run(0.1); // the jump itself is no motion
                        Judge judge(bench, 0.05);
                        bench.after_tick = [&] { judge.judge(); };
                        bench.run(3.0);
                        double swing = 0.0;
                        double lowest = 1e9;
                        double highest = -1e9;
                        for (int i = 0; i < 500; ++i) {
                            bench.tick();
                            const double y = bench.model.handle().y - centre.y;
                            swing = std::max(swing, std::abs(y));
                            lowest = std::min(lowest, y);
                            highest = std::max(highest, y);
                        }
                        const QString which =
                            QString("%1 kg, %2 ms more, %3 N, from %4: %5 mm off, %6 mm to and fro")
                                .arg(mass)
                                .arg(later)
                                .arg(coulomb)
                                .arg(start)
                                .arg(swing)
                                .arg(highest - lowest);
                        QVERIFY2(swing < 0.3, qPrintable(which));
                        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint + " " + which));
                    }
    }

    void a_hand_is_led_across_from_line_to_line_within_all_limits_data() { both_generations(); }
    void a_hand_is_led_across_from_line_to_line_within_all_limits() {
        QFETCH(bool, third);
        const Vec2 centre = middle_of(of(third));
        BoardBench bench(of(third), firm_hand());
        bench.render({line_at(centre, 4.0), line_at(centre, -4.0)});
        bench.model.place_handle(centre + Vec2(0.0, 6.0));
        bench.run(1.0);
        QCOMPARE(bench.loop->snapshot().contour, 0);
        Judge judge(bench, 0.05);
        bench.after_tick = [&] { judge.judge(); };
        double strongest_up = 0.0;
        double strongest_down = 0.0;
        for (double y = 6.0; y > -6.0; y -= 0.03) { // 30 mm/s
            bench.model.move_hand(centre + Vec2(0.0, y));
            bench.tick();
            strongest_up = std::max(strongest_up, bench.model.force().y);
            strongest_down = std::min(strongest_down, bench.model.force().y);
        }
        QCOMPARE(bench.loop->snapshot().contour, 1);
        QVERIFY(strongest_up > 0.4); // back to the first line, then on to the second
        QVERIFY(strongest_down < -0.25);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    void the_force_in_truth_is_the_force_that_was_meant() {
        HeldAboveALine bench;
        const Vec2 meant = bench.loop->snapshot().force();
        QVERIFY(length(meant) > 0.3);
        QVERIFY(length(bench.model.force() - meant) < 0.02 * length(meant));
    }

    void unplugged_in_mid_touch_a_reason_is_said() {
        HeldAboveALine bench;
        bench.line.troubles.unplugged = true;
        bench.tick();
        QCOMPARE(bench.loop->snapshot().fault, Fault::device_lost);
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bench.loop.reset();
        QCOMPARE(bench.guard.dismissals, 0); // it goes on trying
        QCOMPARE(bench.guard.ends, 1);
    }

    void a_board_out_of_step_lets_go_within_30_ms_and_wants_to_be_homed() {
        HeldAboveALine bench;
        QVERIFY(length(bench.model.force()) > 0.3);
        bench.line.troubles.half_write = true;
        for (int ms = 0; ms < 30; ++ms) {
            bench.tick();
            QVERIFY(length(bench.model.force()) < bench.can.max_force);
        }
        QVERIFY(bench.model.force() == Vec2(0.0));
        bench.run(0.1);
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("lost count") != std::string::npos);
        QVERIFY(bench.device.bad_answers() > 0);
        QVERIFY(length(bench.loop->snapshot().finger() - bench.model.handle()) < 2.0);
        bench.run(1.0);
        QVERIFY(bench.model.force() == Vec2(0.0)); // nothing by itself
        bench.loop.reset();
        bench.model.place_handle(Pantograph(HaplyGeneration::third).pose_at({97.23, 82.77})->place);
        QVERIFY(bench.device.open().ok());
        QVERIFY(bench.device.home().ok());
        QVERIFY(!bench.device.motors_off());
        QCOMPARE(bench.device.complaint(), std::string());
    }

    void without_a_guard_nothing_is_pulled() {
        HeldAboveALine bench;
        bench.guard.word = ForceGuard::Word::gone;
        bench.run(0.003);
        QVERIFY(bench.model.force() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("watches over the motors") != std::string::npos);
        bench.guard.word = ForceGuard::Word::here;
        bench.run(1.0);
        QVERIFY(bench.model.force() == Vec2(0.0));
    }

    void a_line_that_stalls_for_a_moment_is_no_loss() {
        HeldAboveALine bench;
        Judge judge(bench, 0.05);
        bench.after_tick = [&] { judge.judge(); };
        bench.line.troubles.stall = true;
        bench.run(0.012);
        bench.line.troubles.stall = false;
        bench.run(0.5);
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
        QVERIFY(!bench.device.motors_off());
        QVERIFY(length(bench.model.force()) > 0.3);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    /// Whatever goes wrong, and however much of it at once: no force beyond the limits, no hang, for every
    /// force that goes a sentence; and where the line still works in the end, none that stays when the person
    /// lets go.
    void random_troubles_never_hurt_data() { both_generations(); }
    void random_troubles_never_hurt() {
        QFETCH(bool, third);
        const Vec2 centre = middle_of(of(third));
        for (int number = first_schedule(); number < first_schedule() + schedules() / 2; ++number) {
            std::mt19937 random(static_cast<unsigned>(number) + (third ? 100000u : 0u));
            std::uniform_real_distribution<double> share(0.0, 1.0);
            HaplyPlant plant;
            plant.hand_stiffness = number % 3 == 0 ? 0.0 : 0.3;
            plant.hand_damping = number % 3 == 0 ? 0.0 : 3.0;
            BoardBench bench(of(third), plant, number % 2 == 0 ? 0u : 1u,
                             static_cast<std::uint32_t>(random()));
            QVERIFY(bench.loop);
            bench.render({line_at(centre, 3.0), line_at(centre, -3.0)});
            bench.model.place_handle(centre + Vec2(0.0, 16.0 * share(random) - 8.0));

            constexpr int ticks = 500;
            std::vector<Trouble> troubles(1 + random() % 4);
            bool out_of_hand = false;
            for (Trouble& trouble : troubles) {
                trouble = any_trouble(random, static_cast<int>(random() % kinds), ticks);
                out_of_hand = out_of_hand || beyond_reach(trouble.kind);
            }
            // The board itself does not limit a rate: a command after a gap carries the whole of it. Where no
            // command gets to it, or only a part of one, its torque is not the program's, and moves a
            // released handle to where the same torque is another force.
            Judge judge(bench, out_of_hand ? 1000.0 : 0.8);
            for (int tick = 0; tick < ticks && judge.complaint.isEmpty(); ++tick) {
                double dt = 0.001;
                for (const Trouble& trouble : troubles) {
                    if (trouble.kind == 11 && (tick == trouble.from || tick == trouble.until))
                        judge.wanted = tick == trouble.until;
                    if (tick == trouble.from)
                        set(bench, trouble, true);
                    if (tick == trouble.until)
                        set(bench, trouble, false);
                    if (tick == trouble.from && trouble.kind == 12)
                        dt = 0.001 * (2.0 + std::floor(80.0 * trouble.size));
                }
                bench.tick(dt);
                judge.judge(dt);
                const bool off = bench.device.motors_off() && !bench.device.lost();
                if (off && bench.device.complaint().empty())
                    judge.complaint = "the motors are off and nobody says why";
            }
            const bool reachable = !bench.line.troubles.unplugged;
            bench.line.troubles = {};
            bench.line.troubles.unplugged = !reachable;
            bench.writer_stalled = false;
            judge.wanted = false;
            bench.loop->disengage();
            for (int tick = 0; tick < 200 && judge.complaint.isEmpty(); ++tick) {
                bench.tick();
                judge.judge();
            }
            if (judge.complaint.isEmpty() && reachable && !bench.device.lost() &&
                bench.model.force() != Vec2(0.0))
                judge.complaint = "let go, and still a force";
            QVERIFY2(judge.complaint.isEmpty(),
                     qPrintable(QString("schedule %1: %2").arg(number).arg(judge.complaint)));
        }
    }
};

QTEST_APPLESS_MAIN(HaplyClosedLoopTest)
#include "closed_loop_test.moc"
