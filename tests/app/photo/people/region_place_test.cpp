// SPDX-License-Identifier: Apache-2.0
#include "app/photo/people/region_place.hpp"

#include <QTest>

#include <cmath>

using namespace tp;

namespace {

bool near(double a, double b) { return std::abs(a - b) < 1e-12; }

bool same_place(const FaceRegion& a, const FaceRegion& b) {
    return near(a.x, b.x) && near(a.y, b.y) && near(a.width, b.width) && near(a.height, b.height);
}

} // namespace

class RegionPlaceTest : public QObject {
    Q_OBJECT
private slots:
    void every_orientation_data() {
        QTest::addColumn<int>("orientation");
        QTest::addColumn<Vec2>("centre"); // in the upright picture, of the stored (0.1, 0.2)
        QTest::newRow("1") << 1 << Vec2(0.1, 0.2);
        QTest::newRow("2 mirrored") << 2 << Vec2(0.9, 0.2);
        QTest::newRow("3 half a turn") << 3 << Vec2(0.9, 0.8);
        QTest::newRow("4 upside down") << 4 << Vec2(0.1, 0.8);
        QTest::newRow("5 transposed") << 5 << Vec2(0.2, 0.1);
        QTest::newRow("6 stored on its left side") << 6 << Vec2(0.8, 0.1);
        QTest::newRow("7 transversed") << 7 << Vec2(0.8, 0.9);
        QTest::newRow("8 stored on its right side") << 8 << Vec2(0.2, 0.9);
    }
    void every_orientation() {
        QFETCH(int, orientation);
        QFETCH(Vec2, centre);
        const bool swapped = orientation >= 5;
        const Rect shown = shown_part({0.1, 0.2, 0.04, 0.1, "Anna"}, {orientation, 0});
        QVERIFY(length(shown.centre() - centre) < 1e-12);
        QVERIFY(near(shown.width(), swapped ? 0.1 : 0.04));
        QVERIFY(near(shown.height(), swapped ? 0.04 : 0.1));
    }

    void a_picture_that_was_turned_to_find_its_faces() {
        const FaceRegion corner{0.1, 0.2, 0.0, 0.0, {}};
        // Turned by 90° clockwise, the top left corner comes to the top right.
        QVERIFY(length(shown_part(corner, {1, 90}).centre() - Vec2(0.8, 0.1)) < 1e-12);
        QVERIFY(length(shown_part(corner, {1, 180}).centre() - Vec2(0.9, 0.8)) < 1e-12);
        QVERIFY(length(shown_part(corner, {1, 270}).centre() - Vec2(0.2, 0.9)) < 1e-12);
    }

    void a_place_on_the_shown_picture_goes_back_to_the_same_place_on_the_stored_one() {
        const FaceRegion region{0.3, 0.2, 0.1, 0.25, {}};
        for (int orientation = 1; orientation <= 8; ++orientation)
            for (const int turned : {0, 90, 180, 270}) {
                const PictureTurn turn{orientation, turned};
                QVERIFY2(same_place(stored_region(shown_part(region, turn), turn), region),
                         qPrintable(QString("%1 %2").arg(orientation).arg(turned)));
            }
    }

    void a_camera_on_its_side_shows_the_stored_left_upper_corner_at_the_right() {
        const FaceRegion corner{0.05, 0.1, 0.1, 0.2, {}}; // in the left upper corner as stored
        const Rect shown = shown_part(corner, {6, 0});  // to be turned clockwise by 90 degrees
        QVERIFY(near(shown.max.x, 1.0) && near(shown.min.y, 0.0));
        QVERIFY(near(shown.width(), 0.2) && near(shown.height(), 0.1));
        const Rect mirrored = shown_part(corner, {2, 0});
        QVERIFY(near(mirrored.max.x, 1.0) && near(mirrored.min.y, 0.0) && near(mirrored.width(), 0.1));
        const Rect on_its_head = shown_part(corner, {1, 180});
        QVERIFY(near(on_its_head.max.x, 1.0) && near(on_its_head.max.y, 1.0));
    }

    void what_reaches_beyond_the_picture_is_cut_off() {
        const FaceRegion region = stored_region(Rect{{-0.1, 0.5}, {0.2, 1.2}}, {});
        QVERIFY(same_place(region, {0.1, 0.75, 0.2, 0.5, {}}));
    }

    void boxes_of_one_face_are_told_from_those_of_two() {
        const Rect face{{0.4, 0.4}, {0.6, 0.6}};
        QVERIFY(same_face(face, face));
        QVERIFY(same_face(face, Rect{{0.35, 0.3}, {0.65, 0.65}}));  // with hair
        QVERIFY(!same_face(face, Rect{{0.55, 0.4}, {0.75, 0.6}}));  // the neighbour
        QVERIFY(!same_face(face, Rect{{0.0, 0.0}, {1.0, 1.0}}));  // the whole picture
        QVERIFY(!same_face(face, Rect{{0.5, 0.5}, {0.5, 0.5}}));  // nothing
    }
};

QTEST_APPLESS_MAIN(RegionPlaceTest)
#include "region_place_test.moc"
