// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/face_square.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace face_square_test {

using namespace tp;

namespace {

constexpr double side = face_square_px;
const Vec2 right_eye(0.33 * side, 0.33 * side), left_eye(0.67 * side, 0.33 * side),
    mouth(0.5 * side, 0.74 * side);

/// Turned by `angle`, `scale` times as large, with its corner at `at`.
Vec2 placed(Vec2 p, double angle, double scale, Vec2 at) {
    return at + scale * Vec2(std::cos(angle) * p.x - std::sin(angle) * p.y,
                             std::sin(angle) * p.x + std::cos(angle) * p.y);
}

void dot(cv::Mat& picture, Vec2 p, double radius, const cv::Scalar& colour) {
    constexpr int bits = 8;
    const auto fixed = [](double v) { return static_cast<int>(std::lround(v * (1 << bits))); };
    cv::circle(picture, {fixed(p.x - 0.5), fixed(p.y - 0.5)}, fixed(radius), colour, cv::FILLED, cv::LINE_AA,
               bits);
}

/// Middle of what is bright in one channel, px.
Vec2 middle_of(const cv::Mat& picture, int channel) {
    cv::Mat plane;
    cv::extractChannel(picture, plane, channel);
    const cv::Moments moments = cv::moments(plane);
    return Vec2(moments.m10, moments.m01) / moments.m00 + 0.5;
}

Contour around(const char* name, Vec2 centre, Vec2 radii) {
    std::vector<Vec2> points;
    for (int i = 0; i < 24; ++i)
        points.push_back(centre + radii * Vec2(std::cos(i * M_PI / 12), std::sin(i * M_PI / 12)));
    return contour_through(name, points, true);
}

Face face_with(Vec2 right, Vec2 left, Vec2 lips) {
    Face face;
    face.contours = {around(feature::left_eye, left, {6, 3}), around(feature::right_eye, right, {6, 3}),
                     around(feature::outer_lip, lips, {12, 5})};
    return face;
}

} // namespace

