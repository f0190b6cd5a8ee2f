// SPDX-License-Identifier: Apache-2.0
#include "joystick_to_open.hpp"
#include "safe_force.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pid_joystick_test {

using namespace tp;
using namespace tp::testing;

class PidJoystickTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_what_it_can_and_that_its_newtons_are_none() {
        JoystickToOpen stick;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY2(can.ok(), can.error().c_str());
        QCOMPARE(can->serial_number, std::string("0001"));
        QVERIFY(!can->calibrated);
        QCOMPARE(can->max_force, PidJoystick::most_newtons_unmeasured);
        QCOMPARE(can->workspace.size(), std::size_t(4));
        QVERIFY(can->resolution > 0.001 && can->resolution < 0.002); // 120 mm in 65 534 steps
        QCOMPARE(stick.model.effects(), std::size_t(2));
    }

    void forces_along_each_axis_have_their_size_and_their_sign_data() { each_stick(); }
    void forces_along_each_axis_have_their_size_and_their_sign() {
        QFETCH(int, stick);
        for (const Vec2 sign : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)}) {
            JoystickToOpen bench(wire_of(stick), {8.0, sign, true});
            bench.model.sign = sign;
            QVERIFY(bench.device.open().ok());
            for (const Vec2 newtons :
                 {Vec2(2.0, 0.0), Vec2(-2.0, 0.0), Vec2(0.0, 1.5), Vec2(0.0, -1.5), Vec2(1.0, -2.0)}) {
                bench.device.read(0.001);
                QVERIFY(bench.device.write(safe(newtons, 100.0)));
                bench.device.deliver();
                bench.link.advance();
                const Vec2 felt = bench.model.force();
                QVERIFY2(length(felt - newtons) < 0.05, qPrintable(QString("%1 %2").arg(felt.x).arg(felt.y)));
                QVERIFY(length(felt) < length(newtons) + 0.02);
            }
        }
    }

    void a_force_that_was_lost_does_not_stay_while_the_other_axis_goes_on() {
        JoystickToOpen stick(open_controller(), {8.0, {-1, -1}, true});
        QVERIFY(stick.device.open().ok());
        const auto pull = [&](Vec2 newtons) {
            stick.device.read(0.001);
            QVERIFY(stick.device.write(safe(newtons, 100.0)));
            stick.device.deliver();
            stick.link.advance();
        };
        pull({2.0, 0.5});
        stick.link.troubles.deaf = true;
        pull({0.0, 0.6});
        stick.link.troubles.deaf = false;
        QVERIFY(stick.model.force().x > 1.9);
        int ticks = 0;
        while (std::abs(stick.model.force().x) > 0.01 && ticks < 100)
            pull({0.0, ++ticks % 2 == 0 ? 0.6 : 0.7});
        QVERIFY2(ticks <= 16, qPrintable(QString::number(ticks)));
    }

    void one_that_was_not_measured_pulls_less_than_it_is_asked_to() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.device.read(0.001);
        stick.device.write(safe({1.5, 0.0}));
        stick.device.deliver();
        stick.link.advance();
        QVERIFY(stick.model.force().x > 0.1 &&
                stick.model.force().x < 0.3); // 1.5 N of 60 N, of a stick of 8 N
    }

    void where_it_stands_is_known_from_the_first_moment_data() { each_stick(); }
    void where_it_stands_is_known_from_the_first_moment() {
        QFETCH(int, stick);
        for (const Vec2 place : {Vec2(30.0, -15.0), Vec2(-58.0, 45.0), Vec2(60.0, -60.0)}) {
            JoystickToOpen bench(wire_of(stick));
            bench.model.place_grip(place);
            QVERIFY(bench.device.open().ok());
            const std::optional<DeviceState> state = bench.device.read(0.001);
            QVERIFY(state.has_value());
            QVERIFY(length(state->position - place) < 0.2);
        }
    }

    void or_from_its_first_report_where_it_does_not_tell() {
        JoystickToOpen stick;
        stick.link.troubles.no_input_now = true;
        QVERIFY(stick.device.open().ok());
        QVERIFY(!stick.device.read(0.001).has_value());
        stick.model.place_grip({10.0, 0.0});
        stick.link.advance();
        QVERIFY(stick.device.read(0.002).has_value());
    }

    /// HID has neither a clock nor a number: what shows that a stick is alive is a report, or that it takes what
    /// is sent while it only reports changes and has none.
    void at_rest_a_stick_is_as_fresh_as_the_last_message_that_it_took() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        QVERIFY(stick.device.read(0.001));
        for (int ms = 2; ms < 100; ++ms) {
            QVERIFY(stick.device.write(SafeForce{}));
            const bool takes = ms % 3 != 0;
            if (takes)
                stick.device.deliver();
            stick.link.advance();
            const std::optional<DeviceState> state = stick.device.read(0.001 * ms);
            QCOMPARE(state.has_value(), takes);
            QVERIFY(!state || state->time == 0.001 * ms);
        }
        stick.model.place_grip({5.0, 0.0}); // and a report tells, whether it takes anything or not
        stick.link.advance();
        const std::optional<DeviceState> moved = stick.device.read(0.1);
        QVERIFY(moved && moved->time == 0.1 && std::abs(moved->position.x - 5.0) < 0.2);
    }

    void the_silence_of_a_stick_that_speaks_at_rest_is_no_reading_data() {
        QTest::addColumn<int>("same_ms");
        QTest::addColumn<bool>("known");
        QTest::newRow("a report said the same for 0.9 s") << 900 << false;
        QTest::newRow("and for 1.1 s") << 1100 << true;
    }
    void the_silence_of_a_stick_that_speaks_at_rest_is_no_reading() {
        QFETCH(int, same_ms);
        QFETCH(bool, known);
        JoystickToOpen stick;
        stick.model.speaks_at_rest = true;
        QVERIFY(stick.device.open().ok());
        int ms = 0;
        const auto tick = [&] {
            stick.device.write(SafeForce{});
            stick.device.deliver();
            stick.link.advance();
            return stick.device.read(0.001 * ++ms);
        };
        while (ms < same_ms)
            QVERIFY(tick());
        stick.link.troubles.mute = true;
        for (int i = 0; i < 50; ++i)
            QCOMPARE(tick().has_value(), !known);
        stick.link.troubles.mute = false;
        QVERIFY(tick());
    }

    /// The idle rate of a stick: now and then it says again where it is (HID 1.11, 7.2.4).
    void a_report_that_comes_again_now_and_then_is_no_speaking_at_rest() {
        JoystickToOpen stick;
        stick.model.speaks_at_rest = true;
        QVERIFY(stick.device.open().ok());
        for (int ms = 1; ms < 5000; ++ms) {
            stick.link.troubles.mute = ms % 50 != 0;
            stick.device.write(SafeForce{});
            stick.device.deliver();
            stick.link.advance();
            QVERIFY(stick.device.read(0.001 * ms));
        }
    }

    /// The system keeps the oldest reports where nothing reads them.
    void what_a_full_queue_of_the_system_held_last_is_no_reading() {
        JoystickToOpen stick;
        stick.model.speaks_at_rest = true;
        QVERIFY(stick.device.open().ok());
        while (stick.device.read(0.01)) // what the opening left
            stick.link.advance();
        for (int i = 0; i < 63; ++i)
            stick.link.advance();
        QVERIFY(!stick.device.read(0.1));
        stick.model.place_grip({5.0, 0.0});
        stick.link.advance();
        const std::optional<DeviceState> state = stick.device.read(0.101);
        QVERIFY(state && std::abs(state->position.x - 5.0) < 0.2);
    }

    void a_full_memory_is_emptied_once() {
        JoystickToOpen stick;
        stick.model.troubles.room = 4;
        std::vector<std::uint8_t> answer;
        QVERIFY(stick.model.get_feature(stick.model.wire().block_load, answer));
        QCOMPARE(int(answer[2]), 3);  // nothing is loaded that was not asked for
        stick.model.leave_effects(3); // a reset empties it
        QCOMPARE(stick.model.effects(), std::size_t(3));
        QVERIFY(stick.device.open().ok());
        QCOMPARE(stick.model.effects(), std::size_t(2));
        stick.device.stop();
        stick.link.advance();

        stick.model.troubles.keeps_after_reset = true; // only freeing does
        stick.model.leave_effects(3);
        QVERIFY(stick.device.open().ok());
        stick.link.advance();
        QCOMPARE(stick.model.effects(), std::size_t(2));
    }

    void a_memory_without_room_is_said() {
        JoystickToOpen stick;
        stick.model.troubles.room = 1;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("no room") != std::string::npos, can.error().c_str());
        stick.link.advance();
        QCOMPARE(stick.model.effects(), std::size_t(0)); // the one that had room is not left on it
        QVERIFY(!stick.model.motors_on());
        QVERIFY(!stick.device.write(SafeForce{}));
    }

    void an_effect_that_is_refused_is_said() {
        JoystickToOpen stick;
        stick.model.troubles.refuses = true;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("does not take up a force") != std::string::npos, can.error().c_str());
    }

    void an_answer_may_take_a_while() {
        JoystickToOpen stick;
        stick.link.troubles.block_load_late = 5;
        QVERIFY(stick.device.open().ok());
    }

    void unplugged_while_it_is_opened_is_said() {
        JoystickToOpen stick;
        stick.link.troubles.unplugged = true;
        const Result<Capabilities> can = stick.device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("unplugged") != std::string::npos, can.error().c_str());
    }

    void what_cannot_be_used_is_said_with_its_reason() {
        JoystickWire wire = open_controller();
        wire.descriptor = wire.descriptor.first(wire.descriptor.size() - 1);
        JoystickToOpen cut(wire);
        QVERIFY(cut.device.open().error().find("makes no sense") != std::string::npos);
        static const std::vector<std::uint8_t> rumble =
            tp::testing::bytes_of(tp::testing::saitek_rumble_pad.hex);
        wire.descriptor = rumble;
        JoystickToOpen rumbles(wire);
        QVERIFY(rumbles.device.open().error().find("its force has no direction") != std::string::npos);
    }

    void it_opens_again_after_it_was_unplugged() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.device.read(0.001);
        stick.device.write(safe({1.0, 0.0}));
        stick.device.deliver();
        stick.link.troubles.unplugged = true;
        stick.device.read(0.002);
        QVERIFY(stick.device.lost());
        QVERIFY(!stick.device.write(safe({1.0, 0.0})));
        stick.link.troubles.unplugged = false;
        QVERIFY(stick.device.open().ok());
        QVERIFY(!stick.device.lost());
        QCOMPARE(stick.link.diary.dismissals, 0); // the guard of one that is lost does what it still can
        QCOMPARE(stick.link.diary.ends, 1);
        stick.link.troubles.unplugged = true;
        stick.device.read(0.003);
        QVERIFY(stick.device.lost());
        stick.link.troubles.unplugged = false;
        stick.model.troubles.refuses = true;
        QVERIFY(!stick.device.open().ok());
        QVERIFY(!stick.device.lost()); // there is nothing that could be
        stick.device.stop();
        stick.device.stop();
    }

    /// Its motors and its place belong to what was before.
    void opened_again_it_begins_as_new() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.model.troubles.safety_switch = true;
        stick.link.advance();
        QVERIFY(stick.device.read(0.001));
        QVERIFY(stick.device.motors_off());
        QVERIFY(stick.device.complaint().find("safety switch") != std::string::npos);
        stick.model.troubles.safety_switch = false;
        stick.link.troubles.no_input_now = true;
        stick.link.troubles.mute = true;
        QVERIFY(stick.device.open().ok());
        QVERIFY(!stick.device.motors_off());
        QCOMPARE(stick.device.complaint(), std::string());
        QVERIFY(!stick.device.read(100.0)); // nobody knows yet where it is
        QCOMPARE(stick.device.complaint(), std::string());
        QVERIFY(!stick.device.motors_off());
    }
};

} // namespace pid_joystick_test

TP_TEST(pid_joystick_test, PidJoystickTest, nothing)
#include "pid_joystick_test.moc"
