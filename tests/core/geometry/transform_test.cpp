// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/transform.hpp"
#include "random_points.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>

namespace transform_test {

using namespace tp;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Affine random_affine(test::RandomPoints& random) {
    return {glm::dmat2(random.point(3), random.point(3)), random.point(100)};
}

} // namespace

class TransformTest : public QObject {
    Q_OBJECT

private slots:
    void inverse_is_inverse() {
        test::RandomPoints random(1);
        int inverted = 0;
        for (int i = 0; i < 1000; ++i) {
            const Affine map = random_affine(random);
            const auto back = map.inverse();
            if (!back || std::abs(map.determinant()) < 0.01)
                continue;
            ++inverted;
            const Vec2 p = random.point(100);
            QVERIFY(length((*back)(map(p)) - p) < 1e-9);
            QVERIFY(length(map((*back)(p)) - p) < 1e-9);
            QVERIFY(std::abs(map.determinant() * back->determinant() - 1.0) < 1e-9);
        }
        QVERIFY(inverted > 900);
    }

    void maps_that_have_no_inverse() {
        const Affine flat{glm::dmat2(1, 2, 2, 4), {0, 0}};
        const Affine nowhere{glm::dmat2(0.0), {1, 1}};
        const Affine unknown{glm::dmat2(1, 0, not_a_number, 1), {0, 0}};
        const Affine endless{glm::dmat2(1, 0, 0, infinity), {0, 0}};
        const Affine far_away{glm::dmat2(1.0), {infinity, 0}};
        for (const Affine& map : {flat, nowhere, unknown, endless, far_away}) {
            QVERIFY(!map.inverse().ok());
            QVERIFY(map.inverse().error().ends_with('.'));
        }
    }

    /// A map that presses a metre to a picometre is no way back: what is felt would jump by rounding.
    void a_map_is_singular_below_a_millionth_of_a_millionth() {
        for (const double scale : {1e-3, 1.0, 50.0})
            for (const bool turned : {false, true}) {
                const auto pressed = [&](double to) {
                    return turned ? Affine{glm::dmat2(0, scale, -to * scale, 0), {0, 0}}
                                  : Affine{glm::dmat2(to * scale, 0, 0, scale), {0, 0}};
                };
                QVERIFY(pressed(1.2e-12).inverse().ok());
                QVERIFY(pressed(-1.2e-12).inverse().ok());
                QVERIFY(!pressed(0.8e-12).inverse().ok());
                QVERIFY(!pressed(-0.8e-12).inverse().ok());
            }
    }

    void small_and_large_maps_have_one() {
        for (const double scale : {1e-9, 1e-3, 1e6, 1e12}) {
            const Affine map{glm::dmat2(scale, 0, 0, -scale), {1, 2}};
            QVERIFY(map.inverse().ok());
            QVERIFY(length((*map.inverse())(map({3, 4})) - Vec2(3, 4)) < 1e-6);
        }
    }

    void compose_is_one_after_the_other() {
        test::RandomPoints random(2);
        for (int i = 0; i < 1000; ++i) {
            const Affine a = random_affine(random);
            const Affine b = random_affine(random);
            const Affine c = random_affine(random);
            const Vec2 p = random.point(100);
            QVERIFY(length(compose(a, b)(p) - a(b(p))) < 1e-9);
            QVERIFY(length(compose(a, compose(b, c))(p) - compose(compose(a, b), c)(p)) < 1e-8);
            QVERIFY(length(compose(a, Affine{})(p) - a(p)) < 1e-12);
            QVERIFY(length(a.direction(p) - (a(p) - a({0, 0}))) < 1e-9);
        }
    }

    void force_pulled_back_does_the_same_work() {
        test::RandomPoints random(3);
        for (int i = 0; i < 1000; ++i) {
            const Affine device_to_surface = random_affine(random);
            const Vec2 force = random.point(1.5);
            const Vec2 velocity = random.point(500);
            const double at_device = glm::dot(device_to_surface.pull_back_force(force), velocity);
            const double at_surface = glm::dot(force, device_to_surface.direction(velocity));
            QVERIFY(std::abs(at_device - at_surface) < 1e-9);
        }
    }

    void photo_fits_centred_into_the_surface() {
        test::RandomPoints random(4);
        for (int i = 0; i < 500; ++i) {
            const Vec2 corner = random.point(4000);
            const Rect subject{corner, corner + Vec2(random.number(1, 4000), random.number(1, 4000))};
            const Vec2 low = random.point(100);
            const Rect workspace{low, low + Vec2(random.number(10, 300), random.number(10, 300))};
            const auto map = fit_photo_to_surface(subject, workspace);
            QVERIFY(map.ok());
            QVERIFY(length((*map)(subject.centre()) - workspace.centre()) < 1e-9);
            // y turns over: the photo's top is up on the surface.
            const Vec2 top_left = (*map)(subject.min);
            const Vec2 bottom_right = (*map)(subject.max);
            QVERIFY(top_left.y > bottom_right.y && top_left.x < bottom_right.x);
            const Vec2 size(bottom_right.x - top_left.x, top_left.y - bottom_right.y);
            // Inside, touching two sides, and of the same shape.
            QVERIFY(size.x <= workspace.width() + 1e-9 && size.y <= workspace.height() + 1e-9);
            QVERIFY(std::abs(size.x - workspace.width()) < 1e-9 ||
                    std::abs(size.y - workspace.height()) < 1e-9);
            QVERIFY(std::abs(size.x / size.y * subject.height() / subject.width() - 1.0) < 1e-9);
        }
    }

    void fit_needs_sizes_above_zero() {
        const Rect good{{0, 0}, {10, 10}};
        for (const Rect& bad :
             {Rect{}, Rect{{0, 0}, {0, 5}}, Rect{{5, 5}, {0, 0}}, Rect{{0, 0}, {not_a_number, 5}},
              Rect{{0, 0}, {infinity, 5}}, Rect{{-infinity, -infinity}, {infinity, infinity}}}) {
            QVERIFY(!fit_photo_to_surface(bad, good).ok());
            QVERIFY(!fit_photo_to_surface(good, bad).ok());
        }
        QVERIFY(!fit_photo_to_surface({{0, 0}, {5e-324, 5e-324}}, good).ok());
        QVERIFY(!fit_photo_to_surface({{0, 0}, {1e300, 1e300}}, {{0, 0}, {1e-300, 1e-300}}).ok());
        QVERIFY(!fit_photo_to_surface({{1e308, 1e308}, {1.7e308, 1.7e308}}, good)
                     .ok()); // whose centre is nowhere
    }
};

} // namespace transform_test

TP_TEST(transform_test, TransformTest, event_loop)
#include "transform_test.moc"
