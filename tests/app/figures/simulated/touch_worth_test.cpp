// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/touch_trials.hpp"
#include "app/figures/simulated/touch_worth.hpp"

#include <QTest>

using namespace tp;

namespace {

const TouchPlan few{3, 1, 1, {0.005, 0.1}};

TouchRow row_of(TouchManner manner, double latency_s, const TouchPlan& plan = few) {
    const auto row = measure_touch_row(plan, manner, latency_s, [] { return false; });
    return row ? *row : TouchRow{};
}

} // namespace

class TouchWorthTest : public QObject {
    Q_OBJECT
private slots:
    void lines_are_found_and_followed_by_each_manner() {
        for (const TouchManner manner : {TouchManner::force, TouchManner::resistance, TouchManner::ticks}) {
            const TouchRow row = row_of(manner, 0.005);
            QVERIFY(row.manner == manner && row.latency_s == 0.005 && row.trials == 9);
            QVERIFY(row.found >= 8 && row.find_s > 0.5 && row.find_s < 60.0);
            QVERIFY(row.followed >= 4 && row.follow_s > 5.0 && row.follow_s <= longest_touch_s);
            QVERIFY(row.error_mm > 0.5 && row.error_mm < 10.0);
        }
    }

    void late_touch_is_worth_less_than_soon() {
        for (const TouchManner manner : {TouchManner::resistance, TouchManner::ticks}) {
            const TouchRow soon = row_of(manner, 0.005), late = row_of(manner, 0.1);
            QVERIFY(late.followed <= soon.followed && late.lost > soon.lost);
            QVERIFY(late.error_mm > soon.error_mm);
        }
    }

    void friction_and_ticks_are_not_the_same() {
        const TouchRow friction = row_of(TouchManner::resistance, 0.02),
                       ticks = row_of(TouchManner::ticks, 0.02);
        QVERIFY(friction.find_s != ticks.find_s && friction.lost != ticks.lost);
    }

    void the_same_people_do_the_same_again() {
        const TouchRow one = row_of(TouchManner::ticks, 0.02), again = row_of(TouchManner::ticks, 0.02);
        QVERIFY(one.find_s == again.find_s && one.follow_s == again.follow_s && one.lost == again.lost);
        const TouchRow others = row_of(TouchManner::ticks, 0.02, {3, 2, 1, {}});
        QVERIFY(one.find_s != others.find_s);
    }

    void all_rows_are_measured_told_of_and_tabled() {
        std::vector<double> told;
        const TouchPlan plan{1, 1, 1, {0.005, 0.05}};
        const auto rows = measure_touch(
            plan, [&](double share) { told.push_back(share); }, [] { return false; });
        QVERIFY(rows.ok() && rows->size() == 5 && told == std::vector<double>({0.2, 0.4, 0.6, 0.8, 1.0}));
        QVERIFY((*rows)[0].manner == TouchManner::force && (*rows)[1].manner == TouchManner::resistance);
        QVERIFY((*rows)[4].manner == TouchManner::ticks && (*rows)[4].latency_s == 0.05);
        QCOMPARE(touch_table(*rows).row_count(), std::size_t(5));
        const auto stopped = measure_touch(
            plan, [](double) {}, [] { return true; });
        QVERIFY(stopped.ok() && stopped->empty());
    }

    void a_line_lies_on_the_surface_and_has_its_knots() {
        for (const StudyShape shape : {StudyShape::circle, StudyShape::triangle, StudyShape::curve})
            for (std::uint64_t seed = 1; seed < 20; ++seed) {
                const StudyTrial trial = touch_trial(shape, seed);
                QCOMPARE(trial.knots.size(), std::size_t(5));
                for (const Vec2 place : trial.path.points)
                    QVERIFY(trial.scene.surface().contains(place));
                QVERIFY(trial.start == trial.path.points.front() && trial.reach_mm > 0.0);
            }
    }
};

QTEST_APPLESS_MAIN(TouchWorthTest)
#include "touch_worth_test.moc"
