// SPDX-License-Identifier: Apache-2.0
#include "core/servo/energy_observer.hpp"

#include <QTest>

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
        for (const bool by_nan : {false, true}) {
            EnergyObserver observer;
            observer.observe({0.0, 0.0}, {50.0, 0.0}, 0.0, 0.001);
            observer.wrote({0.5, 0.0});
            observer.observe({0.1, 0.0}, {50.0, 0.0}, 0.0, 0.001);
            QVERIFY(observer.leak() > 0.0);
            if (by_nan)
                QVERIFY(observer.observe({std::nan(""), 0.0}, {50.0, 0.0}, 0.0, 0.001) == Vec2(0.0));
            else
                observer.reset();
            QCOMPARE(observer.leak(), 0.0);
            QVERIFY(observer.observe({9.0, 0.0}, {50.0, 0.0}, 0.0, 0.001) == Vec2(0.0));
        }
    }
};

QTEST_APPLESS_MAIN(EnergyObserverTest)
#include "energy_observer_test.moc"
