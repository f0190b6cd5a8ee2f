// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/place_words.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace place_words_test {

using namespace tp;

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
    void near_a_line() {
        QCOMPARE(where_am_i({"Anna", false, "left eye", false, 2, 6}),
                 QString("Anna. Left eye at 2 o'clock, 6 millimetre(s)."));
        QCOMPARE(where_am_i({"the face", false, "lips", false, 6, 1}),
                 QString("The face. Lips at 6 o'clock, 1 millimetre(s)."));
    }
    void on_a_line_its_place_on_the_feature_is_told() {
        QCOMPARE(where_am_i({"Anna", false, "left eye", true, 2, 11}),
                 QString("Anna. On the left eye, at its 2 o'clock, 11 millimetre(s) from its middle."));
    }
    void beside_the_face() {
        QCOMPARE(where_am_i({"face 2", true, "face outline", false, 9, 20}),
                 QString("Beside face 2. Face outline at 9 o'clock, 20 millimetre(s)."));
    }
    void the_finger_lands_on_the_line() {
        const Polyline open{{{0.0, 0.0}, {10.0, 0.0}}, false};
        QCOMPARE(landing_place(open).x, 5.0);
        const Polyline closed{{{1.0, 2.0}, {10.0, 0.0}, {4.0, 4.0}}, true};
        QCOMPARE(landing_place(closed).y, 2.0);
    }
};

} // namespace place_words_test

TP_TEST(place_words_test, PlaceWordsTest, event_loop)
#include "place_words_test.moc"
