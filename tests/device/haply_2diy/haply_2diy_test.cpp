// SPDX-License-Identifier: Apache-2.0
#include "board_bench.hpp"
#include "device/haply_2diy/found_boards.hpp"
#include "device/open_problem.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <memory>
#include <string>
#include <vector>

namespace haply_2diy_test {

using namespace tp;
using tp::testing::BoardBench;

namespace {

/// The benches' opener over any line.
Haply2diy::Opener over(SerialLine& line, GuardDiary& guard, const HomedNote& note = {}) {
    return [&line, &guard, note]() -> Result<Haply2diy::Board> {
        return Haply2diy::Board{std::make_unique<tp::testing::BorrowedLine>(line),
                                std::make_unique<SimulatedGuard>(guard), note, "X"};
    };
}

} // namespace

class HaplyBackEndTest : public QObject {
    Q_OBJECT
private slots:
    void tells_what_it_can() {
        BoardBench bench;
        QVERIFY(bench.loop);
        QCOMPARE(bench.can.name, std::string("Haply 2diy"));
        QCOMPARE(bench.can.serial_number, std::string("7523031393535120A0D1"));
        QVERIFY(std::abs(bench.can.max_force - 1.73) < 0.01);
        QVERIFY(!bench.can.calibrated);
        QVERIFY(bench.can.workspace.size() > 20);
        QVERIFY(bench.can.continuous_force < bench.can.max_force);
    }

    void says_where_the_handle_is() {
        BoardBench bench;
        bench.model.place_handle({40.0, 90.0});
        bench.run(0.02);
        QVERIFY(length(bench.loop->snapshot().finger() - bench.model.handle()) < 0.2);
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
    }

    void a_new_board_pulls_nothing_before_it_is_homed() {
        ModelBoard model(HaplyGeneration::third);
        SimulatedLine line(model);
        GuardDiary guard;
        Haply2diy device(HaplyGeneration::third, over(line, guard), LatestWriter::Thread::caller);
        QCOMPARE(device.complaint(), std::string());
        QVERIFY(device.open().ok());
        QVERIFY(device.motors_off());
        QVERIFY(device.complaint().find("does not know where its arms are") != std::string::npos);
        QVERIFY(device.home().ok());
        QVERIFY(!device.motors_off());
        QCOMPARE(device.complaint(), std::string());
        device.stop();
        QCOMPARE(guard.dismissals, 1);
        QCOMPARE(guard.ends, 1);
        QVERIFY(model.set_up());
    }

    void a_homed_board_that_kept_its_power_need_not_be_homed_again() {
        const QTemporaryDir folder;
        const HomedNote note(folder.filePath("note").toStdString(), HaplyGeneration::third);
        ModelBoard model(HaplyGeneration::third);
        SimulatedLine line(model);
        GuardDiary guard;
        {
            Haply2diy device(HaplyGeneration::third, over(line, guard, note), LatestWriter::Thread::caller);
            QVERIFY(device.open().ok());
            QVERIFY(device.home().ok());
        }
        model.place_handle({50.0, 80.0}); // the arms were moved meanwhile
        {
            Haply2diy device(HaplyGeneration::third, over(line, guard, note), LatestWriter::Thread::caller);
            QVERIFY(device.open().ok());
            QVERIFY(!device.motors_off());
            device.write(SafeForce{});
            device.deliver();
            line.advance();
            const auto state = device.read(0.001);
            QVERIFY(state && length(state->position - Vec2(50.0, 80.0)) < 0.2);
        }
        {
            // As the other generation its angles mean other places.
            const HomedNote other(folder.filePath("note").toStdString(), HaplyGeneration::first);
            QVERIFY(!other.holds());
        }
        model.power_off();
        Haply2diy device(HaplyGeneration::third, over(line, guard, note), LatestWriter::Thread::caller);
        QVERIFY(device.open().ok());
        QVERIFY(device.motors_off());
        QVERIFY(!note.holds());
    }

    void opens_over_a_bad_line_too() {
        for (unsigned seed = 0; seed < 20; ++seed) {
            ModelBoard model(HaplyGeneration::third);
            SimulatedLine line(model, 1, seed);
            line.troubles.half = 0.2;
            line.troubles.garbage = 0.2;
            GuardDiary guard;
            Haply2diy device(HaplyGeneration::third, over(line, guard), LatestWriter::Thread::caller);
            const auto can = device.open();
            QVERIFY2(can.ok(), can.error().c_str());
        }
    }

