// SPDX-License-Identifier: Apache-2.0
#include "faces/judge/outline_step.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace outline_step_test {

using namespace tp;

namespace {

constexpr double unit_px = 120.0;
constexpr Vec2 centre(200.0, 190.0);

/// The lower half of a circle, as an outline runs.
std::vector<Vec2> arc(double radius, Vec2 middle = centre, std::size_t count = 33) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle =
            std::numbers::pi * (1.0 - static_cast<double>(i) / static_cast<double>(count - 1));
        points.push_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// A disc of skin before a wall.
cv::Mat disc(double radius) {
    cv::Mat picture(400, 400, CV_8UC3, cv::Scalar(200, 190, 180));
    cv::circle(picture, {static_cast<int>(centre.x), static_cast<int>(centre.y)}, static_cast<int>(radius),
               cv::Scalar(120, 140, 190), cv::FILLED, cv::LINE_AA);
    return picture;
}

} // namespace

class OutlineStepTest : public QObject {
    Q_OBJECT
private slots:
    void a_line_on_the_step_is_off_by_next_to_nothing() {
        QVERIFY(outline_off_step(disc(130), arc(130), unit_px) < 0.02); // over which colours are compared
    }
    void a_line_beside_the_step_is_off_by_its_distance() {
        for (const double away : {-10.0, -5.0, 5.0, 10.0}) {
            const double off = outline_off_step(disc(130), arc(130 + away), unit_px);
            QVERIFY2(std::abs(off - std::abs(away) / unit_px) < 0.01, qPrintable(QString::number(off)));
        }
    }
    void a_beard_is_a_stronger_step_than_the_jaw() {
        cv::Mat bearded = disc(130);
        cv::ellipse(bearded, {200, 190}, {123, 123}, 0.0, 0.0, 180.0, cv::Scalar(30, 30, 40), 14);
        QVERIFY(outline_off_step(bearded, arc(130), unit_px) < 0.05); // its own edge is near
        cv::Mat shaded = disc(130);
        cv::circle(shaded, {200, 190}, 116, cv::Scalar(20, 20, 30), cv::FILLED);
        QVERIFY(outline_off_step(shaded, arc(130), unit_px) > 0.05);
    }
    void it_scales_with_the_picture() {
        cv::Mat large;
        cv::resize(disc(130), large, {}, 3.0, 3.0, cv::INTER_LINEAR);
        const double small_off = outline_off_step(disc(130), arc(138), unit_px);
        const double large_off = outline_off_step(large, arc(3 * 138, 3.0 * centre), 3 * unit_px);
        QVERIFY(std::abs(small_off - large_off) < 0.01);
    }
    void a_mirror_changes_nothing() {
        cv::Mat mirrored;
        cv::flip(disc(130), mirrored, 1);
        const double off = outline_off_step(disc(130), arc(136), unit_px);
        const double back = outline_off_step(mirrored, arc(136, Vec2(400.0 - centre.x, centre.y)), unit_px);
        QVERIFY(std::abs(off - back) < 0.005);
    }
    void strange_outlines_are_safe() {
        const cv::Mat picture = disc(130);
        QCOMPARE(outline_off_step(picture, {}, unit_px), 0.0);
        QCOMPARE(outline_off_step(picture, arc(130, centre, 4), unit_px), 0.0);
        QCOMPARE(outline_off_step(picture, arc(130), 0.0), 0.0);
        QCOMPARE(outline_off_step(picture, arc(130), NAN), 0.0);
        QCOMPARE(outline_off_step(picture, std::vector<Vec2>(33, centre), unit_px), 0.0);
        QCOMPARE(outline_off_step(cv::Mat(), arc(130), unit_px), 0.0);
        for (const Vec2 far : {Vec2(-1e6), Vec2(1e9, 50.0), Vec2(1e300)}) {
            const double off = outline_off_step(picture, arc(130, far), unit_px);
            QVERIFY(off >= 0.0 && off <= 0.15);
        }
    }
};

} // namespace outline_step_test

TP_TEST(outline_step_test, OutlineStepTest, nothing)
#include "outline_step_test.moc"
