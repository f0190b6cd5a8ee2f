// SPDX-License-Identifier: Apache-2.0
#include "app/explore/face_names.hpp"

#include <QTest>

#include <algorithm>
#include <array>

using namespace tp;

namespace {

Extraction picture(int width, int height, std::vector<Rect> boxes, int turned = 0) {
    Extraction extraction;
    extraction.width = width;
    extraction.height = height;
    extraction.turned_degrees = turned;
    for (const Rect& box : boxes) {
        Face face;
        face.box = box;
        extraction.faces.push_back(face);
    }
    return extraction;
}

PhotoRecord marked(std::vector<FaceRegion> regions, int orientation = 1) {
    PhotoRecord record;
    record.faces = std::move(regions);
    record.orientation = orientation;
    return record;
}

using Names = std::vector<QString>;

} // namespace

class FaceNamesTest : public QObject {
    Q_OBJECT
private slots:
    void each_face_gets_the_name_of_the_region_on_it() {
        const Extraction two = picture(400, 200, {{{20, 50}, {120, 150}}, {{260, 50}, {340, 130}}});
        QCOMPARE(names_of_faces(two, marked({{0.75, 0.45, 0.25, 0.5, "Tom"}, {0.175, 0.5, 0.3, 0.6, " Anna \n"}})),
                 (Names{"Anna", "Tom"}));
        QCOMPARE(names_of_faces(two, marked({})), (Names{"", ""}));
        QCOMPARE(names_of_faces(picture(400, 200, {}), marked({{0.5, 0.5, 0.2, 0.2, "Anna"}})), Names{});
    }
    void a_region_beside_every_face_is_nobodys() {
        const Extraction one = picture(400, 200, {{{20, 50}, {120, 150}}});
        QCOMPARE(names_of_faces(one, marked({{0.75, 0.45, 0.25, 0.5, "Tom"}})), Names{""});
        QCOMPARE(names_of_faces(one, marked({{0.35, 0.5, 0.2, 0.5, "Tom"}})), Names{""}); // touches it only
    }
    void a_point_is_enough_where_it_lies_in_the_face() {
        const Extraction one = picture(400, 200, {{{20, 50}, {120, 150}}});
        QCOMPARE(names_of_faces(one, marked({{0.2, 0.5, 0.0, 0.0, "Anna"}})), Names{"Anna"});
        QCOMPARE(names_of_faces(one, marked({{0.5, 0.5, 0.0, 0.0, "Anna"}})), Names{""});
    }
    void each_region_names_one_face() {
        // A large region over both faces, and one that is the second one's.
        const Extraction two = picture(400, 200, {{{20, 50}, {120, 150}}, {{260, 50}, {340, 130}}});
        QCOMPARE(names_of_faces(two, marked({{0.5, 0.5, 1.0, 1.0, "Anna"}, {0.75, 0.45, 0.2, 0.4, "Tom"}})),
                 (Names{"Anna", "Tom"}));
    }
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
        const Extraction upright = picture(swapped ? 300 : 400, swapped ? 400 : 300, {});
        const Rect found = region_in_picture({0.1, 0.2, 0.04, 0.1, "Anna"}, orientation, upright);
        const Vec2 size(upright.width, upright.height);
        QVERIFY(length(found.centre() - centre * size) < 1e-9);
        QVERIFY(std::abs(found.width() - (swapped ? 0.1 * 300 : 0.04 * 400)) < 1e-9);
        QVERIFY(std::abs(found.height() - (swapped ? 0.04 * 400 : 0.1 * 300)) < 1e-9);
    }
    void a_picture_that_was_turned_to_find_its_faces() {
        // Turned by 90° clockwise, the top left corner comes to the top right.
        const Rect quarter = region_in_picture({0.1, 0.2, 0.0, 0.0, ""}, 1, picture(300, 400, {}, 90));
        QVERIFY(length(quarter.centre() - Vec2(0.8 * 300, 0.1 * 400)) < 1e-9);
        const Rect half = region_in_picture({0.1, 0.2, 0.0, 0.0, ""}, 1, picture(400, 300, {}, 180));
        QVERIFY(length(half.centre() - Vec2(0.9 * 400, 0.8 * 300)) < 1e-9);
        const Rect back = region_in_picture({0.1, 0.2, 0.0, 0.0, ""}, 1, picture(300, 400, {}, 270));
        QVERIFY(length(back.centre() - Vec2(0.2 * 300, 0.9 * 400)) < 1e-9);
    }
};

QTEST_GUILESS_MAIN(FaceNamesTest)
#include "face_names_test.moc"
