// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/stamper.hpp"
#include "test_program.hpp"

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace stamper_test {

using namespace tp::falcon;

namespace {

constexpr double degree = 0.017453292519943295;

/// Over what a Falcon reaches: 10 cm across and 6 cm deep, without its corners.
Place any_place(std::mt19937& random) {
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    while (true) {
        const Place place{0.06 * share(random), 0.06 * share(random), 0.12 + 0.03 * share(random)};
        if (std::hypot(place.x, place.y) < 0.06)
            return place;
    }
}

/// θ1 of the first arm as the facts have it: by the tangent of half the angle.
double half_angle_way(const Place& p) {
    constexpr double a = 0.060, b = 0.1025, c = 0.01443, d = 0.01125, e = 0.01125, f = -0.025, r = 0.040,
                     s = -0.02309;
    const double phi = (90.0 + 15.0) * degree;
    const double u = std::cos(phi) * p.x + std::sin(phi) * p.y - r;
    const double v = -std::sin(phi) * p.x + std::cos(phi) * p.y - s;
    const double w = p.z;
    const double S = b * std::sin(std::acos((v + f) / b));
    const double base =
        w * w + u * u + 2 * c * u + a * a + c * c - d * d - e * e - S * S - 2 * S * e - 2 * S * d - 2 * d * e;
    const double l0 = base - 2 * a * u - 2 * a * c;
    const double l1 = -4 * a * w;
    const double l2 = base + 2 * a * u + 2 * a * c;
    return 2 * std::atan((-l1 - std::sqrt(l1 * l1 - 4 * l0 * l2)) / (2 * l2));
}

} // namespace

class StamperTest : public QObject {
    Q_OBJECT
private slots:
    void angles_are_those_of_the_published_equations() {
        std::mt19937 random(1);
        for (int i = 0; i < 2000; ++i) {
            const Place place = any_place(random);
            const std::optional<Angles> angles = angles_at(place);
            QVERIFY(angles);
            QVERIFY(std::abs(std::remainder(angles->x - half_angle_way(place), 360.0 * degree)) < 1e-9);
        }
    }

    void on_the_axis_all_arms_are_alike_and_a_count_is_a_twentieth_of_a_millimetre() {
        const std::optional<Angles> angles = angles_at(middle);
        QVERIFY(angles);
        QVERIFY(std::abs(angles->x - angles->y) < 1e-12 && std::abs(angles->x - angles->z) < 1e-12);
        QVERIFY(std::abs(angles->x - 27.709 * degree) < 0.001 * degree);
        const std::optional<glm::dmat3> j = jacobian(middle, *angles);
        QVERIFY(j);
        const double count = angle_of(1.0) - angle_of(0.0);
        QVERIFY(std::abs(count - 0.036435 * degree) < 1e-6 * degree);
        const double mm = 1000.0 * count * glm::length((*j)[0] + (*j)[1] + (*j)[2]);
        QVERIFY(std::abs(mm - 0.048) < 0.0005);
    }

    void a_push_along_the_axis_takes_the_published_torque() {
        const Place place{0.0, 0.0, 0.11};
        const std::optional<Angles> angles = angles_at(place);
        QVERIFY(angles);
        const std::optional<glm::dmat3> j = jacobian(place, *angles);
        QVERIFY(j);
        const glm::dvec3 torque = torques(*j, {0.0, 0.0, 1.0});
        QVERIFY(std::abs(1e4 * torque.x - 242.0) < 0.5); // what libnifalcon sends for a newton
    }

    void counts_and_angles_are_one_scale() {
        QVERIFY(std::abs(angle_of(0.0) - 35.0 * degree) < 1e-12);
        for (const double counts : {-1400.0, 0.0, 17.0, 900.0})
            QVERIFY(std::abs(counts_of(angle_of(counts)) - counts) < 1e-9);
    }

    void there_and_back_is_the_same_place() {
        std::mt19937 random(2);
        double worst = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Place place = any_place(random);
            const std::optional<Angles> angles = angles_at(place);
            QVERIFY(angles);
            for (const Place& near : {middle, any_place(random)}) {
                const std::optional<Place> back = place_of(*angles, near);
                QVERIFY(back);
                worst = std::max(worst, glm::length(*back - place));
            }
        }
        QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
    }

    void the_jacobian_is_the_slope_of_the_place() {
        std::mt19937 random(3);
        constexpr double h = 1e-6;
        for (int i = 0; i < 1000; ++i) {
            const Place place = any_place(random);
            const std::optional<Angles> angles = angles_at(place);
            QVERIFY(angles);
            const std::optional<glm::dmat3> j = jacobian(place, *angles);
            QVERIFY(j);
            for (int arm = 0; arm < 3; ++arm) {
                Angles up = *angles;
                Angles down = *angles;
                up[arm] += h;
                down[arm] -= h;
                const std::optional<Place> above = place_of(up, place);
                const std::optional<Place> below = place_of(down, place);
                QVERIFY(above && below);
                QVERIFY(glm::length((*above - *below) / (2.0 * h) - (*j)[arm]) < 1e-5);
            }
        }
    }

    void the_motors_do_the_work_that_the_grip_gets() {
        std::mt19937 random(4);
        std::normal_distribution<double> any;
        for (int i = 0; i < 2000; ++i) {
            const Place place = any_place(random);
            const std::optional<Angles> angles = angles_at(place);
            QVERIFY(angles);
            const std::optional<glm::dmat3> j = jacobian(place, *angles);
            QVERIFY(j);
            const glm::dvec3 force(any(random), any(random), any(random));
            const glm::dvec3 turning(any(random), any(random), any(random));
            const double of_motors = glm::dot(torques(*j, force), turning);
            const double of_grip = glm::dot(force, *j * turning);
            QVERIFY(std::abs(of_motors - of_grip) < 1e-12);
        }
    }

    void outside_the_reach_there_are_no_angles() {
        for (const Place& place : {Place{0.0, 0.0, 0.5}, Place{0.3, 0.0, 0.12}, Place{0.0, -1e6, 0.12},
                                   Place{1e300, 0.0, 0.0}, Place{0.0, 0.0, -0.5}})
            QVERIFY(!angles_at(place));
    }

    void not_a_number_is_no_place() {
        const double nan = std::nan("");
        const double infinite = std::numeric_limits<double>::infinity();
        for (const double bad : {nan, infinite, -infinite})
            for (int i = 0; i < 3; ++i) {
                glm::dvec3 v = middle;
                v[i] = bad;
                QVERIFY(!angles_at(v));
                QVERIFY(!place_of(v, middle));
                QVERIFY(!place_of(*angles_at(middle), v));
                QVERIFY(!jacobian(v, *angles_at(middle)));
                QVERIFY(!jacobian(middle, v));
            }
    }

    void angles_at_which_the_arms_cannot_meet_are_refused() {
        for (const Angles& angles : {Angles(180.0 * degree), Angles(-90.0 * degree),
                                     Angles{90.0 * degree, -80.0 * degree, 90.0 * degree}})
            QVERIFY(!place_of(angles, middle));
    }

    void a_grip_behind_the_base_is_not_taken_for_one_before_it() {
        // The same arms meet at a second place behind the base, to which the method goes when it begins
        // there.
        const std::optional<Angles> angles = angles_at(middle);
        QVERIFY(angles);
        const std::optional<Place> behind = place_of(*angles, {0.0, 0.0, -0.10});
        QVERIFY(!behind || behind->z > 0.0);
    }

    void where_the_shins_lie_in_a_plane_nothing_can_be_pushed() {
        // On the axis, with the grip so far in that every shin is at right angles to it.
        bool met = false;
        for (double z = 0.12; z > -0.12 && !met; z -= 1e-5) {
            const std::optional<Angles> angles = angles_at({0.0, 0.0, z});
            met = angles && !jacobian({0.0, 0.0, z}, *angles);
        }
        QVERIFY(met);
    }

    void any_encoders_give_a_place_in_reach_or_none() {
        std::mt19937 random(5);
        int none = 0;
        for (int i = 0; i < 20000; ++i) {
            const Angles angles{angle_of(static_cast<std::int16_t>(random())),
                                angle_of(static_cast<std::int16_t>(random())),
                                angle_of(static_cast<std::int16_t>(random()))};
            const std::optional<Place> place = place_of(angles, middle);
            none += place ? 0 : 1;
            if (place)
                QVERIFY(glm::length(*place) < 0.25);
        }
        QVERIFY(none > 0 && none < 20000);
    }
};

} // namespace stamper_test

TP_TEST(stamper_test, StamperTest, nothing)
#include "stamper_test.moc"
