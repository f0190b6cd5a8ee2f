// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/stroke_gestures.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <random>

namespace stroke_gestures_test {

using namespace tp;

namespace {

using Places = std::vector<QPointF>;

/// Fingers on glass, with a clock of their own.
struct Hand {
    StrokeGestures gestures;
    std::int64_t now_ms = 1000;

    std::optional<Gesture> put(const Places& places) { return gestures.fingers(places, now_ms += 8); }
    std::optional<Gesture> lift() { return put({}); }
    std::optional<Gesture> tap(const Places& places) {
        put(places);
        return lift();
    }
    /// One or more fingers along the same way, in small steps.
    std::optional<Gesture> draw(const std::vector<QPointF>& corners, int fingers = 1) {
        for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg)
            for (int i = 0; i <= 20; ++i) {
                const QPointF at = corners[leg] + (corners[leg + 1] - corners[leg]) * (i / 20.0);
                Places places;
                for (int finger = 0; finger < fingers; ++finger)
                    places.push_back(at + QPointF(0.0, 90.0 * finger));
                if (put(places))
                    qFatal("a gesture before the fingers were lifted");
            }
        return lift();
    }
};

} // namespace

class TouchGesturesTest : public QObject {
    Q_OBJECT
private slots:
    void strokes_go_the_way_they_are_drawn() {
        Hand hand;
        QCOMPARE(hand.draw({{300, 300}, {400, 310}}), Gesture::swipe_right);
        QCOMPARE(hand.draw({{300, 300}, {200, 280}}), Gesture::swipe_left);
        QCOMPARE(hand.draw({{300, 300}, {310, 200}}), Gesture::swipe_up);
        QCOMPARE(hand.draw({{300, 300}, {290, 400}}), Gesture::swipe_down);
    }

    void how_slowly_does_not_matter() {
        Hand hand;
        hand.put({{300, 300}});
        hand.now_ms += 60'000;
        hand.put({{350, 300}});
        hand.now_ms += 60'000;
        hand.put({{420, 300}});
        QCOMPARE(hand.lift(), Gesture::swipe_right);
    }

    void a_short_or_slanting_stroke_is_nothing() {
        Hand hand;
        QCOMPARE(hand.draw({{300, 300}, {350, 300}}), std::nullopt);
        QCOMPARE(hand.draw({{300, 300}, {380, 375}}), std::nullopt);
        QCOMPARE(hand.draw({{300, 300}, {420, 300}, {300, 300}}), std::nullopt); // and back again
    }

    void two_taps_are_a_double_tap_and_three_are_not_two() {
        Hand hand;
        QCOMPARE(hand.tap({{300, 300}}), Gesture::tap);
        QCOMPARE(hand.tap({{310, 305}}), Gesture::double_tap);
        QCOMPARE(hand.tap({{310, 305}}), Gesture::tap);
    }

    void taps_far_apart_in_place_or_time_are_single() {
        Hand hand;
        QCOMPARE(hand.tap({{300, 300}}), Gesture::tap);
        QCOMPARE(hand.tap({{500, 300}}), Gesture::tap);
        hand.now_ms += 5000;
        QCOMPARE(hand.tap({{500, 300}}), Gesture::tap);
    }

    void a_long_press_that_trembles_is_a_tap() {
        Hand hand;
        hand.put({{300, 300}});
        hand.now_ms += 4000;
        hand.put({{310, 295}});
        QCOMPARE(hand.lift(), Gesture::tap);
    }

    void two_fingers_need_not_come_and_go_together() {
        Hand hand;
        hand.put({{300, 300}});
        hand.put({{300, 300}, {400, 300}});
        hand.put({{400, 300}}); // the first one is lifted first
        QCOMPARE(hand.lift(), Gesture::two_finger_tap);
        hand.put({{300, 300}, {400, 300}});
        hand.put({{300, 300}});
        QCOMPARE(hand.lift(), Gesture::two_finger_double_tap);
        QCOMPARE(hand.tap({{300, 300}}), Gesture::tap);
        QCOMPARE(hand.tap({{300, 300}, {400, 300}}), Gesture::two_finger_tap); // no second of the same kind
    }

    void a_z_of_two_fingers() {
        Hand hand;
        QCOMPARE(hand.draw({{200, 300}, {320, 300}, {200, 360}, {320, 360}}, 2), Gesture::two_finger_z);
        QCOMPARE(hand.draw({{200, 300}, {320, 300}, {200, 360}}, 2), std::nullopt);
        QCOMPARE(hand.draw({{200, 300}, {320, 300}}, 2), std::nullopt);
        QCOMPARE(hand.draw({{200, 300}, {320, 300}, {200, 360}, {320, 360}}, 1),
                 Gesture::swipe_right); // one finger's way
    }

    void three_fingers() {
        Hand hand;
        QCOMPARE(hand.tap({{300, 300}, {400, 300}, {500, 300}}), Gesture::three_finger_tap);
        QCOMPARE(hand.tap({{300, 300}, {350, 300}, {400, 300}, {500, 300}}), std::nullopt);
    }

    void what_the_system_took_away_was_nothing() {
        Hand hand;
        hand.put({{300, 300}});
        hand.gestures.cancel();
        QCOMPARE(hand.lift(), std::nullopt);
        QCOMPARE(hand.tap({{300, 300}}), Gesture::tap);
    }

    /// Whatever fingers do: no gesture while any is down, at most one for each touch.
    void random_hands() {
        std::mt19937 random(7);
        const auto place = [&] {
            return QPointF(static_cast<int>(random() % 1000), static_cast<int>(random() % 1000));
        };
        Hand hand;
        for (int touch = 0; touch < 3000; ++touch) {
            for (auto events = 1 + random() % 30; events > 0; --events) {
                Places places;
                for (auto fingers = 1 + random() % 5; fingers > 0; --fingers)
                    places.push_back(place());
                QVERIFY(!hand.put(places));
            }
            hand.lift();
            QVERIFY(!hand.lift());
        }
    }
};

} // namespace stroke_gestures_test

TP_TEST(stroke_gestures_test, TouchGesturesTest, event_loop)
#include "stroke_gestures_test.moc"
