// SPDX-License-Identifier: Apache-2.0
#include "core/participant/felt_shape.hpp"

#include <QTest>

#include <cmath>
#include <numbers>

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
    person.length_share = 1e-9;
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
    void nothing_is_named_before_a_round_and_something_after() {
        ShapeNamer namer(exact_memory(), 1);
        const auto trail = trail_round(4, 50.0, 0.0, 1.2);
        QVERIFY(!namer.hear(std::span(trail).first(60)) && !namer.guess());
        QCOMPARE(namer.hear(trail), std::optional(4));
        QCOMPARE(namer.guess(), std::optional(4));
        QCOMPARE(namer.rounds(), 1);
    }
    void one_who_is_not_sure_goes_round_again_and_answers_at_last() {
        Person person;
        person.length_share = 1e-9;
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
        QVERIFY(namer.rounds() > 1 && namer.rounds() <= 3);
    }
    /// A polygon has a turn to choose, and would otherwise explain any uneven circle better.
    void a_circle_that_is_remembered_inexactly_is_mostly_a_circle() {
        QVERIFY2(rightly(Person{}, 0, 80.0, 40) >= 24,
                 qPrintable(QString::number(rightly(Person{}, 0, 80.0, 40))));
    }
    /// The places of one are remembered too inexactly for that.
    void a_small_shape_is_known_by_how_the_way_turned() {
        for (const bool backwards : {false, true})
            for (const int corners : shape_corners) {
                const int right = rightly(Person{}, corners, 20.0, 40, backwards);
                QVERIFY2(right >= 36, qPrintable(QString("%1 corners: %2").arg(corners).arg(right)));
            }
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
        for (const int corners : {4, 5, 6}) {
            QCOMPARE(rightly(exact_memory(), corners, 50.0, 20), 20);
            QVERIFY(rightly(bad, corners, 50.0, 20) < 15);
        }
    }
};

QTEST_APPLESS_MAIN(FeltShapeTest)
#include "felt_shape_test.moc"
