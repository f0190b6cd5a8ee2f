// SPDX-License-Identifier: Apache-2.0
#include "core/participant/way_belief.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace way_belief_test {

using namespace tp;

namespace {

constexpr std::array<WayError, 2> exact{WayError{0.5, 20.0}, WayError{}};
constexpr std::array<WayError, 2> steered{WayError{5.0, 30.0}, WayError{}};

/// A share of the way round a shape about the middle, a place every 2 mm; from the middle of a side on.
std::vector<FeltPlace> part_of(int corners, double radius, double turn, double share,
                               bool backwards = false) {
    std::vector<FeltPlace> way;
    const int count = static_cast<int>(std::numbers::pi * radius * share);
    const auto at = [&](double part) {
        const double angle = 2.0 * std::numbers::pi * (backwards ? -part : part);
        double length = radius;
        if (corners > 0) {
            const double side = 2.0 * std::numbers::pi / corners;
            const double from_middle = angle - side * std::round(angle / side);
            length *= std::cos(0.5 * side) / std::cos(from_middle);
        }
        return length * Vec2(std::cos(angle + turn), std::sin(angle + turn));
    };
    for (int i = 0; i <= count; ++i) {
        const Vec2 ahead = at((i + 0.5) * share / count) - at((i - 0.5) * share / count);
        way.push_back({at(i * share / count), ahead / length(ahead)});
    }
    return way;
}

std::size_t index_of(int corners) {
    return static_cast<std::size_t>(std::ranges::find(shape_corners, corners) - shape_corners.begin());
}

} // namespace

class WayBeliefTest : public QObject {
    Q_OBJECT
private slots:
    void two_corners_or_an_even_bend_are_enough() {
        for (const int corners : shape_corners)
            for (const double radius : {20.0, 50.0, 80.0})
                for (const bool backwards : {false, true}) {
                    const auto beliefs =
                        beliefs_of(part_of(corners, radius, 0.3 * radius, 0.7, backwards), exact, steered);
                    const auto best = std::ranges::max_element(beliefs) - beliefs.begin();
                    QVERIFY2(shape_corners[static_cast<std::size_t>(best)] == corners,
                             qPrintable(QString("%1 corners, %2 mm").arg(corners).arg(radius)));
                    QVERIFY(std::abs(beliefs[0] + beliefs[1] + beliefs[2] + beliefs[3] + beliefs[4] - 1.0) <
                            1e-12);
                }
    }
    void a_short_way_tells_nothing() {
        for (const double belief : beliefs_of(part_of(3, 50.0, 0.0, 0.1), exact, steered))
            QCOMPARE(belief, 0.2);
        for (const double belief : beliefs_of({}, exact, steered))
            QCOMPARE(belief, 0.2);
    }
    void more_of_the_way_tells_more_and_an_inexact_memory_less() {
        for (const int corners : {4, 5, 6}) {
            const double half =
                beliefs_of(part_of(corners, 50.0, 0.2, 0.4), exact, steered)[index_of(corners)];
            const double whole =
                beliefs_of(part_of(corners, 50.0, 0.2, 1.0), exact, steered)[index_of(corners)];
            const double vague =
                beliefs_of(part_of(corners, 50.0, 0.2, 1.0), {WayError{6.0, 120.0}, WayError{}},
                           {WayError{40.0, 30.0}, WayError{}})[index_of(corners)];
            QVERIFY2(
                whole > half && whole > 0.95 && vague < 0.8,
                qPrintable(QString("%1 corners: %2 %3 %4").arg(corners).arg(half).arg(whole).arg(vague)));
        }
    }
    /// As where the finger left the line for a moment.
    void a_place_far_off_does_not_matter() {
        for (const int corners : shape_corners) {
            auto way = part_of(corners, 50.0, 0.2, 0.9);
            way[way.size() / 2].place *= 1.5;
            way[way.size() / 3].heading = -way[way.size() / 3].heading;
            const double belief = beliefs_of(way, exact, steered)[index_of(corners)];
            QVERIFY2(belief > 0.8, qPrintable(QString("%1 corners: %2").arg(corners).arg(belief)));
        }
    }
};

} // namespace way_belief_test

TP_TEST(way_belief_test, WayBeliefTest, nothing)
#include "way_belief_test.moc"
