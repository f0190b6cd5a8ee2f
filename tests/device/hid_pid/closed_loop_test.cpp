// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/fault_schedules.hpp"
#include "../closed_loop/force_judge.hpp"
#include "stick_bench.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace tp;
using tp::testing::any_trouble;
using tp::testing::first_schedule;
using tp::testing::ForceJudge;
using tp::testing::schedules;
using tp::testing::StickBench;
using tp::testing::Trouble;

namespace {

HandlePlant firm_hand() {
    HandlePlant hand;
    hand.hand_stiffness = 0.5;
    hand.hand_damping = 5.0;
    return hand;
}

/// 80 mm across, `y` above the middle.
Contour line_at(double y) { return contour_through("line", {{-40.0, y}, {40.0, y}}, false); }

/// What the smallest step of a stick's force is, of each axis at once, and what a direction of 8 bits is off
/// by.
double slack_of(const StickBench& bench) {
    const double step = bench.model.newtons_at_full / bench.model.wire().magnitude_full;
    return 0.005 + 2.0 * step + (bench.model.wire().direction_bytes == 1 ? 0.02 : 0.0);
}

struct StickJudge : ForceJudge {
    explicit StickJudge(StickBench& bench) : StickJudge(bench, slack_of(bench)) {}

private:
    StickJudge(StickBench& bench, double slack)
        : ForceJudge(
              *bench.loop, bench.can, [&bench] { return bench.model.force(); }, slack) {
        may_follow = [&bench, slack](Vec2 before, Vec2 now, double dt) {
            return bench.may_be_felt(before, now, dt, slack);
        };
    }
};

/// A firm hand that the stick has been pulling towards a line for a second.
struct HeldAboveALine : StickBench {
    explicit HeldAboveALine(const StickWire& wire = open_controller()) : StickBench(wire, firm_hand()) {
        model.place_grip({0.0, 4.0});
        render({line_at(0.0)});
        run(1.0);
    }
};

constexpr int trouble_kinds = 13; ///< of the stick and its cable
constexpr int guard_steps_in = 13;
constexpr int guard_ends = 14;
constexpr int let_go = 10;
constexpr int late_tick = 11;

void set_trouble(StickBench& bench, const Trouble& trouble, bool on) {
    StickLinkTroubles& link = bench.link.troubles;
    switch (trouble.kind) {
    case 0:
        link.drop = on ? trouble.size : 0.0;
        break;
    case 1:
        link.garble = on ? trouble.size : 0.0;
        break;
    case 2:
        link.cut = on ? trouble.size : 0.0;
        break;
    case 3:
        link.mute = on;
        break;
    case 4:
        link.deaf = on;
        break;
    case 5:
        link.unplugged = true; // and stays so
        break;
    case 6:
        bench.writer_stalled = on;
        break;
    case 7:
        bench.model.troubles.safety_switch = on;
        break;
    case 8:
        if (on)
            bench.model.disable();
        break;
    case 9:
        if (on)
            bench.model.place_grip(
                {80.0 * trouble.size - 40.0, 80.0 * std::fmod(7.0 * trouble.size, 1.0) - 40.0});
        break;
    case let_go:
        if (on)
            bench.loop->disengage();
        else
            bench.loop->engage();
        break;
    case late_tick: // which the run itself makes
        break;
    case guard_steps_in:
        bench.link.diary.word = on ? ForceGuard::Word::stepped_in : ForceGuard::Word::here;
        break;
    case guard_ends:
        bench.link.diary.word = ForceGuard::Word::gone; // and stays so
        break;
    default:
        bench.model.troubles.no_power = on;
    }
}

} // namespace

class PidStickClosedLoopTest : public QObject {
    Q_OBJECT

    static void all_sticks() {
        QTest::addColumn<int>("stick");
        QTest::newRow("open controller") << 0;
        QTest::newRow("plain controller") << 1;
        QTest::newRow("sidewinder") << 2;
    }
    static StickWire wire_of(int stick) {
        return stick == 0 ? open_controller() : stick == 1 ? plain_controller() : tp::testing::sidewinder();
    }

private slots:
    void a_released_grip_settles_on_the_line_data() { all_sticks(); }
    void a_released_grip_settles_on_the_line() {
        QFETCH(int, stick);
        for (const unsigned delay : {0u, 1u})
            for (const double mass : {0.1, 0.3})
                for (const double start : {2.0, 6.0}) {
                    HandlePlant plant;
                    plant.mass = mass;
                    plant.coulomb = 0.05;
                    plant.damping = 0.3;
                    StickBench bench(wire_of(stick), plant, delay);
                    QVERIFY2(bench.loop, bench.error.c_str());
                    bench.render({line_at(0.0)});
                    bench.model.place_grip({0.0, 20.0}); // out of reach until the whole force is let in
                    bench.run(0.6);
                    bench.model.place_grip({0.0, start});
                    StickJudge judge(bench);
                    bench.after_tick = [&] { judge.judge(); };
                    bench.run(4.0);
                    double swing = 0.0;
                    const double rest = bench.model.grip().y;
                    for (int i = 0; i < 1000; ++i) {
                        bench.tick();
                        swing = std::max(swing, std::abs(bench.model.grip().y - rest));
                    }
                    const QString where = QString("%1 kg, %2 ms, from %3: %4 ± %5 mm")
                                              .arg(mass)
                                              .arg(delay)
                                              .arg(start)
                                              .arg(rest)
                                              .arg(swing);
                    QVERIFY2(swing < 0.1, qPrintable(where));
                    QVERIFY2(std::abs(rest) < 0.5,
                             qPrintable(where)); // Coulomb friction over stiffness, twice
                    QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
                }
    }

