// SPDX-License-Identifier: Apache-2.0
#include "drawn_contours.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace closed_eyes_test {

using namespace tp;

namespace {

/// Two eyes, 60 px wide and 20 px high, and a mouth.
std::vector<Contour> truth() {
    return {ellipse(feature::right_eye, {130, 200}, {30, 10}),
            ellipse(feature::left_eye, {270, 200}, {30, 10}),
            ellipse(feature::outer_lip, {200, 300}, {46, 16})};
}

const cv::Scalar skin(130, 150, 200), white(250, 250, 250);

cv::Mat portrait() {
    cv::Mat picture(400, 400, CV_8UC3, skin);
    for (const int x : {130, 270})
        cv::ellipse(picture, {x, 200}, {30, 10}, 0.0, 0.0, 360.0, white, cv::FILLED);
    return picture;
}

int white_px(const cv::Mat& picture, const Rect& where) {
    cv::Mat is_white;
    cv::inRange(picture(cv::Rect(static_cast<int>(where.min.x), static_cast<int>(where.min.y),
                                 static_cast<int>(where.width()), static_cast<int>(where.height()))),
                cv::Scalar(235, 235, 235), cv::Scalar(255, 255, 255), is_white);
    return cv::countNonZero(is_white);
}

} // namespace

class ClosedEyesTest : public QObject {
    Q_OBJECT
private slots:
    void lids_meet_as_far_as_was_asked_data() {
        QTest::addColumn<double>("shut");
        for (const double shut : {0.0, 0.3, 0.6, 1.0})
            QTest::addRow("%.1f", shut) << shut;
    }
    void lids_meet_as_far_as_was_asked() {
        QFETCH(double, shut);
        const Degraded closed = with_closed_eyes(portrait(), truth(), shut, 4);
        for (const char* eye : {feature::right_eye, feature::left_eye}) {
            const Rect was = extent(truth(), eye), is = extent(closed.truth, eye);
            QVERIFY(std::abs(is.width() - was.width()) < 0.5); // the corners stay
            const double gap = contour_gap(closed.truth, eye);
            QVERIFY2(std::abs(gap - 20.0 * (1.0 - shut)) < 1.0, qPrintable(QString::number(gap)));
            QVERIFY(is.max.y > 206.0); // they meet at the lower lid or a little above it
            // The white that is left is what lies between the lids, without what lashes are painted over.
            const int left = white_px(closed.picture, was);
            QVERIFY2(left <= (1.0 - shut) * white_px(portrait(), was) + 1.0,
                     qPrintable(QString::number(left)));
            QVERIFY(left >= (shut < 0.5 ? 200 : 0));
        }
        QVERIFY(*contour_error_percent(truth(), closed.truth, feature::outer_lip) < 0.01);
        QCOMPARE(cv::norm(closed.picture.rowRange(240, 400), portrait().rowRange(240, 400), cv::NORM_INF),
                 0.0);
    }
    void the_same_seed_shuts_them_the_same_way() {
        const Degraded one = with_closed_eyes(portrait(), truth(), 1.0, 5);
        QCOMPARE(cv::norm(one.picture, with_closed_eyes(portrait(), truth(), 1.0, 5).picture), 0.0);
        QCOMPARE(one.how, std::string("eyes shut by 100 %"));
    }
    void without_an_eye_nothing_changes() {
        std::vector<Contour> one_eye = truth();
        one_eye.erase(one_eye.begin());
        const Degraded same = with_closed_eyes(portrait(), one_eye, 1.0, 5);
        QCOMPARE(cv::norm(same.picture, portrait()), 0.0);
        QCOMPARE(same.truth.size(), one_eye.size());
    }

private:
    /// Between the lids in the middle of the eye.
    static double contour_gap(const std::vector<Contour>& contours, const char* eye) {
        const std::vector<Vec2> points = flatten(*contour_named(contours, eye)).points;
        const double middle = bounds_of(points).centre().x;
        double low = 1e9, high = -1e9;
        for (const Vec2 p : points)
            if (std::abs(p.x - middle) < 2.0) {
                low = std::min(low, p.y);
                high = std::max(high, p.y);
            }
        return high - low;
    }
};

} // namespace closed_eyes_test

TP_TEST(closed_eyes_test, ClosedEyesTest, nothing)
#include "closed_eyes_test.moc"
