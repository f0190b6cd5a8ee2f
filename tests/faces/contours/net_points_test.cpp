// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/net_points.hpp"
#include "test_program.hpp"

#include <QTest>

#include <set>

namespace net_points_test {

using namespace tp;
using namespace tp::net_points;

class NetPointsTest : public QObject {
    Q_OBJECT
private slots:
    void features_follow_each_other_without_a_gap() {
        std::size_t end = 0;
        for (const PointRange range : {right_eye, left_eye, outer_lip, inner_lip, outline, irises, rims,
                                       right_brow, left_brow, nose}) {
            QCOMPARE(range.begin, end);
            end = range.end;
        }
        QCOMPARE(end, all.size());
    }

    void a_mirror_of_a_mirror_is_the_face_itself() {
        std::set<std::size_t> seen;
        for (std::size_t i = 0; i < all.size(); ++i) {
            QCOMPARE(in_mirror(in_mirror(i)), i);
            seen.insert(in_mirror(i));
        }
        QCOMPARE(seen.size(), all.size());
    }

    void sides_change_and_the_middle_stays() {
        QCOMPARE(in_mirror(right_eye.begin), left_eye.begin);            // outer corner
        QCOMPARE(in_mirror(outer_lip.begin), outer_lip.begin + 10);      // corners of the mouth
        QCOMPARE(in_mirror(outer_lip.begin + 5), outer_lip.begin + 5);   // middle of the lower lip
        QCOMPARE(in_mirror(outer_lip.begin + 15), outer_lip.begin + 15); // and of the upper one
        QCOMPARE(in_mirror(inner_lip.begin + 1), inner_lip.begin + 9);   // both below the opening
        QCOMPARE(in_mirror(outline.begin), outline.end - 1);             // ears
        QCOMPARE(in_mirror(outline.begin + 16), outline.begin + 16);     // chin
        QCOMPARE(in_mirror(irises.begin), irises.begin + 1);
        QCOMPARE(in_mirror(rims.begin), rims.begin + 1);
        QCOMPARE(in_mirror(right_brow.begin + 3), left_brow.begin + 3);
        QCOMPARE(in_mirror(nose.begin + 5), nose.begin + 5); // below the nose's middle
    }
};

} // namespace net_points_test

TP_TEST(net_points_test, NetPointsTest, nothing)
#include "net_points_test.moc"
