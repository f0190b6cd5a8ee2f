// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/fault_schedules.hpp"
#include "../closed_loop/force_judge.hpp"
#include "pad_bench.hpp"

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
using tp::testing::PadBench;
using tp::testing::schedules;
using tp::testing::Trouble;

namespace {

Contour line_at(Vec2 centre, double y) {
    return contour_through("line", {{centre.x - 40.0, centre.y + y}, {centre.x + 40.0, centre.y + y}}, false);
}

/// Judges what the knob of a bench feels.
class Judge : public ForceJudge {
public:
    Judge(PadBench& bench, double slack)
        : ForceJudge(
              *bench.loop, bench.can, [&bench] { return bench.model.force(); }, slack) {}
};

constexpr int kinds = 14;

void set(PadBench& bench, const Trouble& trouble, bool on) {
    LinkTroubles& link = bench.link.troubles;
    switch (trouble.kind) {
    case 0:
        link.drop = on ? trouble.size : 0.0;
        break;
    case 1:
        link.garble = on ? trouble.size : 0.0;
        break;
    case 2:
        link.odd = on ? trouble.size : 0.0;
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
        bench.model.troubles.celsius = on ? 80 : 25;
        break;
    case 8:
        bench.model.troubles.current_ma = on ? 2000 : 100;
        break;
    case 9:
        bench.model.troubles.slip_mm[static_cast<std::size_t>(4.0 * trouble.size) % 4] =
            on ? 6.0 * trouble.size - 3.0 : 0.0;
        break;
    case 10:
        if (on)
            bench.model.restart();
        break;
    case 11:
        if (on)
            bench.model.place_knob(glm::mix(bench.can.workspace[0], bench.can.workspace[2],
                                            Vec2(trouble.size, std::fmod(7.0 * trouble.size, 1.0))));
        break;
    case 12:
        if (on)
            bench.loop->disengage();
        else
            bench.loop->engage();
        break;
    default:
        break; // a late tick, which the run itself makes
    }
}

/// A firm hand that the pad has been pulling towards a line for a second.
struct HeldAboveALine : PadBench {
    HeldAboveALine() : PadBench(pad::cable_pad(), firm_hand()) {
        render({line_at({0, 0}, 0.0)});
        model.place_knob({0.0, 4.0});
        run(1.0);
    }
    static PadPlant firm_hand() {
        PadPlant hand;
        hand.hand_stiffness = 0.5;
        hand.hand_damping = 5.0;
        return hand;
    }
};

} // namespace

class ForcePadClosedLoopTest : public QObject {
    Q_OBJECT

    static void both_pads() {
        QTest::addColumn<bool>("pantograph");
        QTest::newRow("cables") << false;
        QTest::newRow("pantograph") << true;
    }
    static pad::PadConfig config_of(bool pantograph) {
        return pantograph ? pad::pantograph_pad() : pad::cable_pad();
    }

private slots:
    void a_released_knob_settles_on_the_line_data() { both_pads(); }
    void a_released_knob_settles_on_the_line() {
        QFETCH(bool, pantograph);
        for (const unsigned delay : {0u, 1u})
            for (const double mass : {0.05, 0.2})
                for (const double start : {2.0, 4.0, 6.0, 7.5}) {
                    PadPlant plant;
                    plant.mass = mass;
                    plant.coulomb = 0.0;
                    plant.damping = 0.1;
                    PadBench bench(config_of(pantograph), plant, delay);
                    const Vec2 centre = bench.model.knob();
                    bench.render({line_at(centre, 0.0)});
                    bench.model.place_knob(centre +
                                           Vec2(0.0, 20.0)); // out of reach until the whole force is let in
                    bench.run(0.6);
                    bench.model.place_knob(centre + Vec2(0.0, start));
                    Judge judge(bench, 0.02);
                    bench.after_tick = [&] { judge.judge(); };
                    bench.run(4.0);
                    double swing = 0.0;
                    for (int i = 0; i < 1000; ++i) {
                        bench.tick();
                        swing = std::max(swing, std::abs(bench.model.knob().y - centre.y));
                    }
                    QVERIFY2(swing < 0.1,
                             qPrintable(QString("%1 kg, %2 ms: %3 mm").arg(mass).arg(delay).arg(swing)));
                    QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
                }
    }

