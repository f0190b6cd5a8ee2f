// SPDX-License-Identifier: Apache-2.0
// What stands in for a Falcon does what is known of its grip: where its stops are, what its arms count, how it moves.
#include "device/falcon/model_falcon.hpp"
#include "device/falcon/plane_force.hpp"
#include "quick_falcon.hpp"
#include "test_program.hpp"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace model_falcon_test {

using namespace tp;
using namespace tp::falcon;
using namespace tp::testing;

namespace {

std::array<double, 3> counts_at(const Place& place) {
    const Angles angles = *angles_at(place);
    return {counts_of(angles.x), counts_of(angles.y), counts_of(angles.z)};
}

bool within_stops(const Place& place) {
    return place.z > 0.075 && place.z < 0.172 && std::hypot(place.x, place.y) < 0.065;
}

} // namespace

class ModelFalconTest : public QObject {
    Q_OBJECT
private slots:
    void its_grip_has_stops() {
        for (const Place& place :
             {Place{0.0, 0.0, 0.0752}, Place{0.0, 0.0, 0.0748}, Place{0.0, 0.0, 0.1718},
              Place{0.0, 0.0, 0.1722}, Place{0.0648, 0.0, 0.12}, Place{0.0652, 0.0, 0.12},
              Place{0.0, -0.0648, 0.12}, Place{0.0, -0.0652, 0.12}, Place{0.047, 0.047, 0.12}}) {
            QuickFalcon quick;
            quick.model.place_grip(place);
            QCOMPARE(quick.model.grip() == place, within_stops(place));
            QCOMPARE(quick.model.grip() == middle, !within_stops(place));
        }
    }

    void its_encoders_count_what_its_arms_turn_and_are_off_until_it_is_homed() {
        const Place there{0.010, -0.020, 0.115};
        const std::array<double, 3> truth = counts_at(there);
        QuickFalcon quick;
        quick.model.place_grip(there);
        std::optional<Reply> reply = quick.ask();
        QVERIFY(reply);
        QCOMPARE(int(reply->homed), 7);
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(int(reply->encoders[i]), int(std::lround(truth[i])));
        for (const bool restarted : {false, true}) {
            if (restarted)
                quick.model.restart();
            quick.model.run_firmware(false);
            quick.model.place_grip(there);
            reply = quick.ask();
            QVERIFY(reply);
            QCOMPARE(int(reply->homed), 0);
            constexpr std::array<double, 3> off{-700.0, 310.0, 1250.0};
            for (std::size_t i = 0; i < 3; ++i)
                QCOMPARE(int(reply->encoders[i]), int(std::lround(truth[i] + off[i])));
        }
        quick.model.pull_and_push(); // and is not told to look for its marks
        QCOMPARE(int(quick.ask()->homed), 0);
        Command homing;
        homing.homing = true;
        quick.ask(homing);
        quick.model.pull_and_push();
        reply = quick.ask(homing);
        QCOMPARE(int(reply->homed), 7);
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(int(reply->encoders[i]), int(std::lround(counts_at(middle)[i])));
    }

    void an_arm_finds_its_mark_at_55_degrees() {
        double near = 0.125;
        double far = 0.170;
        for (int i = 0; i < 40; ++i) {
            const double z = 0.5 * (near + far);
            (angles_at(Place{0.0, 0.0, z})->x < 55.0 * std::numbers::pi / 180.0 ? near : far) = z;
        }
        FalconPlant plant;
        plant.hand_stiffness = 2000.0;
        plant.hand_damping = 60.0; // it does not go beyond
        plant.coulomb = 0.0;
        QuickFalcon quick(plant);
        quick.model.run_firmware(false);
        Command homing;
        homing.homing = true;
        quick.ask(homing);
        for (const double beyond : {-0.002, 0.002}) {
            quick.model.move_hand({0.0, 0.0, near + beyond});
            for (int i = 0; i < 500; ++i)
                quick.model.step();
            QCOMPARE(int(quick.ask(homing)->homed), beyond > 0.0 ? 7 : 0);
        }
    }

    /// Against the same laws written down once more.
    void its_grip_moves_as_a_mass_with_friction_does() {
        FalconPlant plant;
        plant.hand_stiffness = 500.0;
        plant.hand_damping = 5.0;
        QuickFalcon quick(plant);
        Place at = middle;
        glm::dvec3 velocity(0.0);
        const auto follows = [&](const Place& hand, double stiffness, double damping) {
            for (int i = 0; i < 2; ++i) {
                const glm::dvec3 force = stiffness * (hand - at) - (plant.damping + damping) * velocity;
                velocity += 0.0005 / plant.mass * force;
                const double speed = glm::length(velocity);
                velocity *=
                    speed > 0.0 ? std::max(0.0, speed - 0.0005 / plant.mass * plant.coulomb) / speed : 0.0;
                if (within_stops(at + 0.0005 * velocity))
                    at += 0.0005 * velocity;
                else
                    velocity = glm::dvec3(0.0);
            }
            quick.model.step();
            return glm::length(quick.model.grip() - at) < 1e-12;
        };
        for (const Place& hand : {middle + glm::dvec3(0.004, 0.003, -0.006), Place(0.0, 0.0, 0.2), middle}) {
            quick.model.move_hand(hand);
            for (int i = 0; i < 300; ++i)
                QVERIFY(follows(hand, 500.0, 5.0));
        }
        quick.model.place_grip({0.01, 0.0, 0.12}); // at rest, and the hand with it
        at = {0.01, 0.0, 0.12};
        velocity = glm::dvec3(0.0);
        QVERIFY(follows(at, 500.0, 5.0));
    }

    void its_motors_push_by_their_units() {
        const glm::dmat3 levers = *jacobian(middle, *angles_at(middle));
        for (const double stronger : {1.0, 2.0}) {
            FalconPlant plant;
            plant.units_per_newton_metre = stronger == 1.0 ? 0.0 : units_per_newton_metre / stronger;
            for (const glm::dvec3& force : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.5)}) {
                QuickFalcon quick(plant);
                Command command;
                command.motors = motors_for(levers, force);
                quick.ask(command);
                QVERIFY(glm::length(quick.model.force() - stronger * force) < 0.06 * stronger);
            }
        }
    }

    void one_with_a_watchdog_lets_go_after_its_silence() {
        for (const int watchdog_ms : {0, 30}) {
            FalconPlant plant;
            plant.watchdog_ms = watchdog_ms;
            plant.mass = 1e6;
            QuickFalcon quick(plant);
            Command command;
            command.motors = {100, 0, 0};
            quick.ask(command);
            for (int ms = 1; ms <= 40; ++ms) {
                quick.model.step();
                QCOMPARE(quick.model.command().motors[0] != 0, watchdog_ms == 0 || ms <= 30);
            }
        }
    }
};

} // namespace model_falcon_test

TP_TEST(model_falcon_test, ModelFalconTest, nothing)
#include "model_falcon_test.moc"
