// SPDX-License-Identifier: Apache-2.0
#include "core/participant/force_sense.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace force_sense_test {

using namespace tp;

namespace {
constexpr double dt = 0.005;
} // namespace

class ForceSenseTest : public QObject {
    Q_OBJECT
private slots:
    void a_force_is_felt_after_the_delay_and_not_before() {
        const Person person;
        for (std::uint64_t seed = 0; seed < 30; ++seed) {
            ForceSense sense(person, dt, seed);
            for (int i = 0; i < 30; ++i) // 0.15 s
                QVERIFY(sense.feel({1.0, 0.0}) == Vec2(0.0) || i > 3);
            QVERIFY(length(sense.feel({1.0, 0.0})) > 0.5);
        }
    }
    void what_is_below_the_threshold_is_not_felt() {
        Person person;
        person.force_noise_n = 0.0;
        for (const double newtons : {0.03, 0.12}) {
            int felt = 0;
            ForceSense sense(person, dt, 1);
            for (int i = 0; i < 1000; ++i)
                felt += sense.feel({0.0, newtons}) != Vec2(0.0) ? 1 : 0;
            QCOMPARE(felt > 0, newtons > 0.06);
            QVERIFY(felt == 0 || felt >= 960);
        }
    }
    void without_a_force_hardly_anything_is_felt() {
        ForceSense sense(Person{}, dt, 1);
        int felt = 0;
        for (int i = 0; i < 200'000; ++i)
            felt += sense.feel(Vec2(0.0)) != Vec2(0.0) ? 1 : 0;
        QVERIFY(felt < 400); // 0.2 %
    }
    void its_size_and_direction_are_felt_as_inexactly_as_the_person_is() {
        const Person person;
        ForceSense sense(person, dt, 2);
        double sizes = 0.0, squares = 0.0, turns = 0.0;
        constexpr int count = 200'000;
        for (int i = -100; i < count; ++i) {
            const Vec2 felt = sense.feel({0.0, 3.0});
            if (i < 0)
                continue;
            const double off = length(felt) / 3.0 - 1.0,
                         turn = std::atan2(felt.x, felt.y) * 180.0 / 3.14159265;
            sizes += off / count;
            squares += off * off / count;
            turns += turn * turn / count;
        }
        QVERIFY(std::abs(sizes) < 0.01);
        QVERIFY(std::abs(std::sqrt(squares) / person.weber - 1.0) < 0.05);
        QVERIFY(std::abs(std::sqrt(turns) / person.direction_deg - 1.0) < 0.05);
    }
    void noise_that_changes_slowly_changes_slowly() {
        Chance chance(3);
        SlowNoise noise(0.15);
        double before = noise.next(chance, dt), variance = 0.0, kept = 0.0;
        constexpr int count = 300'000;
        for (int i = 0; i < count; ++i) {
            const double now = noise.next(chance, dt);
            variance += now * now / count;
            kept += now * before / count;
            before = now;
        }
        QVERIFY(std::abs(variance - 1.0) < 0.05);
        QVERIFY(std::abs(kept / variance - std::exp(-dt / 0.15)) < 0.01);
    }
};

} // namespace force_sense_test

TP_TEST(force_sense_test, ForceSenseTest, nothing)
#include "force_sense_test.moc"
