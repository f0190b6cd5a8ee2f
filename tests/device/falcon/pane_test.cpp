// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/plane_force.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <numbers>

namespace pane_test {

using namespace tp;
using namespace tp::falcon;

class FalconPaneTest : public QObject {
    Q_OBJECT
private slots:
    /// 300 N/m, and no more than 0.04 N on from one millisecond to the next.
    void the_pane_pushes_by_its_depth_and_lets_in_its_share() {
        for (const double depth_mm : {1.0, 2.0, 4.0}) {
            Pane pane;
            pane.feed(0.0, plane_z - 1e-3 * depth_mm);
            QVERIFY(std::abs(pane.force(1.0) - 0.04) < 1e-12);
            for (int i = 0; i < 60; ++i)
                pane.force(1.0);
            QVERIFY(std::abs(pane.force(1.0) - 0.3 * depth_mm) < 1e-12);
            QVERIFY(std::abs(pane.force(9.0) - 0.3 * depth_mm) < 1e-12); // all is all
            QVERIFY(std::abs(pane.force(0.5) - 0.15 * depth_mm) < 1e-12);
        }
    }

    /// 6 N·s/m against a speed that is smoothed at 40 Hz.
    void the_pane_damps_by_a_smoothed_speed() {
        const auto force_at = [](double dt, double speed) {
            Pane pane;
            const double z = plane_z - 2e-3;
            pane.feed(1.0, z - speed * dt);
            pane.feed(1.0 + dt, z);
            for (int i = 0; i < 60; ++i)
                pane.force(1.0);
            return pane.force(1.0);
        };
        const double part = 1.0 - std::exp(-2.0 * std::numbers::pi * 40.0 * 0.001);
        for (const double speed : {0.05, -0.05})
            QVERIFY(std::abs(force_at(0.001, speed) - (0.6 - 6.0 * part * speed)) < 1e-9);
        QVERIFY(std::abs(force_at(0.019, -0.05) - 0.6) > 0.1);
        QVERIFY(std::abs(force_at(0.021, -0.05) - 0.6) < 1e-12); // after a gap it knows no speed
        Pane twice;                                              // the same time again says nothing new
        twice.feed(1.0, plane_z - 1e-3);
        twice.feed(1.0, plane_z - 5e-3);
        for (int i = 0; i < 60; ++i)
            twice.force(1.0);
        QVERIFY(std::abs(twice.force(1.0) - 0.3) < 1e-12);
        twice.feed(std::nan(""), plane_z - 5e-3);
        twice.feed(2.0, std::nan(""));
        QVERIFY(std::abs(twice.force(1.0) - 0.3) < 1e-12);
    }

    /// 100 mm/s out of the pane take 0.6 N off, which come back when no place says that it goes on.
    void a_speed_does_not_outlive_its_places() {
        Pane pane;
        double now = 0.0;
        for (int ms = 0; ms <= 30; ++ms) {
            now = 0.001 * ms;
            pane.feed(now, plane_z - 5e-3 + 1e-4 * ms);
            pane.elapse(now);
        }
        for (int i = 0; i < 60; ++i)
            pane.force(1.0);
        QVERIFY(std::abs(pane.force(1.0) - (0.6 - 0.6)) < 0.001);
        pane.elapse(now + 0.021);
        for (int i = 0; i < 60; ++i)
            pane.force(1.0);
        QVERIFY(std::abs(pane.force(1.0) - 0.6) < 1e-12);
    }
};

} // namespace pane_test

TP_TEST(pane_test, FalconPaneTest, nothing)
#include "pane_test.moc"
