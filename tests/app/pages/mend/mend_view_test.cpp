// SPDX-License-Identifier: Apache-2.0
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>

namespace mend_view_test {

using namespace tp;

namespace {

bool near_to(QPointF one, QPointF other) {
    return std::hypot(one.x() - other.x(), one.y() - other.y()) < 1e-9;
}

/// The drawn photograph of 400 × 300 px in a window of 800 × 600.
struct ViewBench {
    QTemporaryDir folder;
    MendedPhoto photo;
    MendView view{photo};

    ViewBench() {
        view.setWindow(800, 600);
        photo.show(drawn_mend_photo(folder.path()));
    }
};

} // namespace

class MendViewTest : public QObject {
    Q_OBJECT
private slots:
    void a_photograph_is_seen_as_a_whole() {
        ViewBench bench;
        QCOMPARE(bench.view.scale(), 2.0);
        QCOMPARE(bench.view.photo_rect(), QRectF(0, 0, 800, 600));
        bench.view.setWindow(1600, 600); // it is not made larger, and keeps its middle
        QCOMPARE(bench.view.scale(), 2.0);
        QCOMPARE(bench.view.photo_rect(), QRectF(400, 0, 800, 600));
        bench.view.setWindow(1600, 1200);
        QCOMPARE(bench.view.scale(), 4.0);
    }
    void window_and_photograph_are_each_others_inverse() {
        ViewBench bench;
        bench.view.zoomAt(3.7, 123, 456);
        const Vec2 place(17.25, 203.5);
        QVERIFY(length(bench.view.to_photo(bench.view.to_window(place)) - place) < 1e-9);
        QVERIFY(near_to(bench.view.to_window({bench.view.origin().x(), bench.view.origin().y()}), {0, 0}));
    }
    void what_is_under_the_hand_stays_there_while_it_grows() {
        ViewBench bench;
        const Vec2 under = bench.view.to_photo({200, 500});
        bench.view.zoomAt(1.5, 200, 500);
        QCOMPARE(bench.view.scale(), 3.0);
        QVERIFY(near_to(bench.view.to_window(under), {200, 500}));
        bench.view.zoomAt(1e6, 200, 500);
        QCOMPARE(bench.view.scale(), MendView::largest_scale);
        bench.view.zoomAt(1e-6, 200, 500);
        QCOMPARE(bench.view.scale(), 2.0); // the whole photograph
        for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
            bench.view.zoomAt(none, 200, 500);
        QCOMPARE(bench.view.scale(), 2.0);
    }
    void a_part_is_shown_with_room_round_it() {
        ViewBench bench;
        bench.view.show({{100, 100}, {140, 120}});
        QVERIFY(near_to(bench.view.to_window({120, 110}), bench.view.middle()));
        QVERIFY(std::abs(bench.view.scale() * 40 - 0.66 * 800) < 1e-9);
        bench.view.showAll();
        QCOMPARE(bench.view.scale(), 2.0);
    }
    void the_photograph_cannot_be_pushed_out_of_sight() {
        ViewBench bench;
        bench.view.panBy(-30, 10);
        QCOMPARE(bench.view.photo_rect(), QRectF(-30, 10, 800, 600));
        bench.view.panBy(-1e6, 1e6);
        QVERIFY(near_to(bench.view.photo_rect().topRight(), bench.view.middle()));
    }
    void a_place_out_of_sight_comes_in_and_no_further() {
        ViewBench bench;
        bench.view.zoomAt(10, 400, 300);
        const Vec2 away = bench.view.to_photo({1000, -50});
        bench.view.bring_in_sight(away);
        QVERIFY(near_to(bench.view.to_window(away), {720, 60}));
        const QPointF before = bench.view.origin();
        bench.view.bring_in_sight(away);
        QVERIFY(near_to(bench.view.origin(), before));
    }
};

} // namespace mend_view_test

TP_TEST(mend_view_test, MendViewTest, event_loop)
#include "mend_view_test.moc"
