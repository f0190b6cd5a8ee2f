// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/tent_profile.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>

namespace tent_profile_test {

using tp::TentProfile;

class TentProfileTest : public QObject {
    Q_OBJECT
private slots:
    void follows_the_equation_of_the_paper() {
        const TentProfile tent; // K = 0.2 N/mm, d = 4 mm
        QCOMPARE(tent.force(0.0), 0.0);
        QCOMPARE(tent.force(1.0), 0.2);
        QCOMPARE(tent.force(4.0), 0.8);
        QCOMPARE(tent.force(6.0), 0.4);
        QCOMPARE(tent.force(8.0), 0.0);
        QCOMPARE(tent.force(100.0), 0.0);
        QCOMPARE(tent.peak(), 0.8);
    }

    void is_continuous_where_its_branches_meet() {
        for (const double stiffness : {0.1, 0.5})
            for (const double range : {2.0, 10.0}) {
                const TentProfile tent{stiffness, range};
                for (const double r : {range, 2.0 * range}) {
                    const double below = std::nextafter(r, 0.0);
                    const double above = std::nextafter(r, 1e3);
                    QVERIFY(std::abs(tent.force(below) - tent.force(above)) < 1e-12);
                    QVERIFY(std::abs(tent.energy(below) - tent.energy(above)) < 1e-12);
                }
            }
    }

    void force_is_the_derivative_of_the_energy() {
        const TentProfile tent;
        const double h = 1e-6;
        for (double r = 0.05; r < 9.0; r += 0.1)
            QVERIFY(std::abs((tent.energy(r + h) - tent.energy(r - h)) / (2.0 * h) - tent.force(r)) < 1e-6);
        QCOMPARE(tent.energy(100.0), 0.2 * 16.0); // K·d² = 3.2 mJ
    }

    void the_energy_is_what_it_takes_to_pull_the_finger_there() {
        for (const TentProfile tent : {TentProfile{0.2, 4.0}, TentProfile{0.5, 3.0}}) {
            double taken = 0.0;
            const double step = 1e-3;
            for (int i = 0; i < 12000; ++i) {
                taken += tent.force((i + 0.5) * step) * step;
                if (i % 100 == 99)
                    QVERIFY(std::abs(tent.energy((i + 1) * step) - taken) < 1e-5);
            }
            for (const double r : {std::nan(""), -1.0, 0.0})
                QCOMPARE(tent.energy(r), 0.0);
        }
    }

    void what_is_not_a_distance_gives_no_force() {
        const TentProfile tent;
        for (const double r : {std::nan(""), -1.0, std::numeric_limits<double>::infinity()})
            QCOMPARE(tent.force(r), 0.0);
        QVERIFY(!(TentProfile{0.0, 4.0}.valid()));
        QVERIFY(!(TentProfile{0.2, std::nan("")}.valid()));
        for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
            QVERIFY(!(TentProfile{0.2, bad}.valid()) && !(TentProfile{bad, 4.0}.valid()));
        QVERIFY((TentProfile{0.2, 4.0}.valid()));
    }
};

} // namespace tent_profile_test

TP_TEST(tent_profile_test, TentProfileTest, nothing)
#include "tent_profile_test.moc"
