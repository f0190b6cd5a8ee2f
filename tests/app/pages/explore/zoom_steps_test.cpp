// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/face_tour.hpp"
#include "app/pages/explore/zoom_steps.hpp"
#include "test_program.hpp"

#include <QTest>

namespace zoom_steps_test {

using namespace tp;

namespace {

Face face_with(std::vector<const char*> names) {
    Face face;
    for (const char* name : names)
        face.contours.push_back(contour_through(name, {{0.0, 0.0}, {1.0, 1.0}}, false));
    return face;
}

Extraction photo(std::size_t faces) {
    Extraction extraction;
    for (std::size_t i = 0; i < faces; ++i)
        extraction.faces.push_back(face_with({feature::left_eye, feature::right_eye, feature::outer_lip, feature::outline}));
    return extraction;
}

constexpr Subject everything{};
Subject of(std::size_t face, FacePart part) { return {face, part}; }

} // namespace

class ZoomStepsTest : public QObject {
    Q_OBJECT
private slots:
    void in_goes_from_all_faces_to_one_its_eyes_its_mouth_and_back() {
        const Extraction two = photo(2);
        Subject now;
        const std::vector<Subject> steps{of(1, FacePart::whole), of(1, FacePart::eyes), of(1, FacePart::mouth),
                                         everything, of(1, FacePart::whole)};
        for (const Subject& next : steps) {
            now = zoomed_in(two, now, 1);
            QVERIFY(now == next);
        }
    }
    void with_one_face_the_whole_is_the_face() {
        const Extraction one = photo(1);
        QVERIFY(zoomed_in(one, everything, 0) == of(0, FacePart::eyes));
        QVERIFY(zoomed_in(one, of(0, FacePart::mouth), 0) == everything);
        QVERIFY(zoomed_out(one, of(0, FacePart::eyes)) == everything);
        QVERIFY(!zoomed_out(one, everything));
    }
    void what_was_not_found_is_left_out() {
        Extraction mouth;
        mouth.faces = {face_with({feature::outer_lip})};
        QVERIFY(zoomed_in(mouth, everything, 0) == of(0, FacePart::mouth));
        Extraction outline;
        outline.faces = {face_with({feature::outline})};
        QVERIFY(zoomed_in(outline, everything, 0) == everything);
        QVERIFY(zoomed_in(photo(0), everything, 0) == everything);
        QVERIFY(zoomed_in(photo(2), everything, 99) == of(1, FacePart::whole));
    }
    void out_undoes_in() {
        const Extraction two = photo(2);
        QVERIFY(zoomed_out(two, of(1, FacePart::left_eye)) == of(1, FacePart::eyes));
        QVERIFY(zoomed_out(two, of(1, FacePart::eyes)) == of(1, FacePart::whole));
        QVERIFY(zoomed_out(two, of(1, FacePart::mouth)) == of(1, FacePart::whole));
        QVERIFY(zoomed_out(two, of(1, FacePart::whole)) == everything);
        QVERIFY(!zoomed_out(two, everything));
    }
    void a_place_goes_to_what_is_there() {
        const Extraction two = photo(2);
        const Extraction one = photo(1);
        QVERIFY(zoomed_to(two, everything, {1, feature::outer_lip}) == of(1, FacePart::whole));
        QVERIFY(zoomed_to(one, everything, {0, feature::outer_lip}) == of(0, FacePart::mouth));
        QVERIFY(zoomed_to(two, of(1, FacePart::whole), {1, feature::right_eye}) == of(1, FacePart::eyes));
        QVERIFY(zoomed_to(two, of(1, FacePart::eyes), {1, feature::right_eye}) == of(1, FacePart::right_eye));
        QVERIFY(!zoomed_to(two, of(1, FacePart::whole), {1, feature::outline}));
        QVERIFY(!zoomed_to(two, of(1, FacePart::mouth), {1, feature::inner_lip}));
        QVERIFY(!zoomed_to(one, everything, {0, {}}));
    }
    void a_tour_begins_with_the_outline_and_stays_with_its_face() {
        const std::vector<SceneFeature> features{{0, feature::left_eye},  {0, feature::outline},
                                                 {1, feature::outline},   {0, feature::inner_lip},
                                                 {0, feature::right_eye}, {0, feature::outer_lip}};
        QCOMPARE(tour_order(features, 0), (std::vector<int>{1, 0, 4, 5, 3}));
        QCOMPARE(tour_order(features, 1), std::vector<int>{2});
        QVERIFY(tour_order(features, 2).empty());
    }
};

} // namespace zoom_steps_test

TP_TEST(zoom_steps_test, ZoomStepsTest, event_loop)
#include "zoom_steps_test.moc"
