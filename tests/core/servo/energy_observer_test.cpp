// SPDX-License-Identifier: Apache-2.0
#include "core/servo/energy_observer.hpp"
#include "test_program.hpp"

#include <QTest>

namespace energy_observer_test {

using namespace tp;

namespace {

constexpr double stiffness = 0.2; // N/mm
double potential(double x) { return 0.5 * stiffness * x * x; }

} // namespace

class EnergyObserverTest : public QObject {
    Q_OBJECT
private slots:
    void sees_the_leak_of_a_sampled_spring() {
        // The force of the last tick is held while the finger moves on: the hand gains ½ K Δx² a tick.
        EnergyObserver observer;
        double expected = 0.0;
        double x = 1.0;
        observer.observe({x, 0.0}, {0.0, 0.0}, potential(x), 0.001);
        for (int i = 0; i < 50; ++i) {
            observer.wrote({-stiffness * x, 0.0});
            const double step = i % 2 == 0 ? -0.03 : 0.02;
            x += step;
            expected += 0.5 * stiffness * step * step;
            observer.observe({x, 0.0}, {0.0, 0.0}, potential(x), 0.001);
        }
        QVERIFY(std::abs(observer.leak() - expected) < 1e-12);
    }

    void a_delay_of_two_ticks_leaks_five_times_as_much() {
        const auto leak_with_delay = [](std::size_t delay) {
            EnergyObserver observer(delay);
            double before = 0.0;
            for (int i = 0; i < 120; ++i) {
                const double x = 1.0 + 0.01 * i; // away from the line, so that a late force pulls too little
                observer.observe({x, 0.0}, {0.0, 0.0}, potential(x), 0.001);
                observer.wrote({-stiffness * x, 0.0});
                if (i == 20) // every force on its way is one of this motion
                    before = observer.leak();
            }
            return observer.leak() - before;
        };
        // T/2 + nT: 0.5 T against 2.5 T.
        QVERIFY(std::abs(leak_with_delay(2) / leak_with_delay(0) - 5.0) < 1e-6);
    }

    /// A device that is slower yet is reckoned as one of sixteen ticks.
    void the_longest_delay_leaks_as_it_should() {
        for (const std::size_t delay : {std::size_t(16), std::size_t(17), std::size_t(100)}) {
            EnergyObserver observer(delay);
            double before = 0.0;
            const double step = 0.01;
            for (int i = 0; i < 200; ++i) {
                const double x = 1.0 + step * i;
                observer.observe({x, 0.0}, {0.0, 0.0}, potential(x), 0.001);
                observer.wrote({-stiffness * x, 0.0});
                if (i == 50)
                    before = observer.leak();
            }
            QVERIFY(std::abs(observer.leak() - before - 149 * 16.5 * stiffness * step * step) < 1e-9);
        }
    }

    void pays_back_by_damping_and_no_more_than_leaked() {
        EnergyObserver observer;
        observer.observe({0.0, 0.0}, {100.0, 0.0}, 0.0, 0.001);
        observer.wrote({0.5, 0.0});
        const Vec2 force = observer.observe({0.1, 0.0}, {100.0, 0.0}, 0.0, 0.001); // 0.05 mJ given
        QVERIFY(std::abs(observer.leak() - 0.05) < 1e-12);
        QCOMPARE(force.y, 0.0);
        QVERIFY(force.x < 0.0);
        QVERIFY(-force.x * 0.1 <= 0.05 + 1e-12);         // not more than the leak in one tick at 100 mm/s
        QVERIFY(-force.x <= 8.0 * 100.0 * 1e-3 + 1e-12); // and never more than 8 N·s/m
    }

    /// More damping than that is felt as a handle that sticks and shakes.
    void a_large_leak_is_damped_by_no_more_than_8_newton_seconds_a_metre() {
        for (const double speed : {1.0, 20.0, 300.0}) { // mm/s
            EnergyObserver observer;
            observer.observe({0.0, 0.0}, {0.0, speed}, 0.0, 0.001);
            observer.wrote({0.0, 0.8});
            const Vec2 force = observer.observe({0.0, 1000.0}, {0.0, speed}, 0.0, 0.001); // 800 mJ given
            QVERIFY(length(force - Vec2(0.0, -8.0 * 1e-3 * speed)) < 1e-12);
        }
    }

