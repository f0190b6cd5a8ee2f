// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/scene_builder.hpp"
#include "core/geometry/flatten.hpp"
#include "test_program.hpp"

#include <QTest>

namespace scene_builder_test {

using namespace tp;

namespace {

Face face_at(double x, double y, double size) {
    Face face;
    face.contours = {
        contour_through(feature::left_eye,
                        {{x + 0.6 * size, y}, {x + 0.9 * size, y}, {x + 0.75 * size, y + 5}}, true),
        contour_through(feature::outline, {{x, y}, {x + 0.5 * size, y + size}, {x + size, y}}, false)};
    return face;
}

Extraction photo(std::vector<Face> faces) {
    Extraction extraction;
    extraction.width = 1000;
    extraction.height = 800;
    extraction.faces = std::move(faces);
    return extraction;
}

Rect bounds_of(const Scene& scene) {
    std::vector<Vec2> all;
    for (const Contour& contour : scene.contours)
        for (const Vec2 p : flatten(contour).points)
            all.push_back(p);
    return tp::bounds_of(all);
}

} // namespace

class SceneBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void fills_the_surface_inside_its_margin_and_keeps_it_upright() {
        const auto built = build_scene(photo({face_at(100, 200, 300)}), {200.0, 150.0, 8.0, {}});
        QVERIFY(built.ok());
        const Rect box = bounds_of(built->scene);
        QVERIFY(std::abs(box.height() - 134.0) < 1e-9);
        QVERIFY(length(box.centre()) < 1e-9);
        QCOMPARE(built->scene.contours[0].name, std::string("left_eye"));
        const Vec2 eye = flatten(built->scene.contours[0]).points.front();
        QVERIFY(eye.y > 60.0); // the eyes are above the chin on the surface too, where y points up
        QVERIFY(eye.x > 0.0);  // and the person's left eye stays on the right of the picture
        QVERIFY(length(built->photo_to_surface({100 + 0.6 * 300, 200}) - eye) < 1e-9);
    }

    void several_faces_share_the_surface_and_are_told_apart_by_name() {
        const Extraction two = photo({face_at(500, 100, 400), face_at(0, 300, 200)});
        const auto both = build_scene(two);
        QCOMPARE(both->scene.contours.size(), std::size_t(4));
        QCOMPARE(both->scene.contours[0].name, std::string("face 1 left_eye"));
        QCOMPARE(both->scene.contours[3].name, std::string("face 2 outline"));
        const auto second = build_scene(two, {}, 1);
        QCOMPARE(second->scene.contours.size(), std::size_t(2));
        QCOMPARE(second->scene.contours[1].name, std::string("outline"));
        QVERIFY(bounds_of(second->scene).height() > 133.0);
    }

    void shut_lips_become_one_line() {
        Face face = face_at(100, 200, 300);
        std::vector<Vec2> shut;
        for (int x = 0; x <= 100; ++x)
            shut.emplace_back(200 + x, 400.0 - 0.01 * x * (100 - x) / 25.0);
        for (int x = 99; x >= 1; --x)
            shut.emplace_back(200 + x, 400.0 + 0.01 * x * (100 - x) / 25.0);
        face.contours.push_back(contour_through(feature::inner_lip, shut, true));
        const auto built = build_scene(photo({face}));
        QVERIFY(built->scene.contours[0].closed); // an eye that is open stays
        QVERIFY(!built->scene.contours[2].closed);
        QCOMPARE(built->scene.contours[2].name, std::string("inner_lip"));
    }

    void a_part_fills_the_surface_and_is_all_that_is_felt() {
        Face face = face_at(500, 100, 400);
        face.contours.push_back(contour_through(feature::right_eye, {{540, 100}, {620, 100}, {580, 115}}, true));
        face.contours.push_back(contour_through(feature::outer_lip, {{600, 350}, {700, 350}, {650, 390}}, true));
        face.contours.push_back(contour_through(feature::inner_lip, {{620, 355}, {680, 355}, {650, 375}}, true));
        face.contours.push_back(contour_through(feature::left_iris, {{800, 98}, {810, 98}, {805, 108}}, true));
        face.contours.push_back(contour_through(feature::nose, {{640, 250}, {650, 260}, {660, 250}}, false));
        const Extraction two = photo({face, face_at(0, 300, 200)});
        const auto names = [&](const Subject& subject) {
            const auto built = build_scene(two, {}, subject);
            std::string all;
            for (std::size_t i = 0; built && i < built->scene.contours.size(); ++i) {
                all += built->scene.contours[i].name + " ";
                if (subject.face && (built->features[i].face != *subject.face ||
                                     built->features[i].name != built->scene.contours[i].name))
                    all += "(of another) ";
            }
            return all;
        };
        QCOMPARE(names({0, FacePart::eyes}), std::string("left_eye right_eye left_iris "));
        QCOMPARE(names({0, FacePart::left_eye}), std::string("left_eye left_iris "));
        QCOMPARE(names({0, FacePart::right_eye}), std::string("right_eye "));
        QCOMPARE(names({0, FacePart::mouth}), std::string("outer_lip inner_lip "));
        QCOMPARE(names({1, FacePart::eyes}), std::string("left_eye "));
        QCOMPARE(names({std::nullopt, FacePart::eyes}),
                 std::string("face 1 left_eye face 1 right_eye face 1 left_iris face 2 left_eye "));
        for (const FacePart part : {FacePart::eyes, FacePart::left_eye, FacePart::right_eye, FacePart::mouth}) {
            const Rect box = bounds_of(build_scene(two, {}, Subject{0, part})->scene);
            QVERIFY(std::abs(box.width() - 184.0) < 1e-6 || std::abs(box.height() - 134.0) < 1e-6);
            QVERIFY(box.width() < 184.1 && box.height() < 134.1);
        }
        QVERIFY(build_scene(two, {}, Subject{1, FacePart::mouth}).error().find("not found") != std::string::npos);
        const auto all = build_scene(two);
        QCOMPARE(all->features.size(), all->scene.contours.size());
        QCOMPARE(all->features.back().face, std::size_t(1));
        QCOMPARE(all->features.back().name, std::string(feature::outline));
    }

    void says_what_is_missing() {
        QVERIFY(!build_scene(photo({})).error().empty());
        Extraction told = photo({});
        told.problem = "The file is empty.";
        QCOMPARE(build_scene(told).error(), std::string("The file is empty."));
        QVERIFY(build_scene(photo({face_at(0, 0, 100)}), {}, 1).error().find("no face 2") !=
                std::string::npos);
        QVERIFY(!build_scene(photo({face_at(0, 0, 100)}), {10.0, 10.0, 8.0, {}}).error().empty());
        QVERIFY(!build_scene(photo({Face{}})).error().empty());
    }
};

} // namespace scene_builder_test

TP_TEST(scene_builder_test, SceneBuilderTest, nothing)
#include "scene_builder_test.moc"
