// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_trace.hpp"
#include "app/pages/lab/plot_curves.hpp"
#include "test_program.hpp"

#include <QByteArray>
#include <QList>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace lab_trace_test {

using namespace tp;

namespace {

/// Ticks of a finger at (t, 0) mm and a force of (1, 0) N, one a millisecond.
LabTrace steady(int count, std::size_t delay = 0) {
    LabTrace trace;
    trace.begin(1000.0, delay);
    for (int i = 0; i < count; ++i)
        trace.add({5.0 + 0.001 * i, Vec2(0.001 * i, 0.0), Vec2(1.0, 0.0)});
    return trace;
}

} // namespace

class LabTraceTest : public QObject {
    Q_OBJECT
private slots:
    void it_begins_at_zero_and_keeps_ten_seconds() {
        const LabTrace trace = steady(15'001);
        QCOMPARE(trace.points().back().time, 15.0);
        QVERIFY(std::abs(trace.points().front().time - 5.0) < 0.0011);
        QVERIFY(trace.points().size() >= 10'000 && trace.points().size() <= 10'002);
    }

    void the_energy_is_force_times_way_of_the_whole_run_in_joules() {
        // 1 N over 15 mm is 15 mJ.
        QVERIFY(std::abs(steady(15'001).points().back().energy - 0.015) < 1e-9);
        QCOMPARE(steady(1).points().back().energy, 0.0);
    }

    void a_delayed_force_does_its_work_when_it_acts() {
        for (const std::size_t delay : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
            LabTrace trace;
            trace.begin(1000.0, delay);
            double expected = 0.0;
            std::mt19937 random(3);
            std::normal_distribution<double> normal;
            std::vector<TickSample> ticks;
            for (int i = 0; i < 200; ++i) {
                ticks.push_back({0.001 * i, {normal(random), normal(random)}, {normal(random), normal(random)}});
                trace.add(ticks.back());
                const auto k = static_cast<std::size_t>(i);
                if (k > delay)
                    expected += 1e-3 * glm::dot(ticks[k - 1 - delay].force, ticks[k].place - ticks[k - 1].place);
            }
            QVERIFY(std::abs(trace.points().back().energy - expected) < 1e-12);
        }
    }

    void a_conservative_force_gives_no_more_than_its_potential_round_a_loop() {
        // A spring to (0, 0): round a circle that comes back the sum is the error of the steps.
        LabTrace trace;
        trace.begin(1000.0, 0);
        const int count = 6284;
        for (int i = 0; i <= count; ++i) {
            const double angle = 2.0 * M_PI * i / count;
            const Vec2 place(3.0 + 2.0 * std::cos(angle), 2.0 * std::sin(angle));
            trace.add({0.001 * i, place, -0.2 * place});
        }
        QVERIFY(std::abs(trace.points().back().energy) < 2e-5);
    }

    void lateness_is_what_a_tick_comes_later_than_a_period() {
        LabTrace trace;
        trace.begin(1000.0, 0);
        for (const double time : {0.0, 0.001, 0.0055, 0.006, 0.007})
            trace.add({time, Vec2(0.0), Vec2(0.0)});
        QVERIFY(std::abs(trace.points()[2].lateness - 0.0035) < 1e-9);
        QCOMPARE(trace.points()[3].lateness, 0.0); // sooner than a period is not late
        QVERIFY(std::abs(trace.range([](const TracePoint& p) { return p.lateness; }).most - 0.0035) < 1e-9);
    }

    void a_table_reads_back_as_the_same_numbers() {
        LabTrace trace;
        trace.begin(1000.0, 1);
        std::mt19937 random(5);
        std::normal_distribution<double> normal;
        for (int i = 0; i < 500; ++i)
            trace.add({0.00103 * i, {30.0 * normal(random), normal(random)}, {normal(random), 1e-9 * normal(random)}});
        QList<QByteArray> lines = QByteArray::fromStdString(trace.csv()).split('\n');
        QCOMPARE(lines.takeFirst(), QByteArray("time_s,x_mm,y_mm,fx_n,fy_n,energy_j,lateness_s"));
        QVERIFY(lines.takeLast().isEmpty());
        QCOMPARE(static_cast<std::size_t>(lines.size()), trace.points().size());
        for (qsizetype i = 0; i < lines.size(); ++i) {
            const QList<QByteArray> cells = lines[i].split(',');
            const TracePoint& p = trace.points()[static_cast<std::size_t>(i)];
            const double expected[] = {p.time, p.x, p.y, p.fx, p.fy, p.energy, p.lateness};
            QCOMPARE(cells.size(), 7);
            for (int k = 0; k < 7; ++k)
                QVERIFY2(cells[k].toDouble() == expected[k], lines[i].constData());
        }
    }

    void an_empty_trace_is_a_header_and_plots_nothing() {
        const LabTrace trace;
        QCOMPARE(QByteArray::fromStdString(trace.csv()).count('\n'), 1);
        for (const TraceQuantity quantity :
             {TraceQuantity::position, TraceQuantity::force, TraceQuantity::energy, TraceQuantity::lateness}) {
            const TracePlot& plot = trace_plot(quantity);
            const LabTrace::Range axis = axis_for(range_of(trace, plot), plot);
            QVERIFY(axis.most > axis.least);
            QVERIFY(columns_of(trace, plot.curves[0], 100).empty());
        }
    }

    void a_peak_of_one_tick_is_seen_in_few_columns() {
        LabTrace trace;
        trace.begin(1000.0, 0);
        for (int i = 0; i < 10'000; ++i)
            trace.add({0.001 * i, Vec2(0.0), Vec2(i == 4321 ? 0.9 : 0.0, 0.0)});
        const auto columns = columns_of(trace, trace_plot(TraceQuantity::force).curves[0], 50);
        QCOMPARE(columns.size(), std::size_t{50});
        int peaks = 0;
        for (const CurveColumn& column : columns) {
            QCOMPARE(column.least, 0.0);
            peaks += column.most == 0.9 ? 1 : 0;
        }
        QCOMPARE(peaks, 1);
    }

    void a_short_run_fills_the_left_of_a_plot() {
        const auto columns = columns_of(steady(1000), trace_plot(TraceQuantity::force).curves[0], 100);
        QVERIFY(columns.back().column <= 10);
    }

    void an_axis_holds_its_range_and_is_not_much_larger() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> place(-90.0, 90.0);
        for (const TraceQuantity quantity : {TraceQuantity::position, TraceQuantity::energy}) {
            const TracePlot& plot = trace_plot(quantity);
            for (int i = 0; i < 500; ++i) {
                const double a = place(random);
                const double b = place(random);
                const LabTrace::Range axis = axis_for({std::min(a, b), std::max(a, b)}, plot);
                QVERIFY(axis.least <= std::min(a, b) && axis.most >= std::max(a, b));
                QVERIFY(axis.most - axis.least <= 2.0 * std::max(plot.least_span, std::abs(a - b)));
            }
        }
    }
};

} // namespace lab_trace_test

TP_TEST(lab_trace_test, LabTraceTest, event_loop)
#include "lab_trace_test.moc"