    void a_hand_that_hardly_moves_is_left_alone() {
        for (const double speed : {0.0, 0.25, 0.5, 0.5001}) { // mm/s
            EnergyObserver observer;
            observer.observe({0.0, 0.0}, {speed, 0.0}, 0.0, 0.001);
            observer.wrote({1.0, 0.0});
            const Vec2 force = observer.observe({1.0, 0.0}, {speed, 0.0}, 0.0, 0.001); // 1 mJ given
            const bool is_damped = force.x < 0.0;
            QVERIFY(is_damped == (speed > 0.5));
            QVERIFY(observer.observe({1.0, 0.0}, {speed, 0.0}, 0.0, 0.0) == Vec2(0.0)); // no time has passed
        }
    }

    /// ½ K Δx² a tick leaks and b Δx²/T is what the device takes: with b = K T/2 nothing is left.
    void what_the_device_damps_by_itself_is_not_damped_again() {
        for (const double share : {0.5, 1.0, 2.0}) {
            EnergyObserver observer(0, {8.0, 0.5, share * 0.5 * 1e3 * stiffness * 0.001});
            double x = 1.0;
            observer.observe({x, 0.0}, {0.0, 0.0}, potential(x), 0.001);
            for (int i = 0; i < 100; ++i) {
                observer.wrote({-stiffness * x, 0.0});
                x += 0.02;
                observer.observe({x, 0.0}, {0.0, 0.0}, potential(x), 0.001);
            }
            const double leaks = 100 * 0.5 * stiffness * 0.02 * 0.02;
            QVERIFY(std::abs(observer.leak() - std::max(0.0, 1.0 - share) * leaks) < 1e-12);
        }
    }

    /// Two ticks pass before a payment is felt; the same leak is not paid in each of them again.
    void what_is_on_its_way_is_not_paid_again() {
        EnergyObserver observer(2);
        double x = 0.0;
        const auto tick = [&](double force) {
            x += 0.1;
            const Vec2 paid = observer.observe({x, 0.0}, {100.0, 0.0}, 0.0, 0.001);
            observer.wrote(Vec2(force, 0.0) + paid);
            return -0.1 * paid.x; // mJ, at 0.1 mm a tick
        };
        double paid = tick(0.5); // 0.05 mJ, two ticks later
        for (int i = 0; i < 10; ++i)
            paid += tick(0.0);
        QVERIFY(std::abs(paid - 0.05) < 1e-9);
        QVERIFY(observer.leak() < 1e-9);
    }

    void pays_less_where_less_of_a_damping_force_takes_energy() {
        for (const double share : {0.0, 0.25, 1.0}) {
            EnergyObserver observer;
            observer.observe({0.0, 0.0}, {100.0, 0.0}, 0.0, 0.001);
            observer.wrote({0.5, 0.0});
            const Vec2 force = observer.observe({0.1, 0.0}, {100.0, 0.0}, 0.0, 0.001, share);
            QVERIFY(std::abs(-force.x * 0.1 - share * 0.05) < 1e-12);
        }
    }

    void keeps_no_credit_where_the_renderer_takes_energy() {
        EnergyObserver observer;
        observer.observe({0.0, 0.0}, {0.0, 0.0}, 0.0, 0.001);
        observer.wrote({-0.5, 0.0});
        observer.observe({0.2, 0.0}, {0.0, 0.0}, 0.0, 0.001);
        QCOMPARE(observer.leak(), 0.0);
        observer.wrote({0.5, 0.0});
        observer.observe({0.3, 0.0}, {0.0, 0.0}, 0.0, 0.001);
        QVERIFY(std::abs(observer.leak() - 0.05) < 1e-12);
    }

    void forgets_on_reset_and_on_what_is_not_a_number() {
        const double nan = std::nan("");
        for (const int by : {0, 1, 2, 3}) {
            EnergyObserver observer;
            observer.observe({0.0, 0.0}, {50.0, 0.0}, 0.0, 0.001);
            observer.wrote({0.5, 0.0});
            observer.observe({0.1, 0.0}, {50.0, 0.0}, 0.0, 0.001);
            QVERIFY(observer.leak() > 0.0);
            if (by == 0)
                observer.reset();
            else
                QVERIFY(observer.observe({by == 1 ? nan : 0.2, 0.0}, {50.0, by == 2 ? nan : 0.0},
                                         by == 3 ? nan : 0.0, 0.001) == Vec2(0.0));
            QCOMPARE(observer.leak(), 0.0);
            QVERIFY(observer.observe({9.0, 0.0}, {50.0, 0.0}, 5.0, 0.001) == Vec2(0.0)); // another scene's
            QVERIFY(observer.observe({9.5, 0.0}, {50.0, 0.0}, 5.0, 0.001) == Vec2(0.0)); // no force since
        }
    }
};

} // namespace energy_observer_test

TP_TEST(energy_observer_test, EnergyObserverTest, nothing)
#include "energy_observer_test.moc"
