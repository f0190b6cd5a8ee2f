// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/touch_gestures.hpp"
#include "test_program.hpp"

#include <QTest>

namespace touch_gestures_test {

using namespace tp;
using enum TouchGestures::Gesture;

namespace {

/// Fingers set down together at `at` seconds and lifted `after` seconds later; what that meant.
TouchGestures::Gesture tap(TouchGestures& touch, int fingers, double at, double after = 0.1, Vec2 place = {0, 0},
                           Vec2 dragged = {0, 0}) {
    for (int i = 0; i < fingers; ++i)
        touch.press(i, place + Vec2(20.0 * i, 0.0), at);
    touch.move(0, place + dragged);
    auto last = none;
    for (int i = 0; i < fingers; ++i)
        last = touch.release(i, at + after);
    return last;
}

/// Two fingers set down beside each other and lifted, each after its own way.
TouchGestures::Gesture drag(TouchGestures& touch, Vec2 one, Vec2 other, double at = 0.0, double after = 0.3) {
    touch.press(0, {0, 0}, at);
    touch.press(1, {20, 0}, at);
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        touch.move(0, share * one);
        touch.move(1, Vec2(20, 0) + share * other);
    }
    touch.release(1, at + after);
    return touch.release(0, at + after);
}

} // namespace

class TouchGesturesTest : public QObject {
    Q_OBJECT
private slots:
    void one_finger_explores_from_its_first_moment_until_another_comes() {
        TouchGestures touch;
        QVERIFY(!touch.explores());
        touch.press(7, {0, 0}, 0.0);
        QVERIFY(touch.explores());
        touch.press(9, {20, 0}, 0.1);
        QVERIFY(!touch.explores());
        touch.release(9, 0.2);
        QVERIFY(!touch.explores()); // the one that is left belongs to the gesture
        touch.release(7, 0.3);
        touch.press(7, {0, 0}, 5.0);
        QVERIFY(touch.explores());
    }
    void taps_are_told_when_the_last_finger_is_lifted() {
        TouchGestures touch;
        touch.press(0, {0, 0}, 0.0);
        touch.press(1, {20, 0}, 0.0);
        QCOMPARE(touch.release(0, 0.1), none);
        QCOMPARE(touch.release(1, 0.2), two_finger_tap);
        QCOMPARE(tap(touch, 3, 5.0), three_finger_tap);
        QCOMPARE(tap(touch, 4, 9.0), three_finger_tap);
        QCOMPARE(tap(touch, 1, 12.0), none);
    }
    void two_taps_with_two_fingers() {
        TouchGestures touch;
        QCOMPARE(tap(touch, 2, 0.0), two_finger_tap);
        QCOMPARE(tap(touch, 2, 0.5), two_finger_double_tap);
        QCOMPARE(tap(touch, 2, 0.9), two_finger_tap); // the third begins anew
        QCOMPARE(tap(touch, 2, 3.0), two_finger_tap); // too late
    }
    void two_taps_with_one_finger_and_the_second_held() {
        TouchGestures touch;
        QCOMPARE(tap(touch, 1, 0.0), none);
        QCOMPARE(tap(touch, 1, 0.4), double_tap);
        QCOMPARE(tap(touch, 1, 0.8), none);
        QCOMPARE(tap(touch, 1, 2.0), none);
        QCOMPARE(tap(touch, 1, 2.4, 0.8), double_tap_and_hold);
        QCOMPARE(tap(touch, 1, 5.0), none);
        QCOMPARE(tap(touch, 1, 5.4, 0.1, {30, 0}), none); // elsewhere
    }
    void how_long_several_fingers_rest_does_not_matter() {
        TouchGestures touch;
        QCOMPARE(tap(touch, 2, 0.0, 20.0), two_finger_tap);
        QCOMPARE(tap(touch, 3, 30.0, 20.0), three_finger_tap);
    }
    void a_finger_that_is_dragged_away_meant_nothing() {
        TouchGestures touch;
        QCOMPARE(tap(touch, 2, 0.0, 0.1, {0, 0}, {11, 0}), none);
        QCOMPARE(tap(touch, 3, 1.0, 0.1, {0, 0}, {0, -11}), none);
        QCOMPARE(tap(touch, 1, 2.0), none);
        QCOMPARE(tap(touch, 1, 2.3, 0.9, {0, 0}, {11, 0}), none);
    }
    void two_fingers_that_go_across_together_swipe() {
        TouchGestures touch;
        QCOMPARE(drag(touch, {25, 3}, {30, -4}), two_finger_swipe_right);
        QCOMPARE(drag(touch, {-25, 10}, {-22, 10}), two_finger_swipe_left);
        QCOMPARE(drag(touch, {40, 0}, {40, 0}, 10.0, 20.0), two_finger_swipe_right); // as slowly as one likes
    }
    void two_fingers_that_do_not_go_across_together_meant_nothing() {
        TouchGestures touch;
        QCOMPARE(drag(touch, {18, 0}, {30, 0}), none);
        QCOMPARE(drag(touch, {0, 0}, {30, 0}), none);
        QCOMPARE(drag(touch, {-30, 0}, {30, 0}), none);
        QCOMPARE(drag(touch, {0, 40}, {0, 40}), none);
        QCOMPARE(drag(touch, {25, 25}, {25, 25}), none);
    }
    void three_fingers_that_go_across_meant_nothing() {
        TouchGestures touch;
        for (int i = 0; i < 3; ++i)
            touch.press(i, {20.0 * i, 0}, 0.0);
        for (int i = 0; i < 3; ++i)
            touch.move(i, {20.0 * i + 40.0, 0});
        for (int i = 0; i < 2; ++i)
            QCOMPARE(touch.release(i, 0.3), none);
        QCOMPARE(touch.release(2, 0.3), none);
    }
    void what_one_finger_explored_before_the_second_came_is_no_part_of_a_swipe() {
        TouchGestures touch;
        touch.press(0, {0, 0}, 0.0);
        touch.move(0, {60, 0});
        touch.press(1, {80, 0}, 2.0);
        touch.move(1, {110, 0});
        touch.release(0, 2.3);
        QCOMPARE(touch.release(1, 2.3), none);
    }
    void a_swipe_is_neither_of_two_taps() {
        TouchGestures touch;
        QCOMPARE(tap(touch, 2, 0.0), two_finger_tap);
        QCOMPARE(drag(touch, {30, 0}, {30, 0}, 0.3), two_finger_swipe_right);
        QCOMPARE(tap(touch, 2, 0.8), two_finger_tap);
        QCOMPARE(drag(touch, {-30, 0}, {-30, 0}, 5.0), two_finger_swipe_left);
    }
    void a_hand_that_trembles_still_taps() {
        TouchGestures touch;
        QCOMPARE(tap(touch, 2, 0.0, 0.3, {0, 0}, {6, 6}), two_finger_tap);
        QCOMPARE(tap(touch, 1, 2.0, 0.3, {0, 0}, {6, 6}), none);
        QCOMPARE(tap(touch, 1, 2.6, 0.3, {5, 5}, {6, 6}), double_tap);
    }
    void exploring_is_not_the_first_of_two_taps() {
        TouchGestures touch;
        QCOMPARE(tap(touch, 1, 0.0, 3.0), none);
        QCOMPARE(tap(touch, 1, 3.2), none);
        QCOMPARE(tap(touch, 1, 6.0, 0.1, {0, 0}, {40, 0}), none);
        QCOMPARE(tap(touch, 1, 6.3), none);
    }
    void what_the_system_takes_away_meant_nothing() {
        TouchGestures touch;
        touch.press(0, {0, 0}, 0.0);
        touch.press(1, {20, 0}, 0.0);
        touch.cancel();
        QVERIFY(!touch.explores());
        QCOMPARE(touch.release(0, 0.1), none);
        QCOMPARE(touch.release(1, 0.1), none);
    }
};

} // namespace touch_gestures_test

TP_TEST(touch_gestures_test, TouchGesturesTest, event_loop)
#include "touch_gestures_test.moc"