class FaceSquareTest : public QObject {
    Q_OBJECT

private slots:
    void eyes_and_mouth_come_to_their_places_data() {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("scale");
        for (const double degrees : {0.0, 30.0, -75.0, 180.0})
            for (const double scale : {0.4, 1.0, 1.7, 6.3})
                QTest::addRow("turned by %g, %g times as large", degrees, scale) << degrees << scale;
    }
    void eyes_and_mouth_come_to_their_places() {
        QFETCH(const double, degrees);
        QFETCH(const double, scale);
        const double angle = degrees * M_PI / 180.0;
        const Vec2 middle(700.0, 650.0), at = middle - placed(Vec2(0.5 * side), angle, scale, Vec2(0.0));
        const auto there = [&](Vec2 p) { return placed(p, angle, scale, at); };
        cv::Mat picture(1300, 1400, CV_8UC3, cv::Scalar::all(0));
        dot(picture, there(right_eye), 6 * scale, {255, 0, 0});
        dot(picture, there(left_eye), 6 * scale, {0, 255, 0});
        dot(picture, there(mouth), 6 * scale, {0, 0, 255});
        const auto square = face_square(picture, {there(right_eye), there(left_eye), there(mouth)});
        QVERIFY(square);
        QCOMPARE(square->size(), cv::Size(face_square_px, face_square_px));
        QVERIFY(length(middle_of(*square, 0) - right_eye) < 0.35);
        QVERIFY(length(middle_of(*square, 1) - left_eye) < 0.35);
        QVERIFY(length(middle_of(*square, 2) - mouth) < 0.35);
    }
    /// A longer face than the net knows: the error is shared, not left to the mouth.
    void the_error_of_another_shape_is_shared() {
        const Vec2 at(300, 300), longer(0, 30);
        cv::Mat picture(800, 800, CV_8UC3, cv::Scalar::all(0));
        const FacePlaces places{at + right_eye, at + left_eye, at + mouth + longer};
        dot(picture, places.right_eye, 5, {255, 0, 0});
        dot(picture, places.left_eye, 5, {0, 255, 0});
        dot(picture, places.mouth, 5, {0, 0, 255});
        const cv::Mat square = *face_square(picture, places);
        const Vec2 right = middle_of(square, 0) - right_eye, left = middle_of(square, 1) - left_eye,
                   lips = middle_of(square, 2) - mouth;
        QVERIFY(length(right + left + lips) < 1.0); // the middles lie upon each other
        QVERIFY(right.y < -2.0 && left.y < -2.0 && lips.y > 4.0 && lips.y < 20.0);
    }
    void large_faces_are_averaged() {
        cv::Mat picture(3000, 3000, CV_8UC3);
        picture.forEach<cv::Vec3b>(
            [](cv::Vec3b& p, const int* at) { p = cv::Vec3b::all((at[0] + at[1]) % 2 ? 255 : 0); });
        const double scale = 16.3;
        const Vec2 at(200, 200);
        const cv::Mat square =
            *face_square(picture, {at + scale * right_eye, at + scale * left_eye, at + scale * mouth});
        double low = 0.0, high = 0.0;
        cv::minMaxLoc(square.reshape(1), &low, &high);
        QVERIFY(low > 115 && high < 140);
    }
    void a_face_at_the_border_repeats_it() {
        const cv::Mat picture(200, 200, CV_8UC3, cv::Scalar(10, 20, 30));
        const auto square = face_square(picture, {Vec2(2, 2), Vec2(40, 2), Vec2(20, 45)});
        QVERIFY(square && cv::norm(*square, cv::Mat(square->size(), CV_8UC3, cv::Scalar(10, 20, 30)),
                                   cv::NORM_INF) == 0);
    }
    void what_is_out_of_all_proportion_is_none() {
        const cv::Mat picture(100, 100, CV_8UC3, cv::Scalar::all(9));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!face_square(picture, {Vec2(nan, 0), Vec2(40, 2), Vec2(20, 45)}));
        QVERIFY(!face_square(picture, {Vec2(0, 0), Vec2(1e7, 0), Vec2(5e6, 1e7)}));
        QVERIFY(!face_square(picture, {Vec2(5, 5), Vec2(5, 5), Vec2(5, 5)}));
        QVERIFY(!face_square(picture, {Vec2(1e6, 0), Vec2(1e6 + 30, 0), Vec2(1e6 + 15, 35)}));
        QVERIFY(!face_square(cv::Mat(), {Vec2(0, 0), Vec2(40, 0), Vec2(20, 40)}));
    }
    void places_are_the_middles_of_the_contours() {
        const auto places = face_places(face_with({40, 50}, {80, 51}, {61, 95}));
        QVERIFY(places);
        QVERIFY(length(places->right_eye - Vec2(40, 50)) < 0.2 &&
                length(places->left_eye - Vec2(80, 51)) < 0.2 && length(places->mouth - Vec2(61, 95)) < 0.2);
    }
    void faces_without_eyes_or_mouth_have_no_places() {
        const Face whole = face_with({40, 50}, {80, 51}, {61, 95});
        for (std::size_t i = 0; i < whole.contours.size(); ++i) {
            Face face = whole;
            face.contours.erase(face.contours.begin() + static_cast<std::ptrdiff_t>(i));
            QVERIFY(!face_places(face));
            face = whole;
            face.contours[i].pieces.clear();
            QVERIFY(!face_places(face));
            face = whole;
            face.contours[i].pieces[3] = Line{Vec2(1, 2), Vec2(std::numeric_limits<double>::quiet_NaN(), 2)};
            QVERIFY(!face_places(face));
        }
        QVERIFY(!face_places(face_with({40, 50}, {40, 50}, {61, 95})));
        QVERIFY(!face_places(Face{}));
    }
};

} // namespace face_square_test

TP_TEST(face_square_test, FaceSquareTest, event_loop)
#include "face_square_test.moc"
