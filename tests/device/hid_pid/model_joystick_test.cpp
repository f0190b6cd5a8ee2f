// SPDX-License-Identifier: Apache-2.0
// The model, of which nothing is read back through what it is to try.
#include "device/hid_pid/model_joystick.hpp"
#include "joystick_to_open.hpp"
#include "safe_force.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace model_joystick_test {

using namespace tp;
using namespace tp::testing;

class ModelJoystickTest : public QObject {
    Q_OBJECT
private slots:
    void a_stick_s_endless_effect_ends_after_65_s_of_16_bits() {
        for (const bool expires : {true, false}) {
            JoystickToOpen stick;
            stick.model.troubles.expires = expires;
            QVERIFY(stick.device.open().ok());
            stick.device.read(0.001);
            stick.device.write(safe({1.0, 0.0}));
            stick.device.deliver();
            stick.link.advance(); // with the first of them
            for (int ms = 2; ms < 65535; ++ms)
                stick.model.step();
            QVERIFY(stick.model.force() != Vec2(0.0));
            stick.model.step();
            QCOMPARE(stick.model.force() == Vec2(0.0), expires);
            stick.model.receive({}); // which is no report
        }
    }

    void a_stick_says_what_became_of_an_effect() {
        using Bytes = std::vector<std::uint8_t>;
        ModelJoystick model(open_controller());
        model.troubles.room = 2;
        const std::uint8_t create = model.wire().create, load = model.wire().block_load;
        const auto loaded = [&](const Bytes& asked) {
            Bytes answer;
            return model.set_feature(asked) && model.get_feature(load, answer) ? answer : Bytes{};
        };
        QCOMPARE(loaded({create, 1}), (Bytes{load, 1, 1, 0xFF, 0xFF}));
        QCOMPARE(loaded({create, 2}), (Bytes{load, 0, 3, 0xFF, 0xFF})); // of another kind
        QCOMPARE(loaded({create, 1}), (Bytes{load, 2, 1, 0xFF, 0xFF}));
        QCOMPARE(loaded({create}), (Bytes{load, 0, 3, 0xFF, 0xFF}));
        QCOMPARE(loaded({create, 1}), (Bytes{load, 0, 2, 0xFF, 0xFF})); // there is no room
        QCOMPARE(loaded({load, 1}), Bytes{});                           // nothing that can be set
    }
    void a_grip_goes_no_farther_than_its_lever() {
        for (const Vec2 beyond : {Vec2(500.0, 20.0), Vec2(20.0, -500.0), Vec2(-500.0, 500.0)}) {
            ModelJoystick model(open_controller());
            model.place_grip(beyond);
            model.step();
            QVERIFY(length(model.grip() - glm::clamp(beyond, Vec2(-60.0), Vec2(60.0))) < 0.1);
        }
    }
    void a_stick_that_is_stopped_or_reset_pulls_nothing_more() {
        for (const std::uint8_t command : {std::uint8_t{3}, std::uint8_t{4}}) {
            JoystickToOpen stick;
            stick.model.troubles.keeps_after_reset = true;
            QVERIFY(stick.device.open().ok());
            stick.device.read(0.001);
            stick.device.write(safe({1.0, 0.0}));
            stick.device.deliver();
            stick.link.advance();
            QVERIFY(stick.model.force() != Vec2(0.0));
            stick.model.receive(std::array<std::uint8_t, 2>{stick.model.wire().control, command});
            stick.model.receive(std::array<std::uint8_t, 2>{stick.model.wire().control, 1}); // motors on
            stick.model.step();
            QVERIFY(stick.model.motors_on() && stick.model.effects() == 2);
            QVERIFY(stick.model.force() == Vec2(0.0));
            stick.model.troubles.keeps_after_reset = false;
            stick.model.receive(std::array<std::uint8_t, 2>{stick.model.wire().control, command});
            QCOMPARE(stick.model.effects(), std::size_t(command == 4 ? 0 : 2));
        }
    }

    void an_effect_plays_from_its_start_to_its_stop() {
        JoystickToOpen stick;
        QVERIFY(stick.device.open().ok());
        stick.device.read(0.001);
        stick.device.write(safe({1.0, 0.0}));
        stick.device.deliver();
        stick.link.advance();
        const auto pulls_after = [&stick](std::uint8_t operation) {
            const std::uint8_t of_x = 1;
            stick.model.receive(
                std::array<std::uint8_t, 4>{stick.model.wire().operation, of_x, operation, 0});
            stick.model.step();
            return stick.model.force() != Vec2(0.0);
        };
        QVERIFY(pulls_after(4)); // which is none
        QVERIFY(!pulls_after(3));
        QVERIFY(!pulls_after(4));
        QVERIFY(pulls_after(1));
    }

    /// For how long a grip may feel an old force, of whichever axis, is known to who judges it.
    void a_force_that_does_not_arrive_is_lacked_until_one_of_its_axis_does() {
        ModelJoystick model(open_controller());
        SimulatedJoystickLink link(model);
        const auto force = [](std::uint8_t block) {
            hid::Report report;
            report.bytes = {5, block};
            report.size = 4;
            return report;
        };
        link.troubles.deaf = true;
        QVERIFY(link.write(force(1)));
        link.troubles.deaf = false;
        for (unsigned ms = 1; ms <= 5; ++ms) {
            QVERIFY(link.write(force(2)));
            link.advance();
            QCOMPARE(link.silent_ms(), 1 + ms);
        }
        QVERIFY(link.write(force(1)));
        link.advance();
        QCOMPARE(link.silent_ms(), 0u);
        link.advance();
        QCOMPARE(link.silent_ms(), 1u);
    }

    void a_link_says_what_it_could_not_ask() {
        ModelJoystick model(open_controller());
        SimulatedJoystickLink link(model);
        hid::Report load;
        load.bytes[0] = model.wire().block_load;
        hid::Report heard;
        model.troubles.safety_switch = true; // of which it tells
        QVERIFY(link.read(heard, 0) == PidTransport::Got::nothing);
        QVERIFY(link.read(heard, 100) == PidTransport::Got::report); // a wait passes in its own time
        link.troubles.block_load_late = 2;
        QVERIFY(!link.get_feature(load) && !link.get_feature(load));
        QVERIFY(link.get_feature(load));
        link.troubles.unplugged = true;
        QVERIFY(!link.get_feature(load) && !link.set_feature(load) && !link.write(load));
    }

    void a_stick_says_bit_for_bit_why_its_motors_are_off() {
        ModelJoystick model(open_controller());
        const auto said = [&model] {
            model.step();
            std::vector<std::uint8_t> bytes;
            return model.report(bytes) ? bytes : std::vector<std::uint8_t>{};
        };
        using Bytes = std::vector<std::uint8_t>;
        QVERIFY(said().empty()); // nothing has changed
        model.troubles.safety_switch = true;
        QVERIFY(said() == (Bytes{2, 0x0A}));
        model.troubles.no_power = true;
        QVERIFY(said() == (Bytes{2, 0x02}));
        model.disable();
        QVERIFY(said() == (Bytes{2, 0x00}));
        model.troubles = {};
        QVERIFY(said() == (Bytes{2, 0x0C}));
        QVERIFY(said().empty());
    }
};

} // namespace model_joystick_test

TP_TEST(model_joystick_test, ModelJoystickTest, nothing)
#include "model_joystick_test.moc"
