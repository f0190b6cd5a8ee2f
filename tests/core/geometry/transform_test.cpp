// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/transform.hpp"
#include "random_points.hpp"

#include <QTest>

#include <limits>

using namespace tp;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Affine random_affine(test::RandomPoints& random) {
    return {glm::dmat2(random.point(3), random.point(3)), random.point(100)};
}

/// Samples of a known map on a grid of marks, each off by `noise` mm at most.
std::vector<FramePair> samples(const Affine& truth, test::RandomPoints& random, double noise) {
    std::vector<FramePair> pairs;
    for (const double x : {-60.0, 0.0, 60.0})
        for (const double y : {-40.0, 0.0, 40.0})
            pairs.push_back({{x, y}, truth({x, y}) + random.point(noise)});
    return pairs;
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
    }

    void calibrate_recovers_a_known_map() {
        test::RandomPoints random(5);
        for (int i = 0; i < 200; ++i) {
            const Affine truth = random_affine(random);
            if (std::abs(truth.determinant()) < 0.1)
                continue;
            const auto found = calibrate(samples(truth, random, 0.0));
            QVERIFY2(found.ok(), found.error().c_str());
            QVERIFY(found->residual_mm < 1e-9);
            const Vec2 p = random.point(100);
            QVERIFY(length(found->device_to_surface(p) - truth(p)) < 1e-9);
        }
    }

    void calibrate_averages_a_little_noise() {
        test::RandomPoints random(6);
        const Affine truth{glm::dmat2(0.9, 0.1, -0.1, 0.9), {12, -7}};
        const auto found = calibrate(samples(truth, random, 0.3));
        QVERIFY2(found.ok(), found.error().c_str());
        QVERIFY(found->residual_mm > 0.0 && found->residual_mm < 0.45);
        QVERIFY(length(found->device_to_surface({30, 20}) - truth({30, 20})) < 0.5);
    }

    void calibrate_refuses_much_noise() {
        test::RandomPoints random(7);
        const auto pairs = samples({}, random, 10.0);
        const auto found = calibrate(pairs);
        QVERIFY(!found.ok());
        QVERIFY2(found.error().find("mm") != std::string::npos, found.error().c_str());
        QVERIFY(calibrate(pairs, 100.0).ok()); // unless it is allowed
    }

    void calibrate_refuses_one_mark_that_is_wrong() {
        test::RandomPoints random(8);
        auto pairs = samples({}, random, 0.0);
        pairs[4].surface += Vec2(20, 0);
        QVERIFY(!calibrate(pairs).ok());
    }

    void calibrate_refuses_too_few_or_marks_on_one_line() {
        const auto on_line = [](double x) { return FramePair{{x, 2 * x + 1}, {x, 2 * x + 1}}; };
        QVERIFY(!calibrate({}).ok());
        QVERIFY(!calibrate({{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}}).ok());
        QVERIFY(!calibrate({on_line(0), on_line(1), on_line(2), on_line(7)}).ok());
        QVERIFY(!calibrate(std::vector<FramePair>(9, FramePair{{5, 5}, {5, 5}})).ok());
        QVERIFY(calibrate({{{0, 0}, {0, 0}}, {{10, 0}, {10, 0}}, {{0, 10}, {0, 10}}}).ok());
    }

    /// A touchscreen that reports one place, or one line, fits without a residual, and every force would be
    /// lost.
    void calibrate_refuses_a_touchscreen_that_does_not_follow() {
        std::vector<FramePair> stuck;
        std::vector<FramePair> on_one_line;
        for (const double x : {-60.0, 0.0, 60.0})
            for (const double y : {-40.0, 0.0, 40.0}) {
                stuck.push_back({{x, y}, {3, 4}});
                on_one_line.push_back({{x, y}, {x, 2 * x}});
            }
        QVERIFY(!calibrate(stuck).ok());
        QVERIFY(!calibrate(on_one_line).ok());
    }

    void calibrate_refuses_samples_that_are_not_numbers() {
        test::RandomPoints random(9);
        for (const double bad : {not_a_number, infinity, -infinity}) {
            auto pairs = samples({}, random, 0.0);
            pairs[3].device.x = bad;
            QVERIFY(!calibrate(pairs).ok());
            pairs = samples({}, random, 0.0);
            pairs[3].surface.y = bad;
            QVERIFY(!calibrate(pairs).ok());
            QVERIFY(!calibrate(pairs, infinity).ok());
        }
        auto huge = samples({}, random, 0.0);
        huge[0].device = {1e200, 1e200};
        QVERIFY(!calibrate(huge).ok());
    }
};

QTEST_GUILESS_MAIN(TransformTest)
#include "transform_test.moc"
