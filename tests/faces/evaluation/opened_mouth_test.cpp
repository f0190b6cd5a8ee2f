// SPDX-License-Identifier: Apache-2.0
#include "drawn_contours.hpp"
#include "faces/evaluation/opened_mouth.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace opened_mouth_test {

using namespace tp;

namespace {

/// A face of ellipses: the mouth 80 px wide around (200, 280), a little open.
std::vector<Contour> truth() {
    std::vector<Vec2> jaw;
    for (int i = 0; i <= 20; ++i) {
        const double angle = std::numbers::pi * (1.0 - i / 20.0);
        jaw.push_back(Vec2(200, 200) + Vec2(110, 150) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return {ellipse(feature::right_eye, {155, 190}, {20, 8}), ellipse(feature::left_eye, {245, 190}, {20, 8}),
            ellipse(feature::outer_lip, {200, 280}, {46, 16}),
            ellipse(feature::inner_lip, {200, 280}, {40, 3}), contour_through(feature::outline, jaw, false)};
}

/// Skin with a black stroke along the lower lip's outer edge, to be seen where it goes.
cv::Mat portrait() {
    cv::Mat picture(480, 400, CV_8UC3, cv::Scalar(130, 150, 200));
    cv::ellipse(picture, {200, 280}, {46, 16}, 0.0, 20.0, 160.0, cv::Scalar(0, 0, 0), 3);
    return picture;
}

} // namespace

class OpenedMouthTest : public QObject {
    Q_OBJECT
private slots:
    void lips_part_by_as_much_as_was_asked_data() {
        QTest::addColumn<double>("openness");
        for (const double openness : {0.1, 0.25, 0.5, 0.8})
            QTest::addRow("%.2f", openness) << openness;
    }
    void lips_part_by_as_much_as_was_asked() {
        QFETCH(double, openness);
        const Degraded open = with_opened_mouth(portrait(), truth(), openness, 1);
        const double drop = openness * 80.0;
        const Rect inner = extent(open.truth, feature::inner_lip);
        QVERIFY(std::abs(inner.height() - 6.0 - drop) < 1.0);
        QVERIFY(std::abs(inner.width() - 80.0) < 1.0);
        QVERIFY(std::abs(inner.min.y - 277.0) < 0.5); // the upper lip stays
        const Rect jaw = extent(open.truth, feature::outline);
        QVERIFY(jaw.max.y > 350.0 + 0.7 * drop && jaw.max.y <= 350.0 + drop + 0.5);
        for (const char* eye : {feature::right_eye, feature::left_eye})
            QVERIFY(*contour_error_percent(truth(), open.truth, eye) < 0.1);
        // What was painted went where its truth went.
        const Rect lip = extent(open.truth, feature::outer_lip);
        double seen = 0.0;
        for (int y = 285; y < open.picture.rows; ++y)
            if (open.picture.at<cv::Vec3b>(y, 200)[2] < 20)
                seen = y + 0.5;
        QVERIFY2(std::abs(seen - lip.max.y) < 3.0, qPrintable(QString("%1 %2").arg(seen).arg(lip.max.y)));
        // And between the lips it is dark.
        QVERIFY(open.picture.at<cv::Vec3b>(static_cast<int>(inner.max.y) - 3, 200)[1] < 110);
    }
    void the_same_seed_opens_it_the_same_way() {
        const Degraded one = with_opened_mouth(portrait(), truth(), 0.4, 5);
        QCOMPARE(cv::norm(one.picture, with_opened_mouth(portrait(), truth(), 0.4, 5).picture), 0.0);
        QCOMPARE(one.how, std::string("mouth opened 40 %"));
    }
    void without_a_lip_nothing_changes() {
        std::vector<Contour> lipless = truth();
        lipless.erase(lipless.begin() + 3);
        const Degraded same = with_opened_mouth(portrait(), lipless, 0.4, 5);
        QCOMPARE(cv::norm(same.picture, portrait()), 0.0);
        QCOMPARE(same.truth.size(), lipless.size());
    }
};

} // namespace opened_mouth_test

TP_TEST(opened_mouth_test, OpenedMouthTest, nothing)
#include "opened_mouth_test.moc"
