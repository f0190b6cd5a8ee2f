// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/hand_state.hpp"
#include "test_program.hpp"

#include <QTest>

namespace hand_state_test {

using namespace tp;
using Is = HandState::Is;

namespace {

/// A hand in that state.
HandState hand(Is is) {
    HandState made;
    switch (is) {
    case Is::pointing:
        break;
    case Is::touching:
        made.one_finger();
        break;
    case Is::gesturing:
        made.several_fingers();
        break;
    case Is::lifted:
        made.one_finger();
        made.lifted();
        break;
    case Is::away:
        made.mouse_gone();
        break;
    }
    return made;
}

} // namespace

class HandStateTest : public QObject {
    Q_OBJECT
private slots:
    void the_table() {
        struct Row {
            Is is, mouse, keys, one_finger, several, lifted, mouse_gone;
        };
        const Row rows[]{
            {Is::pointing, Is::pointing, Is::pointing, Is::touching, Is::gesturing, Is::pointing, Is::away},
            {Is::touching, Is::touching, Is::pointing, Is::touching, Is::gesturing, Is::lifted, Is::touching},
            {Is::gesturing, Is::gesturing, Is::pointing, Is::touching, Is::gesturing, Is::lifted,
             Is::gesturing},
            {Is::lifted, Is::pointing, Is::pointing, Is::touching, Is::gesturing, Is::lifted, Is::away},
            {Is::away, Is::pointing, Is::pointing, Is::touching, Is::gesturing, Is::away, Is::away},
        };
        const auto after = [](Is is, void (HandState::*event)()) {
            HandState one = hand(is);
            (one.*event)();
            return one.is();
        };
        for (const Row& row : rows) {
            QVERIFY(hand(row.is).is() == row.is);
            QVERIFY(after(row.is, &HandState::mouse) == row.mouse);
            QVERIFY(after(row.is, &HandState::keys) == row.keys);
            QVERIFY(after(row.is, &HandState::one_finger) == row.one_finger);
            QVERIFY(after(row.is, &HandState::several_fingers) == row.several);
            QVERIFY(after(row.is, &HandState::lifted) == row.lifted);
            QVERIFY(after(row.is, &HandState::mouse_gone) == row.mouse_gone);
        }
    }

    void a_lifted_fingertip_is_off_the_surface_and_is_still_where_it_was() {
        QVERIFY(hand(Is::lifted).off_surface() && hand(Is::lifted).is_fingertip());
        QVERIFY(hand(Is::away).off_surface() && !hand(Is::away).is_fingertip());
        QVERIFY(!hand(Is::gesturing).off_surface() && hand(Is::gesturing).is_fingertip());
        QVERIFY(!hand(Is::pointing).off_surface() && !hand(Is::pointing).is_fingertip());
    }
};

} // namespace hand_state_test

TP_TEST(hand_state_test, HandStateTest, nothing)
#include "hand_state_test.moc"
