// SPDX-License-Identifier: Apache-2.0
// What is seen of a run: curves over the last ten seconds, up where there is more, with a grid and its numbers.
#include "app/pages/lab/plot_item.hpp"
#include "drawn_item.hpp"
#include "lab_parts.hpp"
#include "test_program.hpp"

#include <QTest>

namespace plot_item_test {

using namespace tp;
using namespace tp::testing;

namespace {

const QColor line(255, 60, 60), second(60, 90, 255), text(250, 250, 250), grid(0, 0, 0);

struct Bench : DrawnItem<PlotItem> {
    LabParts parts;

    explicit Bench(LabMeasurements::Quantity quantity) : DrawnItem({600, 200}) {
        set("lineColor", line);
        set("secondColor", second);
        set("textColor", text);
        set("gridColor", grid);
        set("textSize", 14.0);
        set("quantity", quantity);
        item.setMeasurements(&parts.measurements);
        parts.measurements.begin(100.0, 0);
    }
    ~Bench() { item.setMeasurements(nullptr); }
    /// So long a run: the finger goes 1 mm a second to the right, and its force is so strong in the second half.
    void run(double seconds, double newtons) {
        for (double t = 0.0; t < seconds; t += 0.01)
            parts.measurements.add({t, {t, 20.0}, {t < 0.5 * seconds ? 0.0 : newtons, 0.0}});
        parts.measurements.renew();
    }
};

} // namespace

class PlotItemTest : public QObject {
    Q_OBJECT
private slots:
    void before_a_run_there_are_axes_and_no_curve() {
        Bench bench(LabMeasurements::Force);
        const QImage seen = bench.picture();
        QVERIFY(extent_of(seen, line).isEmpty());
        const QRect axes = extent_of(seen, grid);
        QVERIFY(axes.width() > 400 && axes.height() > 120 &&
                axes.left() > 40); // its numbers stand at the left
        QVERIFY(!extent_of(seen.copy(0, 0, axes.left(), 200), text).isEmpty());
        QVERIFY(!extent_of(seen.copy(0, axes.bottom() + 2, 600, 198 - axes.bottom()), text).isEmpty());
    }

    void the_curve_lies_where_and_when_it_was_measured() {
        Bench bench(LabMeasurements::Force);
        const QRect axes = extent_of(bench.picture(), grid);
        bench.run(5.0, 0.9); // the axis ends there
        const QImage seen = bench.picture();
        const QRect curve = extent_of(seen, line);
        QVERIFY2(std::abs(curve.left() - axes.left()) < 4 &&
                     std::abs(curve.right() - (axes.left() + 0.5 * axes.width())) < 6,
                 qPrintable(QString("%1 to %2").arg(curve.left()).arg(curve.right())));
        QVERIFY(std::abs(curve.top() - axes.top()) < 5 && std::abs(curve.bottom() - axes.bottom()) < 5);
        const int soft = axes.left() + axes.width() / 8, strong = axes.left() + axes.width() * 3 / 8;
        QVERIFY(rows_of(seen, soft, line, 0, axes.bottom() - 6) == 0);
        QVERIFY(rows_of(seen, strong, line, 0, axes.bottom() - 6) > 0);
        QVERIFY(extent_of(seen, second).isEmpty());
    }

    void of_a_place_both_coordinates_are_seen_the_second_one_dashed() {
        Bench bench(LabMeasurements::Position);
        bench.run(8.0, 0.1);
        const QImage seen = bench.picture();
        const QRect x = extent_of(seen, line), y = extent_of(seen, second);
        QVERIFY(x.height() > 30); // it rises
        QVERIFY(y.top() < x.top());
        int gaps = 0;
        for (int column = y.left() + 40; column < y.right(); ++column)
            gaps += rows_of(seen, column, second, y.top(), y.top() + 5) == 0 ? 1 : 0;
        QVERIFY2(gaps > 40, qPrintable(QString::number(gaps)));
    }

    void what_trembles_is_a_band() {
        Bench bench(LabMeasurements::Force);
        bench.parts.measurements.begin(1000.0, 0);
        for (int tick = 0; tick < 5000; ++tick)
            bench.parts.measurements.add({0.001 * tick, {0.0, 0.0}, {tick % 2 == 0 ? 0.2 : 0.9, 0.0}});
        bench.parts.measurements.renew();
        const QImage seen = bench.picture();
        const QRect axes = extent_of(seen, grid); // from 0 to 0.9 N
        QVERIFY(rows_of(seen, axes.left() + axes.width() / 4, line) > 0.7 * axes.height());
    }

    void another_quantity_and_a_run_that_goes_on_are_seen() {
        Bench bench(LabMeasurements::Force);
        bench.run(5.0, 0.9);
        const QImage force = bench.picture();
        bench.set("quantity", LabMeasurements::Energy);
        QVERIFY(bench.picture() != force);
        bench.set("quantity", LabMeasurements::Force);
        QVERIFY(bench.picture() == force);
        bench.parts.measurements.begin(100.0, 0);
        bench.parts.measurements.renew();
        QVERIFY(extent_of(bench.picture(), line).isEmpty());
        bench.item.setMeasurements(nullptr);
        QVERIFY(extent_of(bench.picture(), grid).isEmpty());
    }

    void where_there_is_no_room_nothing_is_drawn() {
        Bench bench(LabMeasurements::Force);
        bench.run(5.0, 0.9);
        bench.item.setSize({60, 200});
        QVERIFY(extent_of(bench.picture(), line).isEmpty() && extent_of(bench.picture(), grid).isEmpty());
    }
};

} // namespace plot_item_test

TP_TEST(plot_item_test, PlotItemTest, window)
#include "plot_item_test.moc"
