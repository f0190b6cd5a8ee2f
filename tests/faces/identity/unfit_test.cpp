// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/unfit.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace unfit_test {

using namespace tp;

namespace {

Contour around(const char* name, Vec2 centre, Vec2 radii) {
    std::vector<Vec2> points;
    for (int i = 0; i < 24; ++i)
        points.push_back(centre + radii * Vec2(std::cos(i * M_PI / 12), std::sin(i * M_PI / 12)));
    return contour_through(name, points, true);
}

/// A face whose eyes are `eyes` px apart, its middle at `middle`.
Face face_of(double eyes, Vec2 middle) {
    Face face;
    face.box = {middle - Vec2(1.4 * eyes), middle + Vec2(1.4 * eyes)};
    const Vec2 left = middle + eyes * Vec2(0.5, -0.4), right = middle + eyes * Vec2(-0.5, -0.4);
    face.contours = {around(feature::left_eye, left, eyes * Vec2(0.2, 0.1)),
                     around(feature::right_eye, right, eyes * Vec2(0.2, 0.1)),
                     around(feature::outer_lip, middle + eyes * Vec2(0, 0.7), eyes * Vec2(0.4, 0.2)),
                     around(feature::inner_lip, middle + eyes * Vec2(0, 0.7), eyes * Vec2(0.3, 0.1)),
                     around(feature::outline, middle, eyes * Vec2(1.1, 1.4))};
    face.quality.resize(face.contours.size());
    return face;
}

cv::Mat rough(int side) {
    cv::Mat picture(side, side, CV_8UC3);
    cv::RNG random(1);
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    return picture;
}

} // namespace

class UnfitTest : public QObject {
    Q_OBJECT

private slots:
    void a_clear_face_is_fit() {
        QCOMPARE(unfit_for_guessing(rough(400), face_of(100, {200, 200})), Unfit::no);
    }
    void a_face_without_eyes_or_mouth() {
        Face face = face_of(100, {200, 200});
        face.contours.erase(face.contours.begin());
        QCOMPARE(unfit_for_guessing(rough(400), face), Unfit::no_contours);
        QCOMPARE(unfit_for_guessing(rough(400), Face{}), Unfit::no_contours);
    }
    void a_small_face() {
        QCOMPARE(unfit_for_guessing(rough(400), face_of(11, {200, 200})), Unfit::too_small);
        QCOMPARE(unfit_for_guessing(rough(400), face_of(13, {200, 200})), Unfit::no);
    }
    void a_face_that_leaves_the_picture() {
        for (const Vec2 middle : {Vec2(80, 200), Vec2(320, 200), Vec2(200, 110), Vec2(200, 290)})
            QCOMPARE(unfit_for_guessing(rough(400), face_of(100, middle)), Unfit::cut_off);
    }
    void a_face_in_profile() {
        Face face = face_of(100, {200, 200});
        for (Contour& contour : face.contours)
            contour = mapped(contour, [](Vec2 p) { return Vec2(200 + 0.55 * (p.x - 200), p.y); });
        QCOMPARE(unfit_for_guessing(rough(400), face), Unfit::in_profile);
    }
    void an_eye_or_a_mouth_that_something_covers() {
        for (std::size_t i = 0; i < 4; ++i) {
            Face face = face_of(100, {200, 200});
            face.quality[i].reasons = {"turned to the side", "may be covered"};
            QCOMPARE(unfit_for_guessing(rough(400), face), Unfit::covered);
            face.mended = {face.contours[i].name}; // a person has placed it
            QCOMPARE(unfit_for_guessing(rough(400), face), Unfit::no);
        }
        Face jaw = face_of(100, {200, 200});
        jaw.quality[4].reasons = {"may be covered"};
        QCOMPARE(unfit_for_guessing(rough(400), jaw), Unfit::no);
        jaw.quality.clear(); // contours that somebody else has kept
        QCOMPARE(unfit_for_guessing(rough(400), jaw), Unfit::no);
    }
    void a_blurred_face() {
        cv::Mat soft;
        rough(400).convertTo(soft, CV_32F);
        cv::GaussianBlur(soft, soft, {}, 14.0);
        cv::normalize(soft, soft, 0, 255, cv::NORM_MINMAX); // as contrasty as before
        soft.convertTo(soft, CV_8U);
        QCOMPARE(unfit_for_guessing(soft, face_of(100, {200, 200})), Unfit::blurred);
        const cv::Mat grey(400, 400, CV_8UC3, cv::Scalar::all(90));
        QCOMPARE(unfit_for_guessing(grey, face_of(100, {200, 200})), Unfit::blurred);
    }
    void dim_light_does_not_blur() {
        cv::Mat soft, dim;
        cv::GaussianBlur(rough(150), soft, {}, 1.0);
        soft.convertTo(dim, -1, 0.5, 20);
        QVERIFY(std::abs(sharpness(soft) - sharpness(dim)) < 0.03);
        QVERIFY(sharpness(rough(150)) > sharpness(soft));
    }
};

} // namespace unfit_test

TP_TEST(unfit_test, UnfitTest, event_loop)
#include "unfit_test.moc"
