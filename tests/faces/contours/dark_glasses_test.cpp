// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"
#include "effort.hpp"
#include "faces/contours/dark_glasses.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

namespace dark_glasses_test {

using namespace tp;

namespace {

/// The eyes alone, each as its outer corner.
Landmarks eyes_of(const std::vector<Contour>& truth) {
    Landmarks face;
    const auto x_less = [](Vec2 a, Vec2 b) { return a.x < b.x; };
    for (const Contour& contour : truth) {
        const std::vector<Vec2> points = flatten(contour).points;
        if (contour.name == feature::right_eye)
            face.right_eye = {*std::ranges::min_element(points, x_less)};
        else if (contour.name == feature::left_eye)
            face.left_eye = {*std::ranges::max_element(points, x_less)};
    }
    return face;
}

/// Before each eye, or the right one alone, a lens that lets `let_through` of the pixels' values through, in a
/// black frame.
cv::Mat with_lenses(const cv::Mat& picture, const Landmarks& face, double let_through,
                    std::initializer_list<double> eyes = {0.18, 0.82}) {
    cv::Mat worn = picture.clone(), dark;
    picture.convertTo(dark, -1, let_through, 8.0);
    const Vec2 right = face.right_eye[0], left = face.left_eye[0];
    const double unit = length(left - right);
    cv::Mat mask(picture.size(), CV_8UC1, cv::Scalar(0));
    const cv::Size axes(static_cast<int>(0.27 * unit), static_cast<int>(0.21 * unit));
    for (const double along : eyes) {
        const Vec2 at = right + along * (left - right);
        const cv::Point middle(static_cast<int>(at.x), static_cast<int>(at.y + 0.04 * unit));
        cv::ellipse(mask, middle, axes, 0.0, 0.0, 360.0, cv::Scalar(255), cv::FILLED);
        dark.copyTo(worn, mask);
        cv::ellipse(worn, middle, axes, 0.0, 0.0, 360.0, cv::Scalar(20, 20, 20),
                    std::max(1, static_cast<int>(0.02 * unit)), cv::LINE_AA);
    }
    return worn;
}

} // namespace

/// People whom no training saw, with glasses drawn otherwise than in training.
class DarkGlassesTest : public QObject {
    Q_OBJECT

private slots:
    void dark_lenses_are_told_and_clear_ones_are_not() {
        NEEDS_PORTRAITS();
        DarkGlasses glasses;
        int people = 0, dark = 0, plain = 0, clear = 0, shut = 0, one = 0;
        std::vector<portraits::Portrait> held_out = portraits::held_out();
        QCOMPARE(held_out.size(), std::size_t{34});
        held_out.resize(tp::test::tried_of(held_out.size()));
        for (const portraits::Portrait& person : held_out) {
            const cv::Mat picture = *read_picture(person.photo);
            const Landmarks eyes = eyes_of(person.truth);
            ++people;
            dark += glasses.evidence(with_lenses(picture, eyes, 0.25), eyes) > 0.0;
            plain += glasses.evidence(picture, eyes) > 0.0;
            clear += glasses.evidence(with_lenses(picture, eyes, 0.9), eyes) > 0.0;
            one += glasses.evidence(with_lenses(picture, eyes, 0.1, {0.18}), eyes) > 0.0;
            shut += glasses.evidence(
                        with_closed_eyes(picture, person.truth, 1.0, static_cast<unsigned>(people)).picture,
                        eyes) > 0.0;
        }
        qInfo(
            "told of %d people: %d with dark lenses, %d as they are, %d with clear ones, %d with shut eyes, "
            "%d with one dark lens",
            people, dark, plain, clear, shut, one);
        QVERIFY(dark >= people - 2);
        QVERIFY(plain + clear + shut + one <= 2);
    }
    void a_mirror_changes_nothing() {
        NEEDS_PORTRAITS();
        const portraits::Portrait person = portraits::held_out().front();
        const cv::Mat worn = with_lenses(*read_picture(person.photo), eyes_of(person.truth), 0.25);
        const Landmarks eyes = eyes_of(person.truth);
        cv::Mat mirrored;
        cv::flip(worn, mirrored, 1);
        Landmarks there = eyes;
        there.right_eye[0] = {worn.cols - eyes.left_eye[0].x, eyes.left_eye[0].y};
        there.left_eye[0] = {worn.cols - eyes.right_eye[0].x, eyes.right_eye[0].y};
        DarkGlasses glasses;
        QVERIFY(std::abs(glasses.evidence(worn, eyes) - glasses.evidence(mirrored, there)) < 0.3);
    }
    void eyes_that_are_small_or_nowhere_wear_none() {
        const cv::Mat grey(60, 60, CV_8UC3, cv::Scalar(90, 90, 90));
        DarkGlasses glasses;
        Landmarks face;
        face.right_eye = face.left_eye = {{30.0, 30.0}};
        QCOMPARE(glasses.evidence(grey, face), -std::numeric_limits<double>::infinity());
        face.left_eye = {{std::numeric_limits<double>::quiet_NaN(), 30.0}};
        QCOMPARE(glasses.evidence(grey, face), -std::numeric_limits<double>::infinity());
        face.left_eye = {{1e12, 30.0}};
        QCOMPARE(glasses.evidence(grey, face), -std::numeric_limits<double>::infinity());
        face.left_eye = {{59.0, 30.0}};
        QCOMPARE(glasses.evidence(grey, face), -std::numeric_limits<double>::infinity());
        face.left_eye = {{61.0, 30.0}};
        QVERIFY(std::isfinite(glasses.evidence(grey, face)));
        glasses.rest();
        QVERIFY(std::isfinite(glasses.evidence(grey, face)));
    }
};

} // namespace dark_glasses_test

TP_TEST(dark_glasses_test, DarkGlassesTest, event_loop)
#include "dark_glasses_test.moc"
