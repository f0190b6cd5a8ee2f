// SPDX-License-Identifier: Apache-2.0
#include "app/photo/people/face_names.hpp"

#include <QTest>

#include <string>
#include <utility>
#include <vector>

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

using Names = std::vector<std::string>;

} // namespace

class FaceNamesTest : public QObject {
    Q_OBJECT
private slots:
    void each_face_gets_the_name_of_the_region_on_it() {
        const Extraction two = picture(400, 200, {{{20, 50}, {120, 150}}, {{260, 50}, {340, 130}}});
        QCOMPARE(names_of_faces(two, marked({{0.75, 0.45, 0.25, 0.5, "Tom"}, {0.175, 0.5, 0.3, 0.6, "Anna"}})),
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
    void a_stored_picture_that_lies_on_its_side_is_set_upright_first() {
        const Extraction two = picture(1000, 500, {{{100, 100}, {300, 400}}, {{600, 100}, {800, 400}}});
        QCOMPARE(names_of_faces(two, marked({{0.5, 0.8, 0.6, 0.2, "Anna"}, {0.5, 0.3, 0.6, 0.2, "Ben"}}, 6)),
                 (Names{"Anna", "Ben"}));
    }
    void a_picture_that_was_turned_to_find_its_faces_is_turned_for_the_names_too() {
        const Extraction turned = picture(300, 400, {{{200, 20}, {280, 100}}}, 90);
        QCOMPARE(names_of_faces(turned, marked({{0.15, 0.2, 0.2, 0.25, "Anna"}})), Names{"Anna"});
        QCOMPARE(names_of_faces(turned, marked({{0.8, 0.15, 0.2, 0.25, "Anna"}})), Names{""});
    }
};

QTEST_APPLESS_MAIN(FaceNamesTest)
#include "face_names_test.moc"
