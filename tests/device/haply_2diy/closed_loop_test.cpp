// SPDX-License-Identifier: Apache-2.0
#include "../closed_loop/closed_loop_test.hpp"

#include "../closed_loop/force_judge.hpp"
#include "board_bench.hpp"
#include "test_program.hpp"

#include <QTest>

namespace closed_loop_test {

using namespace tp;
using namespace tp::testing;

namespace {

constexpr double slack = 0.05;
/// The board itself does not limit a rate: a command after a gap carries the whole of it.
constexpr double slack_in_trouble = 0.8;

HaplyGeneration of_variant(std::size_t variant) {
    return variant == 1 ? HaplyGeneration::third : HaplyGeneration::first;
}

/// Where no command gets to the board, or only a part of one, its torque is not the program's, and moves a released
/// handle to where the same torque is another force.
std::vector<TroubleKind> board_troubles() {
    return {
        trouble(&BoardBench::line, &SerialTroubles::drop_from_board, 0.0, 0.2),
        trouble(&BoardBench::line, &SerialTroubles::drop_to_board, unbounded),
        trouble(&BoardBench::line, &SerialTroubles::garbage),
        trouble(&BoardBench::line, &SerialTroubles::half),
        trouble(&BoardBench::line, &SerialTroubles::half_write, unbounded),
        trouble(&BoardBench::line, &SerialTroubles::stall, unbounded),
        trouble(&BoardBench::line, &SerialTroubles::mute),
        pulled_cable(unbounded),
        stalled_writer(unbounded),
        {.set = of<BoardBench>([](BoardBench& bench, double, bool on) {
             if (on)
                 bench.model.power_off();
         })},
        {.set = of<BoardBench>([](BoardBench& bench, double, bool on) {
             if (on)
                 bench.guard.word = ForceGuard::Word::gone;
         })},
        letting_go(),
        late_tick(),
    };
}

DeviceUnderTest haply_2diy() {
    DeviceUnderTest device;
    device.variants = {"first generation", "third generation"};
    device.watchdogs = {0.0, 0.0};
    device.make = [](std::size_t variant, const Handle& handle, unsigned later_ms, std::uint32_t seed) {
        return std::make_unique<BoardBench>(of_variant(variant), handle.plant<HaplyPlant>(), later_ms, seed);
    };
    device.slack = [](LoopBench&, bool troubled) { return troubled ? slack_in_trouble : slack; };
    // With the quantum of the encoders, and the dry friction of the facts and a tenth of it.
    device.settling = {.masses = {0.05, 0.2},
                       .starts = {4.0, 7.0},
                       .coulombs = {0.003, 0.03},
                       .farthest = 0.3,
                       .to_and_fro = 0.6,
                       .unjudged = 0.1};
    device.interruptions = {
        {.name = "the guard ends",
         .begin = of<BoardBench>([](BoardBench& bench) { bench.guard.word = ForceGuard::Word::gone; }),
         .words = "watches over the motors",
         .end = of<BoardBench>([](BoardBench& bench) { bench.guard.word = ForceGuard::Word::here; }),
         .back_after = 0.0}};
    device.ticks = 500;
    device.troubles = board_troubles();
    device.breach = [](LoopBench& bench, double) {
        const ForceDevice& board = bench.back_end();
        return board.motors_off() && !board.lost() && board.complaint().empty()
                   ? "the motors are off and nobody says why"
                   : nullptr;
    };
    device.heal = of<BoardBench>([](BoardBench& bench) {
        const bool out = bench.unplugged();
        bench.line.troubles = {};
        bench.unplugged() = out;
    });
    return device;
}

} // namespace

class HaplyClosedLoopTest : public ClosedLoopTest {
    Q_OBJECT
public:
    HaplyClosedLoopTest() : ClosedLoopTest(haply_2diy()) {}

private slots:
    void the_force_in_truth_is_the_force_that_was_meant() {
        const auto bench = held<BoardBench>();
        const Vec2 meant = bench->loop->snapshot().force();
        QVERIFY(length(meant) > 0.3);
        QVERIFY(length(bench->felt() - meant) < 0.02 * length(meant));
    }

    void a_guard_of_an_unplugged_board_goes_on_trying() {
        const auto bench = held<BoardBench>();
        bench->unplugged() = true;
        bench->tick();
        bench->loop.reset();
        QCOMPARE(bench->guard.dismissals, 0);
        QCOMPARE(bench->guard.ends, 1);
    }

    void a_board_out_of_step_lets_go_within_30_ms_and_wants_to_be_homed() {
        const auto bench = held<BoardBench>(1);
        QVERIFY(length(bench->model.force()) > 0.3);
        bench->line.troubles.half_write = true;
        for (int ms = 0; ms < 30; ++ms) {
            bench->tick();
            QVERIFY(length(bench->model.force()) < bench->can.max_force);
        }
        QVERIFY(bench->model.force() == Vec2(0.0));
        bench->run(0.1);
        QCOMPARE(bench->loop->snapshot().fault, Fault::motors_off);
        QVERIFY(bench->device.complaint().find("lost count") != std::string::npos);
        QVERIFY(bench->device.bad_answers() > 0);
        QVERIFY(length(bench->loop->snapshot().finger() - bench->model.handle()) < 2.0);
        bench->run(1.0);
        QVERIFY(bench->model.force() == Vec2(0.0)); // nothing by itself
        bench->loop.reset();
        bench->model.place_handle(Pantograph(HaplyGeneration::third).pose_at({97.23, 82.77})->place);
        QVERIFY(bench->device.open().ok());
        QVERIFY(bench->device.home().ok());
        QVERIFY(!bench->device.motors_off());
        QCOMPARE(bench->device.complaint(), std::string());
    }

    void a_line_that_stalls_for_a_moment_is_no_loss() {
        const auto bench = held<BoardBench>();
        ForceJudge judge(
            *bench->loop, bench->can, [&bench] { return bench->felt(); }, slack);
        bench->after_tick = [&] { judge.judge(); };
        bench->line.troubles.stall = true;
        bench->run(0.012);
        bench->line.troubles.stall = false;
        bench->run(0.5);
        QCOMPARE(bench->loop->snapshot().fault, Fault::none);
        QVERIFY(!bench->device.motors_off());
        QVERIFY(length(bench->model.force()) > 0.3);
        QVERIFY2(judge.complaint.isEmpty(), qPrintable(judge.complaint));
    }
};

} // namespace closed_loop_test

TP_TEST(closed_loop_test, HaplyClosedLoopTest, nothing)
#include "closed_loop_test.moc"