    void a_hand_is_led_across_from_line_to_line_within_all_limits_data() { all_sticks(); }
    void a_hand_is_led_across_from_line_to_line_within_all_limits() {
        QFETCH(int, stick);
        StickBench bench(wire_of(stick), firm_hand());
        QVERIFY2(bench.loop, bench.error.c_str());
        bench.model.place_grip({0.0, 6.0});
        bench.render({line_at(4.0), line_at(-4.0)});
        bench.run(1.0);
        QCOMPARE(bench.loop->snapshot().contour, 0);
        StickJudge judge(bench);
        bench.after_tick = [&] { judge.judge(); };
        double strongest_up = 0.0;
        double strongest_down = 0.0;
        for (double y = 6.0; y > -6.0; y -= 0.03) { // 30 mm/s
            bench.model.move_hand({0.0, y});
            bench.tick();
            strongest_up = std::max(strongest_up, bench.model.force().y);
            strongest_down = std::min(strongest_down, bench.model.force().y);
        }
        QCOMPARE(bench.loop->snapshot().contour, 1);
        QVERIFY(strongest_up > 0.4); // back to the first line, then on to the second
        QVERIFY(strongest_down < -0.25);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    /// An "infinite" effect ends after 65.5 s on this stick: two and a half minutes of a held grip, and no
    /// gap.
    void the_force_outlasts_the_end_of_its_effects() {
        HeldAboveALine bench;
        QVERIFY2(bench.loop, bench.error.c_str());
        QCOMPARE(bench.model.last_duration, 0xFFFF);
        const Vec2 held = bench.model.force();
        QVERIFY(length(held) > 0.3);
        StickJudge judge(bench);
        double weakest = length(held);
        bench.after_tick = [&] {
            judge.judge();
            weakest = std::min(weakest, length(bench.model.force()));
        };
        bench.run(150.0);
        QVERIFY2(weakest > 0.95 * length(held), qPrintable(QString::number(weakest)));
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    void a_grip_that_does_not_move_keeps_its_force_though_the_stick_says_nothing() {
        HeldAboveALine bench;
        bench.run(5.0);
        bench.link.troubles.mute = true; // which cannot be told from it
        bench.run(5.0);
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
        QVERIFY(length(bench.model.force()) > 0.3);
    }

    void unplugged_in_mid_touch_a_reason_is_said() {
        HeldAboveALine bench;
        bench.link.troubles.unplugged = true;
        bench.tick();
        QCOMPARE(bench.loop->snapshot().fault, Fault::device_lost);
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
    }

    void a_writer_that_hangs_is_told_and_what_comes_after_it_is_no_force() {
        HeldAboveALine bench;
        bench.writer_stalled = true;
        bench.run(0.060);
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("does not take") != std::string::npos);
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bench.writer_stalled = false;
        bench.run(0.002);
        QVERIFY(length(bench.model.force()) < 0.1);
        StickJudge judge(bench);
        bench.after_tick = [&] { judge.judge(); };
        bench.run(1.0);
        QVERIFY(length(bench.model.force()) > 0.3); // it came back, by the ramp
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
        QCOMPARE(bench.device.complaint(), std::string());
    }

    void where_the_guard_has_stepped_in_the_force_comes_back_by_the_ramp() {
        HeldAboveALine bench;
        bench.link.diary.word = ForceGuard::Word::stepped_in;
        bench.tick();
        QVERIFY(bench.model.force() == Vec2(0.0));
        bench.link.diary.word = ForceGuard::Word::here;
        bench.tick();
        QVERIFY(bench.model.force() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        StickJudge judge(bench);
        bench.after_tick = [&] { judge.judge(); };
        bench.run(1.0);
        QVERIFY(length(bench.model.force()) > 0.3);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
        QCOMPARE(bench.device.complaint(), std::string());
    }

    void without_a_guard_nothing_is_pulled_any_more() {
        HeldAboveALine bench;
        bench.link.diary.word = ForceGuard::Word::gone;
        bench.run(0.002);
        QVERIFY(bench.model.force() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("watches over the motors") != std::string::npos);
        bench.link.diary.word = ForceGuard::Word::here; // one that has ended does not come back
        bench.run(1.0);
        QVERIFY(bench.model.force() == Vec2(0.0));
        bench.loop->stop();
        QCOMPARE(bench.link.diary.dismissals, 0);
    }

    void a_safety_switch_is_told_and_the_force_comes_back_by_the_ramp() {
        HeldAboveALine bench;
        bench.model.troubles.safety_switch = true;
        bench.run(0.1);
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("safety switch") != std::string::npos);
        QVERIFY(bench.model.force() == Vec2(0.0));
        bench.model.troubles.safety_switch = false;
        StickJudge judge(bench);
        bench.after_tick = [&] { judge.judge(); };
        bench.run(1.0);
        QVERIFY(length(bench.model.force()) > 0.3);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    void motors_that_went_off_are_enabled_again_without_any_force_first() {
        HeldAboveALine bench;
        bench.model.disable();
        for (int i = 0; i < 5 && bench.loop->snapshot().fault == Fault::none; ++i)
            bench.tick();
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("switched its motors off") != std::string::npos);
        bench.run(0.1);
        QVERIFY(length(bench.model.force()) < 0.15);
        StickJudge judge(bench);
        bench.after_tick = [&] { judge.judge(); };
        bench.run(1.5);
        QVERIFY(length(bench.model.force()) > 0.3);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }

    void stopped_in_mid_touch_nothing_pulls_and_nothing_is_left_on_the_stick_data() { all_sticks(); }
    void stopped_in_mid_touch_nothing_pulls_and_nothing_is_left_on_the_stick() {
        QFETCH(int, stick);
        HeldAboveALine bench(wire_of(stick));
        QVERIFY(length(bench.model.force()) > 0.3);
        QCOMPARE(bench.model.effects(), std::size_t(2));
        bench.loop->stop();
        bench.link.advance();
        QVERIFY(bench.model.force() == Vec2(0.0));
        QCOMPARE(bench.model.effects(), std::size_t(0));
    }

    void halted_in_mid_touch_nothing_pulls() {
        HeldAboveALine bench;
        bench.writer_stalled = true; // as a writer that hangs while a signal ends the program
        bench.device.halt();
        bench.link.advance();
        QVERIFY(bench.model.force() == Vec2(0.0));
    }

    /// Whatever goes wrong, and however much of it at once: no force beyond the limits, no hang, and for
    /// every force that goes a sentence.
    void random_troubles_never_hurt_data() { all_sticks(); }
    void random_troubles_never_hurt() {
        QFETCH(int, stick);
        for (int number = first_schedule(); number < first_schedule() + (schedules() + 2) / 3; ++number) {
            std::mt19937 random(static_cast<unsigned>(number) + 100000u * static_cast<unsigned>(stick));
            std::uniform_real_distribution<double> share(0.0, 1.0);
            HandlePlant plant;
            plant.hand_stiffness = number % 3 == 0 ? 0.0 : 0.3;
            plant.hand_damping = number % 3 == 0 ? 0.0 : 3.0;
            StickBench bench(wire_of(stick), plant, number % 2 == 0 ? 0u : 1u,
                             static_cast<std::uint32_t>(random()));
            QVERIFY(bench.loop);
            bench.model.place_grip({0.0, 16.0 * share(random) - 8.0});
            bench.render({line_at(3.0), line_at(-3.0)});

            constexpr int ticks = 1000;
            std::vector<Trouble> troubles(1 + random() % 4);
            for (Trouble& trouble : troubles)
                trouble = any_trouble(random, static_cast<int>(random() % trouble_kinds), ticks);
            if (number % 4 == 0)
                troubles.push_back(
                    any_trouble(random, number % 16 == 0 ? guard_ends : guard_steps_in, ticks));
            StickJudge judge(bench);
            for (int tick = 0; tick < ticks && judge.complaint.isEmpty(); ++tick) {
                double dt = 0.001;
                for (const Trouble& trouble : troubles) {
                    if (trouble.kind == let_go && (tick == trouble.from || tick == trouble.until))
                        judge.wanted = tick == trouble.until;
                    if (tick == trouble.from)
                        set_trouble(bench, trouble, true);
                    if (tick == trouble.until)
                        set_trouble(bench, trouble, false);
                    if (tick == trouble.from && trouble.kind == late_tick)
                        dt = 0.001 * (2.0 + std::floor(80.0 * trouble.size));
                }
                bench.tick(dt);
                judge.judge(dt);
            }
            QVERIFY2(judge.complaint.isEmpty(),
                     qPrintable(QString("schedule %1: %2").arg(number).arg(judge.complaint)));
        }
    }
};

QTEST_APPLESS_MAIN(PidStickClosedLoopTest)
#include "closed_loop_test.moc"
