// SPDX-License-Identifier: Apache-2.0
// The finger is looked at while there is something to feel; with the finger up for two seconds nothing ticks, and it is back at
// a touch.
#include "app/pages/explore/explore_device.hpp"
#include "app/pages/explore/explore_touch.hpp"
#include "app/pages/explore/explore_watch.hpp"
#include "app/pages/explore/rest_watch.hpp"
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QTest>

namespace explore_watch_test {

using namespace tp;

namespace {

struct Bench : ExploreParts {
    ExploreDevice device{servo, view, finger, tour, ear, choices, words, settings};
    ExploreTouch touch{servo, view, tour, ear, choices, words, device, settings};
    ExploreWatch watch{servo, view, finger, tour, ear, device, touch, now};

    explicit Bench(int faces = 1) : ExploreParts(faces) {
        timer.stop(); // the watch looks
        watch.enter();
        QTest::qWait(40); // it has looked
    }
    QPointF beside_the_outline(double away = 2.0) const { return left_of_outline(away); }
    bool rests() const { return watch.state() == ExploreWatch::State::resting; }
    /// The page's time passes, and it looks at what there is.
    void pass(double seconds) {
        for (double t = 0.0; t < seconds; t += 0.5) {
            time += 0.5;
            QTest::qWait(40);
        }
    }
    bool comes_to_rest() {
        pass(RestWatch::after_s + 0.5);
        return QTest::qWaitFor([this] { return rests(); }, 20'000) && servo.parked();
    }
};

} // namespace

class ExploreWatchTest : public QObject {
    Q_OBJECT
private slots:
    void it_is_due_after_two_quiet_seconds_in_one() {
        RestWatch watch;
        QVERIFY(!watch.due(true, 10.0));
        QVERIFY(!watch.due(true, 11.9));
        QVERIFY(!watch.due(false, 11.95));
        QVERIFY(!watch.due(true, 12.5));
        QVERIFY(!watch.due(true, 14.4));
        QVERIFY(watch.due(true, 14.5));
        watch.stir();
        QVERIFY(!watch.due(true, 20.0));
        QVERIFY(watch.due(true, 22.0));
    }

    void where_nobody_comes_it_rests_with_the_force_still_wanted() {
        Bench bench;
        bench.pass(1.5);
        QVERIFY(!bench.rests());
        QVERIFY(bench.comes_to_rest());
        QVERIFY(bench.servo.engaged());
    }

    void two_seconds_after_the_finger_was_lifted_it_rests_and_a_touch_wakes_it() {
        Bench bench;
        bench.down(bench.beside_the_outline());
        QTRY_VERIFY(bench.finger.newtons() > 0.1);
        bench.pass(5.0);
        QVERIFY(!bench.rests()); // a finger that lies still feels
        bench.hand.fingerUp(0);
        bench.pass(1.5);
        QVERIFY(!bench.rests());
        QVERIFY(bench.comes_to_rest());
        bench.voice.clear();
        bench.down(bench.beside_the_outline());
        QVERIFY(!bench.rests());
        QTRY_VERIFY(bench.finger.newtons() > 0.1); // the force is there again
        const QPointF on_it = bench.beside_the_outline(0.0);
        bench.hand.fingerMoved(0, on_it.x(), on_it.y());
        bench.pass(1.0);
        QVERIFY(!bench.voice.said().filter("outline").isEmpty()); // and it is told
    }

    void a_mouse_that_rests_on_the_picture_is_felt_and_one_that_has_gone_is_not() {
        Bench bench;
        const QPointF place = bench.beside_the_outline();
        bench.hand.touchDown(place.x(), place.y());
        bench.pass(5.0);
        QVERIFY(!bench.rests());
        bench.hand.handGone();
        QVERIFY(bench.comes_to_rest());
        bench.hand.moveTo(place.x() + 1.0, place.y());
        QVERIFY(!bench.rests());
        bench.hand.handGone();
        QVERIFY(bench.comes_to_rest());
        bench.hand.nudge(2.0, 0.0); // the keys stay where they are
        bench.pass(5.0);
        QVERIFY(!bench.rests());
    }

    void a_tour_goes_on_and_begins_from_rest() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        bench.tour.toggleFace();
        QVERIFY(bench.tour.touring());
        QVERIFY(!bench.rests());
        bench.pass(5.0);
        QVERIFY(!bench.rests());
        QTRY_COMPARE(bench.tour.state(), ExploreTour::State::Leading); // its names are told, too
        bench.tour.toggleFace();
        QVERIFY(bench.comes_to_rest());
        bench.tour.toggle();
        QTRY_VERIFY(bench.tour.progress() > 0.0);
    }

    void out_of_sight_it_looks_at_nothing_and_sees_all_once_it_is_back() {
        Bench bench;
        bench.watch.leave();
        QVERIFY(bench.watch.state() == ExploreWatch::State::away);
        bench.voice.clear();
        bench.down(bench.beside_the_outline(0.0));
        bench.view.show(drawn_photo(2));
        bench.pass(1.0);
        QCOMPARE(bench.finger.featureName(), QString());
        QCOMPARE(bench.finger.newtons(), 0.0);
        QVERIFY(bench.watch.state() == ExploreWatch::State::away);
        bench.watch.enter();
        QVERIFY(bench.watch.state() == ExploreWatch::State::watching);
        bench.servo.engage();
        bench.down(bench.beside_the_outline());
        QTRY_VERIFY(bench.finger.newtons() > 0.1);
    }

    void from_rest_it_may_go_out_of_sight_and_come_back() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        bench.watch.leave();
        bench.pass(3.0);
        bench.watch.enter();
        bench.servo.engage();
        bench.pass(1.0);
        QVERIFY(!bench.rests()); // one may just have come
        QVERIFY(bench.comes_to_rest());
    }

    void another_photograph_is_felt_for_a_while_before_it_rests() {
        Bench bench;
        QVERIFY(bench.comes_to_rest());
        bench.view.show(drawn_photo(2));
        QVERIFY(!bench.rests());
        bench.pass(1.0);
        QVERIFY(!bench.rests());
        QVERIFY(bench.comes_to_rest());
    }
};

} // namespace explore_watch_test

TP_TEST(explore_watch_test, ExploreWatchTest, event_loop)
#include "explore_watch_test.moc"
