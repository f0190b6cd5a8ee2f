// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/passage_earcons.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace passage_earcons_test {

using namespace tp;

namespace {
/// A level line through the origin and an upright one 20 mm to the right.
const FlatScene scene{{"level", "upright"},
                      {{{{-50.0, 0.0}, {50.0, 0.0}}, false}, {{{20.0, -50.0}, {20.0, 50.0}}, false}}};
const std::vector<Rect> two_faces{{{-60.0, -30.0}, {-10.0, 30.0}}, {{10.0, -30.0}, {60.0, 30.0}}};
using Heard = std::optional<Earcon>;
} // namespace

class PassageEarconsTest : public QObject {
    Q_OBJECT
private slots:
    void a_line_that_is_crossed_is_heard_once() {
        PassageEarcons way;
        QCOMPARE(way.follow(scene, {}, {0.0, 5.0}, 0.0), Heard());
        QCOMPARE(way.follow(scene, {}, {0.0, -5.0}, 0.1), Heard(Earcon::contour_crossed));
        QCOMPARE(way.follow(scene, {}, {0.0, -6.0}, 0.2), Heard());
        QCOMPARE(way.follow(scene, {}, {0.0, 6.0}, 0.3), Heard(Earcon::contour_crossed));
    }
    void a_finger_that_trembles_on_a_line_does_not_rattle() {
        PassageEarcons way;
        way.follow(scene, {}, {0.0, 5.0}, 0.0);
        int heard = 0;
        for (int i = 0; i < 50; ++i)
            heard += way.follow(scene, {}, {0.1 * i, i % 2 ? 0.5 : -0.5}, 0.1 * (i + 1)) ? 1 : 0;
        QCOMPARE(heard, 1);
    }
    void crossings_that_come_too_fast_are_dropped() {
        PassageEarcons way;
        int heard = 0;
        for (int i = 0; i < 100; ++i)
            heard += way.follow(scene, {}, {0.0, i % 2 ? 5.0 : -5.0}, 0.01 * i) ? 1 : 0;
        QVERIFY(heard >= 10 && heard <= 17); // in one second, at most one every 60 ms
    }
    void through_a_vertex_counts_once() {
        const FlatScene bent{{"bent"}, {{{{-10.0, 0.0}, {0.0, 0.0}, {10.0, 0.0}}, false}}};
        PassageEarcons way;
        way.follow(bent, {}, {0.0, 5.0}, 0.0);
        QCOMPARE(way.follow(bent, {}, {0.0, -5.0}, 1.0), Heard(Earcon::contour_crossed));
        QCOMPARE(way.follow(bent, {}, {0.0, -6.0}, 2.0), Heard());
    }
    void past_the_end_of_a_line_is_not_across_it() {
        PassageEarcons way;
        way.follow(scene, {}, {-51.0, 5.0}, 0.0);
        QCOMPARE(way.follow(scene, {}, {-51.0, -5.0}, 1.0), Heard());
    }
    void a_finger_set_down_elsewhere_has_crossed_nothing() {
        PassageEarcons way;
        way.follow(scene, {}, {0.0, 5.0}, 0.0);
        way.lift();
        QCOMPARE(way.follow(scene, {}, {0.0, -5.0}, 1.0), Heard());
    }
    void faces_are_entered_and_left() {
        PassageEarcons way;
        QCOMPARE(way.follow({}, two_faces, {0.0, 40.0}, 0.0), Heard());
        QCOMPARE(way.follow({}, two_faces, {-20.0, 20.0}, 1.0), Heard(Earcon::face_entered));
        QCOMPARE(way.face(), 0);
        QCOMPARE(way.follow({}, two_faces, {-20.0, 31.0}, 2.0), Heard()); // within the margin
        QCOMPARE(way.follow({}, two_faces, {-20.0, 34.0}, 3.0), Heard(Earcon::face_left));
        QCOMPARE(way.follow({}, two_faces, {-20.0, 20.0}, 4.0), Heard(Earcon::face_entered));
        QCOMPARE(way.follow({}, two_faces, {20.0, 20.0}, 5.0),
                 Heard(Earcon::face_entered)); // from one to the other
        QCOMPARE(way.face(), 1);
    }
    void a_face_entered_too_soon_is_told_a_little_later() {
        PassageEarcons way;
        way.follow({}, two_faces, {0.0, 0.0}, 0.9);
        QCOMPARE(way.follow({}, two_faces, {-20.0, 0.0}, 1.0), Heard(Earcon::face_entered));
        QCOMPARE(way.follow({}, two_faces, {0.0, 0.0}, 1.1), Heard());
        QCOMPARE(way.follow({}, two_faces, {0.0, 0.0}, 1.31), Heard(Earcon::face_left));
    }
    void where_faces_overlap_the_nearer_middle_counts() {
        const std::vector<Rect> both{{{0.0, 0.0}, {40.0, 40.0}}, {{20.0, 0.0}, {60.0, 40.0}}};
        QCOMPARE(face_at(both, {22.0, 20.0}), 0);
        QCOMPARE(face_at(both, {38.0, 20.0}), 1);
        QCOMPARE(face_at(both, {38.0, 20.0}, 0), 0); // it was in that one
        QCOMPARE(face_at(both, {99.0, 20.0}), -1);
    }
    void a_place_that_is_none_is_nothing() {
        PassageEarcons way;
        QCOMPARE(way.follow(scene, two_faces, Vec2(std::nan("")), 0.0), Heard());
        way.follow(scene, {}, {0.0, 5.0}, 0.0);
        QCOMPARE(way.follow(scene, {}, Vec2(std::nan("")), 1.0), Heard());
        QCOMPARE(way.follow(scene, {}, {0.0, -5.0}, 2.0), Heard(Earcon::contour_crossed));
    }
};

} // namespace passage_earcons_test

TP_TEST(passage_earcons_test, PassageEarconsTest, event_loop)
#include "passage_earcons_test.moc"
