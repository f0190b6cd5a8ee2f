// SPDX-License-Identifier: Apache-2.0
#include "core/participant/person.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace person_test {

using namespace tp;

class PersonTest : public QObject {
    Q_OBJECT
private slots:
    void the_same_number_is_the_same_person_and_another_is_another() {
        QCOMPARE(person_of(3, 7).delay_s, person_of(3, 7).delay_s);
        QVERIFY(person_of(3, 7).delay_s != person_of(4, 7).delay_s);
        QVERIFY(person_of(3, 7).delay_s != person_of(3, 8).delay_s);
    }
    /// What was simulated is simulated again on another computer and in years.
    void a_person_that_was_given_stays() {
        QCOMPARE(QString::number(person_of(1, 1).delay_s, 'f', 9), QString("0.202478821"));
    }
    void people_lie_about_the_typical_one() {
        const Person typical;
        double delay = 0.0, squares = 0.0, speed = 0.0;
        constexpr int people = 4000;
        for (int number = 1; number <= people; ++number) {
            const Person person = person_of(number, 5);
            const double off = std::log(person.delay_s / typical.delay_s);
            delay += off / people;
            squares += off * off / people;
            speed += std::log(person.follow_speed_mm_s / typical.follow_speed_mm_s) / people;
            QVERIFY(person.delay_s > 0.1 && person.delay_s < 0.21);
        }
        QVERIFY(std::abs(delay) < 0.01 && std::abs(speed) < 0.015);
        QVERIFY(std::abs(std::sqrt(squares) - 0.15) < 0.01);
    }
    void an_arm_that_is_stiffer_is_more_damped() {
        const auto ratio = [](const Person& person) {
            return person.damping_n_s_per_m / std::sqrt(person.mass_kg * person.stiffness_n_per_mm);
        };
        for (int number = 1; number <= 20; ++number)
            QVERIFY(std::abs(ratio(person_of(number, 5)) - ratio(Person{})) < 1e-9);
    }
};

} // namespace person_test

TP_TEST(person_test, PersonTest, nothing)
#include "person_test.moc"
