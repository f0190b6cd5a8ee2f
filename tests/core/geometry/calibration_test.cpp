// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/calibration.hpp"
#include "random_points.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace calibration_test {

using namespace tp;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Affine random_affine(test::RandomPoints& random) {
    return {glm::dmat2(random.point(3), random.point(3)), random.point(100)};
}

/// Turned by `degrees` after it was mirrored or not, and stretched a little.
Affine frame(double degrees, bool mirrored, Vec2 offset = {12.0, -7.0}) {
    const double angle = degrees / 57.29577951308232;
    const glm::dmat2 turn(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle));
    return {turn * glm::dmat2(1.02, 0.0, 0.0, mirrored ? -0.98 : 0.98), offset};
}

double farthest_apart(const Affine& a, const Affine& b) {
    double most = 0.0;
    for (const Vec2 corner : {Vec2(-100, -75), Vec2(100, -75), Vec2(100, 75), Vec2(-100, 75)})
        most = std::max(most, length(a(corner) - b(corner)));
    return most;
}

/// As four corners are touched: a cluster of samples at each.
std::vector<FramePair> corner_touches(const Affine& truth, test::RandomPoints& random, double noise,
                                      int each = 15) {
    std::vector<FramePair> pairs;
    for (const Vec2 corner : {Vec2(-90, -65), Vec2(90, -65), Vec2(90, 65), Vec2(-90, 65)})
        for (int i = 0; i < each; ++i) {
            const Vec2 place = corner + random.point(1.0);
            pairs.push_back({place, truth(place) + random.point(noise)});
        }
    return pairs;
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

class CalibrationTest : public QObject {
    Q_OBJECT

private slots:
    void a_known_map_is_recovered() {
        test::RandomPoints random(5);
        for (int i = 0; i < 200; ++i) {
            const Affine truth = random_affine(random);
            const double size = std::max(length(truth.linear[0]), length(truth.linear[1]));
            if (std::abs(truth.determinant()) < 0.1 * size * size)
                continue; // what it makes of a rectangle is nearly a line
            const auto found = calibrate(samples(truth, random, 0.0));
            QVERIFY2(found.ok(), found.error().c_str());
            QVERIFY(found->residual_mm < 1e-9);
            const Vec2 p = random.point(100);
            QVERIFY(length(found->device_to_surface(p) - truth(p)) < 1e-9);
        }
    }

    void a_little_noise_is_averaged() {
        test::RandomPoints random(6);
        const Affine truth{glm::dmat2(0.9, 0.1, -0.1, 0.9), {12, -7}};
        const auto found = calibrate(samples(truth, random, 0.3));
        QVERIFY2(found.ok(), found.error().c_str());
        QVERIFY(found->residual_mm > 0.0 && found->residual_mm < 0.45);
        QVERIFY(length(found->device_to_surface({30, 20}) - truth({30, 20})) < 0.5);
    }

    void much_noise_is_refused() {
        test::RandomPoints random(7);
        const auto pairs = samples({}, random, 10.0);
        const auto found = calibrate(pairs);
        QVERIFY(!found.ok());
        QVERIFY2(found.error().find("mm") != std::string::npos, found.error().c_str());
        QVERIFY(calibrate(pairs, 100.0).ok()); // unless it is allowed
    }

    void too_few_or_marks_on_one_line_are_refused() {
        const auto on_line = [](double x) { return FramePair{{x, 2 * x + 1}, {x, 2 * x + 1}}; };
        QVERIFY(!calibrate({}).ok());
        QVERIFY(!calibrate({{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}}).ok());
        QVERIFY(!calibrate({on_line(0), on_line(1), on_line(2), on_line(7)}).ok());
        QVERIFY(!calibrate(std::vector<FramePair>(9, FramePair{{5, 5}, {5, 5}})).ok());
        QVERIFY(calibrate({{{0, 0}, {0, 0}}, {{10, 0}, {10, 0}}, {{0, 10}, {0, 10}}}).ok());
    }

    /// A touchscreen that reports one place, or one line, fits without a residual, and every force would be
    /// lost.
    void a_touchscreen_that_does_not_follow_is_refused() {
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

    void samples_that_are_not_numbers_are_refused() {
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

    /// Each of the four numbers of a touch; no device and no screen is larger than a hundred metres.
    void a_touch_beyond_every_screen_is_no_place_data() {
        QTest::addColumn<double>("reach");
        QTest::addColumn<bool>("place");
        QTest::newRow("within") << 0.9e5 << true;
        QTest::newRow("beyond") << 1.1e5 << false;
        QTest::newRow("beyond_in_the_other_direction") << -1.1e5 << false;
        QTest::newRow("not_a_number") << not_a_number << false;
    }
    void a_touch_beyond_every_screen_is_no_place() {
        QFETCH(double, reach);
        QFETCH(bool, place);
        for (const int number : {0, 1, 2, 3}) {
            std::vector<FramePair> pairs = {{{0, 0}, {0, 0}}, {{10, 0}, {10, 0}}, {{0, 10}, {0, 10}}};
            Vec2& touched = number < 2 ? pairs[1].device : pairs[1].surface;
            (number % 2 == 0 ? touched.x : touched.y) = reach;
            const std::string said = calibrate(pairs).error(); // a map like a needle is another complaint
            QCOMPARE(said.find("is not a valid place") == std::string::npos, place);
        }
    }

    /// As exact as a touchscreen gets: half a millimetre beside the others counts, more does not.
    void a_touch_beside_exact_ones_counts_within_half_a_millimetre() {
        test::RandomPoints random(15);
        for (const Vec2 direction : {Vec2(1, 0), Vec2(0, -1), Vec2(0.6, 0.8)})
            for (const bool within : {true, false}) {
                auto pairs = samples({}, random, 0.0);
                pairs[4].surface += (within ? 0.45 : 0.6) * direction;
                const auto found = calibrate(pairs);
                QVERIFY2(found.ok(), found.error().c_str());
                QCOMPARE(found->used, within ? std::size_t(9) : std::size_t(8));
            }
    }

    /// Where touches scatter, what is far off is judged by that scatter: 2.5 robust standard deviations.
    void how_far_off_is_too_far_goes_by_the_scatter() {
        for (const bool near : {true, false}) {
            test::RandomPoints random(16);
            auto pairs = corner_touches({}, random, 2.0);
            for (std::size_t i = 0; i < 6; ++i) {
                const double angle = static_cast<double>(i);
                pairs[10 * i].surface =
                    pairs[10 * i].device + (near ? 4.2 : 9.0) * Vec2(std::cos(angle), std::sin(angle));
            }
            const auto found = calibrate(pairs, 100.0);
            QVERIFY2(found.ok(), found.error().c_str());
            QCOMPARE(found->used, near ? std::size_t(60) : std::size_t(54));
            QVERIFY(farthest_apart(found->device_to_surface, {}) < 1.5);
        }
    }

    /// Marks in a strip: across it, a map would be guessed from how the finger trembles.
    void marks_in_a_narrow_strip_are_a_line() {
        for (const double half_width : {1.0, 1.6})
            for (const bool upright : {false, true}) {
                std::vector<FramePair> pairs;
                for (const double along : {-60.0, -30.0, 0.0, 30.0, 60.0})
                    for (const double across : {-half_width, half_width}) {
                        const Vec2 place = upright ? Vec2(across, along) : Vec2(along, across);
                        pairs.push_back({place, place});
                    }
                const auto found = calibrate(pairs);
                QCOMPARE(found.ok(), half_width > 1.5);
                if (!found)
                    QVERIFY2(found.error().find("one line") != std::string::npos, found.error().c_str());
            }
    }

    /// A touchscreen as narrow as that makes lines of all that is felt.
    void a_surface_in_a_narrow_strip_is_a_line() {
        for (const double squeezed : {0.025, 0.06}) {
            std::vector<FramePair> pairs;
            for (const double x : {-60.0, 0.0, 60.0})
                for (const double y : {-60.0, 0.0, 60.0})
                    pairs.push_back({{x, y}, {x, squeezed * y}});
            QCOMPARE(calibrate(pairs).ok(), squeezed > 0.03);
        }
    }

    void one_mark_that_is_wrong_does_not_count() {
        test::RandomPoints random(8);
        auto pairs = samples({}, random, 0.0);
        pairs[4].surface += Vec2(20, 0);
        const auto found = calibrate(pairs);
        QVERIFY2(found.ok(), found.error().c_str());
        QCOMPARE(found->used, std::size_t(8));
        QVERIFY(found->residual_mm < 1e-9);
        QVERIFY(farthest_apart(found->device_to_surface, {}) < 1e-9);
    }

    /// Whichever they are, and however few there are in all.
    void a_fifth_of_few_marks_may_be_wrong() {
        for (const std::size_t count : {std::size_t(5), std::size_t(10), std::size_t(15)}) {
            test::RandomPoints random(17 + count);
            for (int time = 0; time < 20; ++time) {
                const Affine truth = frame(18.0 * time, time % 2 == 0);
                std::vector<FramePair> pairs;
                for (std::size_t i = 0; i < count; ++i) {
                    const double angle =
                        6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
                    const Vec2 place(60.0 * std::cos(angle), 40.0 * std::sin(angle));
                    pairs.push_back({place, truth(place)});
                }
                for (std::size_t i = 0; i < count / 5; ++i)
                    pairs[5 * i + random.below(5)].surface += Vec2(30.0, -40.0);
                const auto found = calibrate(pairs);
                QVERIFY2(found.ok(), found.error().c_str());
                QCOMPARE(found->used, count - count / 5);
                QVERIFY(farthest_apart(found->device_to_surface, truth) < 1e-9);
            }
        }
    }

    void every_frame_is_found_through_noise_and_a_fifth_of_bad_pairs() {
        test::RandomPoints random(10);
        for (const bool mirrored : {false, true})
            for (double degrees = 0.0; degrees < 360.0; degrees += 15.0)
                for (const bool clustered : {false, true}) { // each bad pair somewhere, or all at one place
                    const Affine truth = frame(degrees, mirrored);
                    auto pairs = corner_touches(truth, random, 0.5);
                    for (std::size_t i = 0; i < pairs.size() / 5; ++i)
                        pairs[5 * i + random.below(5)].surface =
                            clustered ? Vec2(150.0, 150.0) : random.point(150.0);
                    const auto found = calibrate(pairs);
                    QVERIFY2(found.ok(), found.error().c_str());
                    QVERIFY2(farthest_apart(found->device_to_surface, truth) < 0.5,
                             qPrintable(QString::number(farthest_apart(found->device_to_surface, truth))));
                    QVERIFY(found->residual_mm < 0.5);
                    QVERIFY(found->used >= pairs.size() - pairs.size() / 5 - 2);
                    QCOMPARE(found->device_to_surface.determinant() < 0.0, mirrored);
                }
    }

    void more_than_a_fifth_of_bad_pairs_is_refused() {
        test::RandomPoints random(11);
        for (int i = 0; i < 20; ++i) {
            auto pairs = corner_touches(frame(30.0, false), random, 0.2);
            const std::size_t bad = i % 2 == 0 ? 2 : 3;
            for (std::size_t k = 0; k < pairs.size(); ++k)
                if (k % 5 < bad)
                    pairs[k].surface = random.point(150.0);
            QVERIFY(!calibrate(pairs).ok());
        }
    }

    /// A line and a few bad pairs beside it: a map through them would fit, and mean nothing.
    void a_line_is_no_calibration_though_bad_pairs_lie_beside_it() {
        test::RandomPoints random(12);
        for (const bool one_place : {false, true}) {
            std::vector<FramePair> pairs;
            for (int i = 0; i < 40; ++i)
                pairs.push_back({{2.0 * i - 40.0, i - 20.0}, {2.0 * i - 40.0, i - 20.0}});
            for (int i = 0; i < 8; ++i)
                pairs[static_cast<std::size_t>(5 * i)] =
                    one_place ? FramePair{{30.0, -40.0}, {-20.0, 60.0}}
                              : FramePair{random.point(80.0), random.point(80.0)};
            const auto found = calibrate(pairs);
            QVERIFY(!found.ok());
            QVERIFY2(found.error().find("touch") != std::string::npos, found.error().c_str());
        }
    }

    void noise_that_is_too_much_is_told_in_millimetres() {
        test::RandomPoints random(13);
        const auto found = calibrate(corner_touches(frame(0.0, false), random, 6.0));
        QVERIFY(!found.ok());
        QVERIFY2(found.error().find("more than the 2.0 mm allowed") != std::string::npos,
                 found.error().c_str());
        const auto small = calibrate(corner_touches(frame(0.0, false), random, 1.5));
        QVERIFY2(small.ok(), small.error().c_str());
        QVERIFY(small->residual_mm > 0.5 && small->residual_mm < 2.0);
    }

    void the_same_pairs_give_the_same_map() {
        test::RandomPoints random(14);
        const auto pairs = corner_touches(frame(77.0, true), random, 0.5);
        const auto a = calibrate(pairs);
        const auto b = calibrate(pairs);
        QVERIFY(a.ok() && b.ok());
        QVERIFY(a->device_to_surface.linear == b->device_to_surface.linear);
        QVERIFY(a->device_to_surface.offset == b->device_to_surface.offset);
    }
};

} // namespace calibration_test

TP_TEST(calibration_test, CalibrationTest, event_loop)
#include "calibration_test.moc"
