// SPDX-License-Identifier: Apache-2.0
// The back end before a motor: what is felt, for how long, and what is taken from the heap for it.
#include "counted_allocations.hpp"
#include "motor_bench.hpp"

#include <QTest>

#include <cerrno>
#include <cstdint>

using namespace tp;
using tp::testing::MotorBench;

namespace {

constexpr double ms = 0.001;

} // namespace

class FeedbackOutputTest : public QObject {
    Q_OBJECT
private slots:
    void a_tick_is_felt_as_strongly_as_told_and_ends_by_itself() {
        MotorBench bench(FeedbackKind::sine);
        QVERIFY(bench.output.open().ok());
        bench.run(0.1);
        QCOMPARE(bench.motor.shakes(), 0.0);
        QVERIFY(bench.output.tick(Tick(0.6, 0.5, 0.02)));
        bench.run(0.02 - ms);
        QVERIFY(std::abs(bench.motor.shakes() - 0.6) < 1e-4);
        QVERIFY(std::abs(bench.motor.shakes_for() - (0.02 - ms)) < 1e-9);
        bench.run(ms);
        QCOMPARE(bench.motor.shakes(), 0.0);
        QCOMPARE(bench.motor.beginnings(), std::uint64_t(1));
    }
    void a_motor_shakes_until_it_can_be_felt() {
        MotorBench bench(FeedbackKind::motor);
        QVERIFY(bench.output.open().ok());
        QVERIFY(bench.output.tick(Tick(1.0, 0.5, 0.008)));
        bench.run(0.039);
        QCOMPARE(bench.motor.shakes(), 1.0);
        bench.run(ms);
        QCOMPARE(bench.motor.shakes(), 0.0);
    }
    void a_tick_takes_the_place_of_the_one_under_way() {
        MotorBench bench(FeedbackKind::sine);
        QVERIFY(bench.output.open().ok());
        QVERIFY(bench.output.tick(Tick(1.0, 0.5, 0.05)));
        bench.run(0.03);
        QVERIFY(bench.output.tick(Tick(0.2, 0.5, 0.01)));
        bench.run(ms);
        QVERIFY(std::abs(bench.motor.shakes() - 0.2) < 1e-4);
        bench.run(0.01);
        QCOMPARE(bench.motor.shakes(), 0.0);
    }
    void halted_nothing_is_felt_at_once() {
        MotorBench bench(FeedbackKind::motor);
        QVERIFY(bench.output.open().ok());
        QVERIFY(bench.output.tick(Tick(1.0, 0.5, 0.05)));
        bench.run(0.01);
        bench.output.halt();
        bench.output.deliver();
        QCOMPARE(bench.motor.shakes(), 0.0);
    }
    void stopped_or_gone_with_its_program_it_gives_its_place_back_and_is_still() {
        for (const bool stopped : {true, false}) {
            ModelMotor motor(FeedbackKind::motor, 1);
            {
                FeedbackOutput output(
                    {"Twin motors", ""},
                    [&motor]() -> Result<std::unique_ptr<FeedbackNode>> {
                        return std::unique_ptr<FeedbackNode>(std::make_unique<SimulatedFeedbackNode>(motor));
                    },
                    LatestWriter::Thread::caller, [&motor] { return motor.now(); });
                QVERIFY(output.open().ok());
                QCOMPARE(motor.free_places(), 0u);
                QVERIFY(output.tick(Tick(1.0, 0.5, 0.05)));
                output.deliver();
                QVERIFY(motor.shakes() > 0.0);
                if (stopped) {
                    output.stop();
                    QCOMPARE(motor.shakes(), 0.0);
                }
            }
            QCOMPARE(motor.shakes(), 0.0);
            QCOMPARE(motor.free_places(), 1u);
        }
    }
    void two_programs_share_a_motor_as_long_as_it_has_room() {
        ModelMotor motor(FeedbackKind::motor, 1);
        const auto open_node = [&motor]() -> Result<std::unique_ptr<FeedbackNode>> {
            return std::unique_ptr<FeedbackNode>(std::make_unique<SimulatedFeedbackNode>(motor));
        };
        FeedbackOutput first({"Twin motors", ""}, open_node, LatestWriter::Thread::caller);
        FeedbackOutput second({"Twin motors", ""}, open_node, LatestWriter::Thread::caller);
        QVERIFY(first.open().ok());
        const auto refused = second.open();
        QVERIFY(!refused.ok());
        QVERIFY(refused.error().find("Close them and try again.") != std::string::npos);
        first.stop();
        QVERIFY(second.open().ok());
    }

    /// As Linux has it: 16 effects on most devices, and no wave without a period.
    void a_motor_keeps_sixteen_effects_and_takes_no_wave_without_a_period() {
        ModelMotor motor(FeedbackKind::sine);
        SimulatedFeedbackNode node(motor);
        QCOMPARE(motor.free_places(), 16u);
        QCOMPARE(node.upload({1, 0, 0, 10}), EINVAL);
        QCOMPARE(motor.free_places(), 16u);
        QCOMPARE(node.upload({1, 0, 1, 10}), 0);
        QCOMPARE(motor.free_places(), 15u);
        motor.troubles.refuses = true;
        QCOMPARE(node.upload({1, 0, 1, 10}), EIO);
        QCOMPARE(node.play(true), EIO);
        QCOMPARE(motor.beginnings(), std::uint64_t(0));
        motor.troubles.unplugged = true;
        QCOMPARE(node.upload({1, 0, 1, 10}), ENODEV);
        QCOMPARE(node.play(true), ENODEV);
    }

    void a_thousand_ticks_take_nothing_from_the_heap() {
        MotorBench bench(FeedbackKind::two_motors);
        QVERIFY(bench.output.open().ok());
        testing::allocations = 0;
        testing::counting = true;
        bool taken = true;
        for (int i = 0; i < 1000; ++i) {
            taken = bench.output.tick(Tick(0.001 * i, 0.5, 0.01)) && bench.output.resist(0.5) && taken;
            bench.run(0.02);
        }
        bench.output.halt();
        testing::counting = false;
        QVERIFY(taken);
        QCOMPARE(testing::allocations.load(), 0L);
        QVERIFY(bench.motor.beginnings() > 900);
    }
};

QTEST_APPLESS_MAIN(FeedbackOutputTest)
#include "feedback_output_test.moc"