    void a_hand_is_led_across_from_line_to_line_within_all_limits_data() { both_pads(); }
    void a_hand_is_led_across_from_line_to_line_within_all_limits() {
        QFETCH(bool, pantograph);
        PadPlant hand;
        hand.hand_stiffness = 0.5;
        hand.hand_damping = 5.0;
        PadBench bench(config_of(pantograph), hand);
        const Vec2 centre = bench.model.knob();
        bench.render({line_at(centre, 4.0), line_at(centre, -4.0)});
        bench.model.place_knob(centre + Vec2(0.0, 6.0));
        bench.run(1.0);
        QCOMPARE(bench.loop->snapshot().contour, 0);
        Judge judge(bench, 0.02);
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

    void unplugged_in_mid_touch_the_pad_lets_go_and_a_reason_is_said() {
        HeldAboveALine bench;
        QVERIFY(length(bench.model.force()) > 0.3);
        bench.link.troubles.unplugged = true;
        bench.tick();
        QCOMPARE(bench.loop->snapshot().fault, Fault::device_lost);
        QVERIFY(bench.loop->snapshot().force() == Vec2(0.0));
        bench.run(0.032); // the watchdog in the pad
        QVERIFY(bench.model.force() == Vec2(0.0));
        bench.link.troubles.unplugged = false; // plugged in again: nothing by itself
        bench.run(1.0);
        QVERIFY(bench.model.force() == Vec2(0.0));
    }

    void a_writer_that_hangs_is_noticed_by_the_pad_and_told_by_the_servo() {
        HeldAboveALine bench;
        bench.writer_stalled = true;
        bench.run(0.040);
        QVERIFY(bench.model.force() == Vec2(0.0));
        QCOMPARE(bench.loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench.device.complaint().find("heard nothing") != std::string::npos);
        bench.run(0.100);
        bench.writer_stalled = false;
        Judge judge(bench, 0.02);
        bench.after_tick = [&] { judge.judge(); };
        bench.run(0.8);
        QVERIFY(length(bench.model.force()) > 0.3); // it came back, by the ramp
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
        QCOMPARE(bench.device.complaint(), std::string());
    }

    void when_the_servo_stands_still_the_pad_lets_go() {
        PadPlant hand;
        hand.hand_stiffness = 0.5;
        PadBench bench(pad::cable_pad(), hand);
        bench.render({line_at({0, 0}, 0.0)});
        bench.model.place_knob({0.0, 4.0});
        bench.run(1.0);
        QVERIFY(length(bench.model.force()) > 0.3);
        for (int i = 0; i < 35; ++i) {
            bench.device.deliver(); // the writer lives, and has nothing new
            bench.link.advance();
        }
        QVERIFY(bench.model.force() == Vec2(0.0));
    }

    /// Whatever goes wrong, and however much of it at once: no force beyond the limits, none without a hand
    /// on it after an unplug, no hang, and for every force that goes a sentence.
    void random_troubles_never_hurt_data() { both_pads(); }
    void random_troubles_never_hurt() {
        QFETCH(bool, pantograph);
        for (int number = first_schedule(); number < first_schedule() + schedules() / 2; ++number) {
            std::mt19937 random(static_cast<unsigned>(number) + (pantograph ? 100000u : 0u));
            std::uniform_real_distribution<double> share(0.0, 1.0);
            PadPlant plant;
            plant.hand_stiffness = number % 3 == 0 ? 0.0 : 0.3;
            plant.hand_damping = number % 3 == 0 ? 0.0 : 3.0;
            PadBench bench(config_of(pantograph), plant, number % 2 == 0 ? 0u : 1u,
                           static_cast<std::uint32_t>(random()));
            QVERIFY(bench.loop);
            const Vec2 centre = bench.model.knob();
            bench.render({line_at(centre, 3.0), line_at(centre, -3.0)});
            bench.model.place_knob(centre + Vec2(0.0, 16.0 * share(random) - 8.0));

            constexpr int ticks = 1000;
            std::vector<Trouble> troubles(1 + random() % 4);
            bool slips = false;
            for (Trouble& trouble : troubles) {
                trouble = any_trouble(random, static_cast<int>(random() % kinds), ticks);
                slips = slips || trouble.kind == 9;
            }
            // A slip below what the residual shows puts the pad's idea of its cables' directions off by some
            // degrees.
            Judge judge(bench, slips ? 0.15 : 0.02);
            int unplugged_for = 0;
            for (int tick = 0; tick < ticks && judge.complaint.isEmpty(); ++tick) {
                double dt = 0.001;
                for (const Trouble& trouble : troubles) {
                    if (trouble.kind == 12 && (tick == trouble.from || tick == trouble.until))
                        judge.wanted = tick == trouble.until;
                    if (tick == trouble.from)
                        set(bench, trouble, true);
                    if (tick == trouble.until)
                        set(bench, trouble, false);
                    if (tick == trouble.from && trouble.kind == 13)
                        dt = 0.001 * (2.0 + std::floor(80.0 * trouble.size));
                }
                bench.tick(dt);
                judge.judge(dt);
                unplugged_for = bench.link.troubles.unplugged ? unplugged_for + 1 : 0;
                if (unplugged_for > 35 && bench.model.force() != Vec2(0.0))
                    judge.complaint = "unplugged, and still a force";
            }
            QVERIFY2(judge.complaint.isEmpty(),
                     qPrintable(QString("schedule %1: %2").arg(number).arg(judge.complaint)));
        }
    }
};

QTEST_APPLESS_MAIN(ForcePadClosedLoopTest)
#include "closed_loop_test.moc"
