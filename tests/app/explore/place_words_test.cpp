// SPDX-License-Identifier: Apache-2.0
#include "app/explore/place_words.hpp"

#include <QTest>

using namespace tp;

namespace {
const FlatScene scene{{"left_eye", "face 2 outer_lip"},
                      {{{{20.0, 0.0}, {20.0, 10.0}}, false}, {{{-90.0, -90.0}, {-80.0, -90.0}}, false}}};
}

class PlaceWordsTest : public QObject {
    Q_OBJECT
private slots:
    void the_clock() {
        QCOMPARE(clock_direction({0.0, 1.0}), 12);
        QCOMPARE(clock_direction({1.0, 0.0}), 3);
        QCOMPARE(clock_direction({0.0, -1.0}), 6);
        QCOMPARE(clock_direction({-1.0, 0.0}), 9);
        QCOMPARE(clock_direction({1.0, std::sqrt(3.0)}), 1);
        QCOMPARE(clock_direction({-1.0, std::sqrt(3.0)}), 11);
        QCOMPARE(clock_direction({-0.01, 1.0}), 12);
        QCOMPARE(clock_direction({0.0, 0.0}), 12);
    }
    void beside_a_line() {
        QCOMPARE(where_am_i(scene, {5.0, 5.0}, -1),
                 QString("The nearest line is the left eye, at 3 o'clock, 15 millimetres away."));
        QCOMPARE(where_am_i(scene, {-85.0, -60.0}, -1),
                 QString("The nearest line is the lips of face 2, at 6 o'clock, 30 millimetres away."));
    }
    void on_a_feature() { QCOMPARE(where_am_i(scene, {19.0, 5.0}, 0), QString("On the left eye.")); }
    void nothing_there() {
        QCOMPARE(where_am_i({}, {0.0, 0.0}, -1), QString("There is nothing to feel here."));
    }
    void the_finger_lands_on_the_line() {
        const Polyline open{{{0.0, 0.0}, {10.0, 0.0}}, false};
        QCOMPARE(landing_place(open).x, 5.0);
        const Polyline closed{{{1.0, 2.0}, {10.0, 0.0}, {4.0, 4.0}}, true};
        QCOMPARE(landing_place(closed).y, 2.0);
    }
};

QTEST_GUILESS_MAIN(PlaceWordsTest)
#include "place_words_test.moc"