    void what_does_not_answer_is_no_2diy() {
        for (int trouble = 0; trouble < 3; ++trouble) {
            ModelBoard model(HaplyGeneration::third);
            SimulatedLine line(model);
            line.troubles.mute = trouble == 0;
            line.troubles.half = trouble == 1 ? 1.0 : 0.0;
            line.troubles.unplugged = trouble == 2;
            GuardDiary guard;
            Haply2diy device(HaplyGeneration::third, over(line, guard), LatestWriter::Thread::caller);
            const auto can = device.open();
            QVERIFY(!can.ok());
            QVERIFY(can.error().find("does not answer like a Haply 2diy") != std::string::npos);
            QCOMPARE(guard.ends, 1);
            QVERIFY(!device.read(0.0));
            QVERIFY(!device.write(SafeForce{}));
            QVERIFY(!device.home().ok());
            device.halt();
            device.stop();
        }
    }

    void garbage_between_answers_is_skipped_and_counted_and_moves_nothing() {
        BoardBench bench;
        bench.model.place_handle({19.0, 100.0});
        bench.run(0.1);
        const Vec2 before = bench.loop->snapshot().finger();
        bench.line.troubles.garbage = 0.4;
        for (int i = 0; i < 100; ++i) {
            bench.tick();
            QVERIFY(length(bench.loop->snapshot().finger() - before) < 10.0);
        }
        QVERIFY(bench.device.bad_answers() > 10);
        bench.line.troubles.garbage = 0.0;
        bench.run(0.05);
        QVERIFY(length(bench.loop->snapshot().finger() - bench.model.handle()) < 0.2);
    }

    void no_more_than_two_commands_are_under_way_in_a_line_that_stalls() {
        BoardBench bench;
        bench.run(0.05);
        bench.line.troubles.stall = true;
        const int before = bench.guard.beats;
        bench.run(0.004);
        QVERIFY(bench.guard.beats - before <= 2);
        bench.line.troubles.stall = false;
        bench.run(0.05);
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
    }

    void a_board_that_lost_its_power_for_a_moment_wants_to_be_homed() {
        BoardBench bench;
        bench.run(0.05);
        bench.model.power_off();
        bench.run(0.1);
        QVERIFY(bench.model.set_up());
        QVERIFY(bench.device.motors_off());
        QVERIFY(bench.device.complaint().find("lost count") != std::string::npos);
    }

    void a_board_that_never_comes_back_is_lost_after_a_second() {
        BoardBench bench;
        bench.run(0.05);
        bench.line.troubles.mute = true;
        bench.run(0.8);
        QVERIFY(!bench.device.lost());
        bench.run(0.5);
        QVERIFY(bench.device.lost());
        QCOMPARE(bench.loop->snapshot().fault, Fault::device_lost);
    }

    void boards_are_known_by_what_windows_calls_them() {
        const std::string due = "USB\\VID_2341&PID_003E\\7523031393535120A0D1";
        QVERIFY(is_arduino_instance(due));
        QCOMPARE(serial_number_in(due), std::string("7523031393535120A0D1"));
        const std::string part =
            "USB\\VID_2A03&PID_003D&MI_00\\6&2A8C9D&0&0000"; // of several: made up by Windows
        QVERIFY(is_arduino_instance(part));
        QCOMPARE(serial_number_in(part), std::string());
        for (const char* const other :
             {"USB\\VID_0403&PID_6001\\A900", "ACPI\\PNP0501\\1", "USB\\VID_23", ""})
            QVERIFY(!is_arduino_instance(other));
        QCOMPARE(serial_number_in("COM7"), std::string());
    }

    void a_port_that_one_may_not_use_says_what_to_do() {
        const std::string words =
            sentence(OpenProblem::serial_permission, System::linux_system, "Haply 2diy");
        QVERIFY(words.find("70-touchphoto.rules") != std::string::npos);
        QVERIFY(words.find("dialout") != std::string::npos);
        QVERIFY(sentence(OpenProblem::serial_permission, System::macos, "Haply 2diy").find("udev") ==
                std::string::npos);
    }
};

} // namespace haply_2diy_test

TP_TEST(haply_2diy_test, HaplyBackEndTest, nothing)
#include "haply_2diy_test.moc"
