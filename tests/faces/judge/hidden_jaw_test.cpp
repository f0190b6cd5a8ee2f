// SPDX-License-Identifier: Apache-2.0
#include "faces/judge/hidden_jaw.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cmath>

using namespace tp;

namespace {

const cv::Scalar skin(130, 160, 210), dark(25, 30, 40);

/// A frontal face whose eyes' outer corners are 200 px apart.
Landmarks frontal_face() {
    Landmarks face;
    const auto ring = [](Vec2 centre, double width, double height, std::size_t count, double from) {
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = from + 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
            points.push_back(centre + Vec2(width * std::cos(angle), height * std::sin(angle)));
        }
        return points;
    };
    face.right_eye = ring({230.0, 200.0}, 30.0, 10.0, 16, M_PI);
    face.left_eye = ring({370.0, 200.0}, 30.0, 10.0, 16, 0.0);
    face.outer_lip = face.inner_lip = ring({300.0, 380.0}, 56.0, 18.0, 20, M_PI);
    for (int i = 0; i <= 32; ++i)
        face.outline.emplace_back(300.0 - 160.0 * std::cos(M_PI * i / 32.0),
                                  220.0 + 260.0 * std::sin(M_PI * i / 32.0));
    return face;
}

cv::Mat skin_only() { return cv::Mat(600, 600, CV_8UC3, skin); }

JawCover cover_in(const cv::Mat& picture, const Landmarks& face) {
    return jaw_cover(jaw_signs(picture, face));
}

} // namespace

class HiddenJawTest : public QObject {
    Q_OBJECT

private slots:
    void skin_up_to_the_jaw_hides_nothing() {
        QVERIFY(cover_in(skin_only(), frontal_face()) == JawCover::none);
    }
    void a_dark_chin_is_a_beard() {
        cv::Mat picture = skin_only();
        cv::ellipse(picture, {300, 400}, {170, 130}, 0, 0, 180, dark, cv::FILLED);
        QVERIFY(cover_in(picture, frontal_face()) == JawCover::beard);
    }
    void dark_sides_are_hair() {
        for (const bool both : {true, false}) {
            cv::Mat picture = skin_only();
            picture.colRange(0, 195).setTo(dark);
            if (both)
                picture.colRange(405, 600).setTo(dark);
            QVERIFY(cover_in(picture, frontal_face()) == JawCover::hair);
        }
    }
    /// The cheeks say what skin is, in whatever light.
    void dark_skin_is_no_beard() {
        for (const double light : {0.25, 0.5, 1.2}) {
            cv::Mat picture;
            skin_only().convertTo(picture, CV_8UC3, light);
            QVERIFY(cover_in(picture, frontal_face()) == JawCover::none);
        }
    }
    void signs_are_the_same_at_every_size() {
        cv::Mat picture = skin_only(), large;
        cv::ellipse(picture, {300, 400}, {170, 130}, 0, 0, 180, dark, cv::FILLED);
        cv::resize(picture, large, {}, 2.0, 2.0, cv::INTER_LINEAR);
        Landmarks face = frontal_face();
        const auto small = jaw_signs(picture, face);
        map_points(face, {glm::dmat2(2.0), Vec2(0.0)}, 2.0);
        const auto twice = jaw_signs(large, face);
        for (std::size_t i = 0; i < jaw_sign_count; ++i)
            QVERIFY(std::abs(small[i] - twice[i]) < 0.05 * std::abs(small[i]) + 0.05);
    }
    void strange_faces_are_safe() {
        Landmarks one_place = frontal_face(), no_outline = one_place, far_away = one_place;
        one_place.left_eye = one_place.right_eye;
        no_outline.outline.clear();
        map_points(far_away, {glm::dmat2(1.0), Vec2(1e7, -1e7)}, 1.0);
        for (const Landmarks& face : {one_place, no_outline, far_away})
            for (const cv::Mat& picture : {skin_only(), cv::Mat()})
                QVERIFY(cover_in(picture, face) == JawCover::none);
    }
};

QTEST_GUILESS_MAIN(HiddenJawTest)
#include "hidden_jaw_test.moc"
