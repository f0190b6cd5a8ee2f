// SPDX-License-Identifier: Apache-2.0
#include "device/simulated/plant_motion.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace tp;

class PlantMotionTest : public QObject {
    Q_OBJECT
private slots:
    /// m ẍ + b ẋ = F: v → F/b with the time constant m/b.
    void a_damped_body_under_a_steady_force_is_where_the_closed_form_says() {
        for (const double step : {0.0001, 0.001, 0.004, 0.1})
            for (const double damping : {0.02, 0.3, 5.0}) {
                PlantMotion motion;
                PlantState state;
                state.position = {1.0, -2.0};
                state.velocity = {30.0, 0.0};
                const double mass = 0.1;
                const double end = 0.2;
                for (int i = 0; i < std::lround(end / step); ++i)
                    motion.advance(state, {mass, damping}, {0.5, -0.2}, step);
                const double lag = mass / damping;
                const double gone = 1.0 - std::exp(-end / lag);
                const auto place = [&](double x, double v, double force) {
                    const double last = 1e3 * force / damping;
                    return x + last * end + (v - last) * lag * gone;
                };
                QVERIFY(std::abs(state.position.x - place(1.0, 30.0, 0.5)) < 1e-9);
                QVERIFY(std::abs(state.position.y - place(-2.0, 0.0, -0.2)) < 1e-9);
                QVERIFY(std::abs(state.velocity.x - (30.0 + (5e2 / damping - 30.0) * gone)) < 1e-9);
            }
    }

    void without_damping_it_is_a_falling_stone() {
        PlantMotion motion;
        PlantState state;
        for (int i = 0; i < 50; ++i)
            motion.advance(state, {0.2}, {0.4, 0.0}, 0.004);
        QVERIFY(std::abs(state.position.x - 0.5 * 2000.0 * 0.2 * 0.2) < 1e-9);
        QVERIFY(std::abs(state.velocity.x - 2000.0 * 0.2) < 1e-9);
    }

    /// Under-damped, over-damped: x = a + Re(c·exp(λt)) for both roots of m λ² + b λ + k = 0.
    void a_body_on_a_spring_swings_as_the_closed_form_says() {
        for (const double damping : {0.0, 0.3, 40.0}) {
            PlantMotion motion;
            PlantState state;
            state.position.x = 5.0;
            state.anchor.x = 2.0;
            const double mass = 0.1, stiffness = 0.5, end = 0.3; // N/mm
            for (int i = 0; i < 300; ++i)
                motion.advance(state, {mass, damping, 0.0, stiffness}, Vec2(0.0), 0.001);
            const std::complex<double> root =
                std::sqrt(std::complex<double>(damping * damping - 4.0 * mass * 1e3 * stiffness));
            const std::complex<double> one = (-damping + root) / (2.0 * mass);
            const std::complex<double> other = (-damping - root) / (2.0 * mass);
            const std::complex<double> x =
                3.0 * (one * std::exp(other * end) - other * std::exp(one * end)) / (one - other);
            QVERIFY(std::abs(state.position.x - (2.0 + x.real())) < 1e-9);
        }
    }

    /// Energy is kept by a swing that nothing damps, however long the steps: Euler's gain or lose.
    void a_free_swing_keeps_its_energy() {
        PlantMotion motion;
        PlantState state;
        state.position = {3.0, 0.0};
        for (int i = 0; i < 10'000; ++i)
            motion.advance(state, {0.05, 0.0, 0.0, 0.5}, Vec2(0.0), 0.004);
        const double speed = 1e-3 * length(state.velocity);
        const double energy =
            0.5 * 0.5 * glm::dot(state.position, state.position) + 0.5 * 0.05 * speed * speed * 1e3;
        QVERIFY(std::abs(energy - 2.25) < 1e-6);
    }

    void a_relaxed_hand_follows() {
        PlantMotion motion;
        PlantState state;
        state.position.x = 4.0;
        for (int i = 0; i < 1000; ++i) // so heavy that it does not move
            motion.advance(state, {1e9, 0.0, 0.0, 0.1, 0.15}, Vec2(0.0), 0.001);
        QVERIFY(std::abs(state.anchor.x - 4.0 * (1.0 - std::exp(-1.0 / 0.15))) < 1e-6);
    }

    /// From v over v²/(2a) with a = (F_c ∓ F)/m, in any direction, and then it stays.
    void dry_friction_brings_it_to_rest_where_the_closed_form_says() {
        for (const double step : {0.0001, 0.001, 0.004})
            for (const double pull : {-0.2, 0.0, 0.1}) {
                PlantMotion motion;
                PlantState state;
                const Vec2 way(0.6, 0.8);
                state.velocity = 100.0 * way;
                for (int i = 0; i < std::lround(1.0 / step); ++i)
                    motion.advance(state, {0.1, 0.0, 0.3}, pull * way, step);
                const double stop = 100.0 * 100.0 / (2.0 * 1e3 * (0.3 - pull) / 0.1);
                QVERIFY(state.velocity == Vec2(0.0));
                QVERIFY(length(state.position - stop * way) < 1e-6);
            }
    }

    void more_than_the_friction_sets_it_off_and_less_does_not() {
        for (const double pull : {0.29, 0.3, 0.31, 0.5}) {
            PlantMotion motion;
            PlantState state;
            for (int i = 0; i < 100; ++i)
                motion.advance(state, {0.1, 0.0, 0.3}, {0.0, pull}, 0.001);
            const double gone = 0.5 * 1e3 * std::max(0.0, pull - 0.3) / 0.1 * 0.1 * 0.1;
            QVERIFY(std::abs(state.position.y - gone) < 1e-6);
        }
    }

    /// A swing on a spring loses 4 F_c / k of its amplitude in a cycle.
    void a_swing_against_dry_friction_loses_the_same_in_every_cycle() {
        PlantMotion motion;
        PlantState state;
        state.position.x = 4.0;
        const double mass = 0.1, stiffness = 0.2, coulomb = 0.02;
        const double half = 3.14159265358979 * std::sqrt(mass / (1e3 * stiffness));
        const int steps = 1000;
        for (int cycle = 1; cycle <= 5; ++cycle) {
            for (int i = 0; i < 2 * steps; ++i)
                motion.advance(state, {mass, 0.0, coulomb, stiffness}, Vec2(0.0), half / steps);
            QVERIFY(std::abs(state.position.x - (4.0 - cycle * 4.0 * coulomb / stiffness)) < 1e-4);
        }
    }
};

QTEST_APPLESS_MAIN(PlantMotionTest)
#include "plant_motion_test.moc"
