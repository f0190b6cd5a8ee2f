// SPDX-License-Identifier: Apache-2.0
// What taps and swipes of a hand on the surface do.
#include "app/pages/explore/explore_device.hpp"
#include "app/pages/explore/explore_gestures.hpp"
#include "app/pages/explore/explore_walk.hpp"
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QTest>

#include <utility>
#include <vector>

namespace explore_gestures_test {

using namespace tp;

namespace {

/// Each finger that is lifted is asked what it meant.
struct Bench : ExploreParts {
    std::vector<bool>
        walked;    ///< forward or not, each time that the album was asked for the photograph beside
    int stops = 0; ///< how often what sounds or moves was to end, or the force to come back
    ExploreWalk walk{with_album(), view, words};
    ExploreDevice device{servo, view, finger, tour, ear, choices, words, settings};
    ExploreGestures gestures{view, walk, finger, tour, zoom, device};

    explicit Bench(std::vector<QString> names = {}) : ExploreParts(1, std::move(names)) {
        QObject::connect(&hand, &ExploreHand::meant, &gestures, &ExploreGestures::perform);
        QObject::connect(&gestures, &ExploreGestures::stop_or_start_asked, [this] {
            ++stops;
            const bool on = tour.touring() || servo.engaged();
            tour.end();
            on ? servo.disengage() : servo.engage();
        });
    }
    ExploreSettings with_album() {
        ExploreSettings with = settings;
        with.beside = [this](const QString&, bool forward) {
            walked.push_back(forward);
            return QString();
        };
        return with;
    }
    void tap(int fingers, QPointF place, double held = 0.1) {
        time += 0.2;
        for (int i = 0; i < fingers; ++i)
            down(place + QPointF(20.0 * i, 0.0), i);
        time += held;
        for (int i = 0; i < fingers; ++i)
            hand.fingerUp(i);
    }
    void swipe(double across) {
        time += 0.2;
        for (int i = 0; i < 2; ++i)
            down(QPointF(60.0, 40.0 + 20.0 * i), i);
        for (int i = 0; i < 2; ++i)
            hand.fingerMoved(i, 60.0 + across, 40.0 + 20.0 * i);
        time += 0.3;
        for (int i = 0; i < 2; ++i)
            hand.fingerUp(i);
    }
};

} // namespace

class ExploreGesturesTest : public QObject {
    Q_OBJECT
private slots:
    void two_taps_with_a_finger_and_one_with_three_ask_where_one_is() {
        Bench bench;
        const QPointF place = bench.left_of_outline(20.0);
        bench.tap(3, place);
        QVERIFY2(bench.said().startsWith("Beside the face. "), qPrintable(bench.said()));
        bench.voice.clear();
        bench.time += 2.0;
        bench.tap(1, place);
        QCOMPARE(bench.said(), QString());
        bench.tap(1, place);
        QVERIFY2(bench.said().startsWith("Beside the face. "), qPrintable(bench.said()));
        QCOMPARE(bench.stops, 0);
    }

    void one_tap_with_two_fingers_asks_for_an_end_and_nothing_else() {
        Bench bench;
        bench.tap(2, bench.by(left_eye));
        QCOMPARE(bench.stops, 1);
        QVERIFY(!bench.tour.touring());
        QVERIFY(bench.walked.empty());
    }

    void two_taps_with_two_fingers_start_a_tour_and_end_one() {
        for (const bool engaged_before : {true, false}) {
            Bench bench;
            if (!engaged_before)
                bench.servo.disengage();
            bench.tap(2, bench.by(left_eye));
            bench.tap(2, bench.by(left_eye));
            QVERIFY(bench.tour.touring());
            bench.time += 2.0;
            bench.tap(2, bench.by(left_eye));
            bench.tap(2, bench.by(left_eye));
            QVERIFY(!bench.tour.touring());
        }
    }

    void two_fingers_go_to_the_next_and_the_previous_photograph() {
        Bench bench;
        bench.swipe(30.0);
        QCOMPARE(bench.walked, std::vector<bool>({true}));
        QCOMPARE(bench.said(), QString("No photograph with a face comes after this one."));
        bench.time += 2.0;
        bench.swipe(-30.0);
        QCOMPARE(bench.walked, std::vector<bool>({true, false}));
        QCOMPARE(bench.said(), QString("No photograph with a face comes before this one."));
        QVERIFY(bench.servo.engaged()); // nothing was stopped
        QVERIFY(!bench.sounds.guide.sounds());
    }

    void double_tap_and_hold_zooms_to_what_is_there_and_out_where_nothing_is() {
        Bench bench({"Anna"});
        bench.tap(1, bench.by(2)); // the lips
        bench.tap(1, bench.by(2), 0.8);
        QCOMPARE(bench.said(), QString("Zoomed to the mouth of Anna."));
        QCOMPARE(bench.view.featureCount(), 1);
        bench.time += 2.0;
        const QPointF corner(1.0, 1.0);
        bench.tap(1, corner);
        bench.tap(1, corner, 0.8);
        QVERIFY(bench.said().startsWith("There is nothing more") || bench.said().startsWith("Zoomed out"));
        bench.zoom.zoomOut();
        bench.time += 2.0;
        bench.tap(1, bench.left_of_outline(40.0));
        bench.tap(1, bench.left_of_outline(40.0), 0.8);
        QCOMPARE(bench.said(), QString("This is the whole picture."));
        bench.time += 2.0;
        bench.tap(1, bench.by(left_eye));
        bench.tap(1, bench.by(left_eye), 0.8);
        QCOMPARE(bench.said(), QString("Zoomed to the eyes of Anna."));
        QCOMPARE(bench.view.featureCount(), 2);
        bench.time += 2.0;
        bench.tap(1, bench.by(left_eye));
        bench.tap(1, bench.by(left_eye), 0.8);
        QCOMPARE(bench.said(), QString("Zoomed to the left eye of Anna."));
        QCOMPARE(bench.view.featureCount(), 1);
    }
};

} // namespace explore_gestures_test

TP_TEST(explore_gestures_test, ExploreGesturesTest, event_loop)
#include "explore_gestures_test.moc"
