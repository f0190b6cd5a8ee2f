// SPDX-License-Identifier: Apache-2.0
#include "core/participant/felt_shape.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <numbers>

namespace felt_shape_test {

using namespace tp;

namespace {

/// A finger that goes exactly round a shape so many times, a place every 2 mm.
std::vector<FeltPlace> trail_round(int corners, double radius, double turn, double rounds,
                                   bool backwards = false) {
    const auto at = [&](double share) {
        const double angle = 2.0 * std::numbers::pi * (backwards ? -share : share) + turn;
        double length = radius;
        if (corners > 0) {
            const double side = 2.0 * std::numbers::pi / corners;
            length *= std::cos(0.5 * side) /
                      std::cos(angle - turn - side * std::floor((angle - turn) / side) - 0.5 * side);
        }
        return Vec2(12.0, -7.0) + length * Vec2(std::cos(angle), std::sin(angle));
    };
    std::vector<FeltPlace> trail;
    const int count = static_cast<int>(std::numbers::pi * radius * rounds);
    for (int i = 0; i <= count; ++i) {
        const Vec2 way = at((i + 0.5) * rounds / count) - at((i - 0.5) * rounds / count);
        trail.push_back({at(i * rounds / count), way / length(way)});
    }
    return trail;
}

Person exact_memory() {
    Person person;
    person.length_share = person.joint_mm = 1e-9;
    return person;
}

int rightly(const Person& person, int corners, double radius, int times, bool backwards = false) {
    int right = 0;
    for (int i = 0; i < times; ++i) {
        ShapeNamer namer(person, static_cast<std::uint64_t>(i));
        const auto trail = trail_round(corners, radius, 0.37 * i, 3.3, backwards);
        std::optional<int> named;
        for (std::size_t n = 1; n <= trail.size() && !named; ++n)
            named = namer.hear(std::span(trail).first(n));
        right += named == corners ? 1 : 0;
    }
    return right;
}

} // namespace

class FeltShapeTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_felt_exactly_is_named_rightly_whichever_way_round() {
        Chance chance(1);
        for (const int corners : shape_corners)
            for (const double radius : {20.0, 50.0, 80.0})
                for (const bool backwards : {false, true}) {
                    const auto misfits = misfits_of(
                        trail_round(corners, radius, 0.3 * radius, 1.0, backwards), exact_memory(), chance);
                    QVERIFY(misfits);
                    const auto best = std::ranges::min_element(*misfits) - misfits->begin();
                    QCOMPARE(shape_corners[static_cast<std::size_t>(best)], corners);
                }
    }
    void a_round_ends_where_it_began_and_not_before() {
        for (const int corners : shape_corners) {
            const auto trail = trail_round(corners, 50.0, 0.2, 1.5);
            const auto end = round_end(trail, 0, 6.0);
            QVERIFY(end);
            const double share = static_cast<double>(*end) * 1.5 / static_cast<double>(trail.size());
            QVERIFY(share > 0.93 && share < 1.03);
            QVERIFY(!round_end(trail_round(corners, 50.0, 0.2, 0.9), 0, 6.0));
        }
    }
    void going_to_and_fro_is_no_round() {
        auto trail = trail_round(0, 50.0, 0.2, 0.6);
        const auto back = trail_round(0, 50.0, 0.2, 0.6);
        trail.insert(trail.end(), back.rbegin(), back.rend());
        QVERIFY(!round_end(trail, 0, 6.0));
    }
    void a_shape_is_named_before_it_is_closed_but_not_by_its_first_side() {
        for (const int corners : shape_corners) {
            ShapeNamer namer(exact_memory(), 1);
            const auto trail = trail_round(corners, 50.0, 0.0, 0.9);
            std::optional<int> named;
            std::size_t places = 1;
            for (; places <= trail.size() && !named; ++places)
                named = namer.hear(std::span(trail).first(places));
            QCOMPARE(named, std::optional(corners));
            QVERIFY(places > 30 && namer.rounds() == 0 && !namer.guess());
        }
    }
    void one_who_is_not_sure_goes_round_again_and_answers_at_last() {
        Person person; // who trusts neither places nor headings on the way
        person.place_mm = 10.0;
        person.length_share = 0.2;
        person.direction_deg = 500.0;
        person.most_rounds = 3;
        const auto trail = trail_round(0, 50.0, 0.0, 4.5);
        std::vector<FeltPlace> uneven = trail; // neither round nor with corners
        for (std::size_t i = 0; i < uneven.size(); ++i)
            uneven[i].place +=
                6.0 * Vec2(std::sin(0.9 * static_cast<double>(i)), std::cos(1.7 * static_cast<double>(i)));
        ShapeNamer namer(person, 1);
        std::optional<int> named;
        for (std::size_t n = 1; n <= uneven.size() && !named; ++n)
            named = namer.hear(std::span(uneven).first(n));
        QVERIFY(named);
        QVERIFY2(namer.rounds() >= 1 && namer.rounds() <= 3, qPrintable(QString::number(namer.rounds())));
    }
    /// A polygon has a turn to choose, and would otherwise explain any uneven circle better.
    void a_circle_that_is_remembered_inexactly_is_mostly_a_circle() {
        QVERIFY2(rightly(Person{}, 0, 80.0, 40) >= 24,
                 qPrintable(QString::number(rightly(Person{}, 0, 80.0, 40))));
    }
    /// Short sides are known worse, and by their direction: the places of a small shape are too inexact.
    void a_small_shape_is_mostly_known_by_how_the_way_turned_and_less_surely_than_a_large_one() {
        int small = 0, large = 0;
        for (const int corners : {4, 5, 6}) {
            const int right = rightly(Person{}, corners, 20.0, 20, corners == 5);
            QVERIFY2(right >= 13, qPrintable(QString("%1 corners: %2").arg(corners).arg(right)));
            small += right;
            large += rightly(Person{}, corners, 80.0, 20, corners == 5);
        }
        QVERIFY2(small < large, qPrintable(QString("%1, %2").arg(small).arg(large)));
    }
    void a_way_that_turned_evenly_was_a_circle() {
        Chance chance(1);
        int circles = 0;
        for (int i = 0; i < 40; ++i) {
            auto trail = trail_round(6, 20.0, 0.37 * i, 1.0);
            for (FeltPlace& felt : trail) {
                const Vec2 out = felt.place - Vec2(12.0, -7.0);
                felt.heading = Vec2(-out.y, out.x) / length(out);
            }
            const auto misfits = misfits_of(trail, Person{}, chance);
            circles += std::ranges::min_element(*misfits) == misfits->begin() ? 1 : 0;
        }
        QVERIFY2(circles >= 36, qPrintable(QString::number(circles)));
    }
    void headings_that_are_remembered_badly_help_less() {
        Person bad;
        bad.heading_deg = 60.0;
        const int right = rightly(bad, 6, 20.0, 40);
        QVERIFY2(right < 30, qPrintable(QString::number(right)));
    }
    void a_memory_without_error_is_better_than_one_with_much() {
        Person bad;
        bad.length_share = 0.5;
        bad.place_mm = 20.0;
        bad.heading_deg = bad.direction_deg = 60.0;
        for (const int corners : {4, 5, 6}) {
            QCOMPARE(rightly(exact_memory(), corners, 50.0, 8), 8);
            QVERIFY(rightly(bad, corners, 50.0, 8) < 6);
        }
    }
};

} // namespace felt_shape_test

TP_TEST(felt_shape_test, FeltShapeTest, nothing)
#include "felt_shape_test.moc"
