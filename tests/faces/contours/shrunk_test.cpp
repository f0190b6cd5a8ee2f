// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/shrunk.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <cmath>
#include <limits>

namespace shrunk_test {

using namespace tp;

namespace {

/// Each pixel says where it lies.
cv::Mat chart(int width, int height) {
    cv::Mat picture(height, width, CV_8UC3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at<cv::Vec3b>(y, x) = cv::Vec3b(static_cast<uchar>(x / 8), static_cast<uchar>(y / 8), 0);
    return picture;
}

Detection face_of(Vec2 centre, double size) {
    return {{centre - 0.5 * size, centre + 0.5 * size},
            centre - 0.2 * size,
            centre + Vec2(0.2, -0.2) * size,
            1.0};
}

} // namespace

class ShrunkTest : public QObject {
    Q_OBJECT
private slots:
    void a_small_face_is_looked_at_as_it_is() {
        const cv::Mat picture = chart(800, 600);
        const Shrunk near = shrunk_around(picture, face_of({300, 200}, 399.0), 200.0);
        QCOMPARE(near.pixels.data, picture.data);
        QCOMPARE(near.scale(), 1.0);
        QCOMPARE(near.face.box.min, face_of({300, 200}, 399.0).box.min);
    }

    void places_and_pixels_go_together_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("in the middle") << 1000.0 << 700.0;
        QTest::newRow("at the left border") << 200.0 << 700.0;
        QTest::newRow("in the lower right corner") << 1900.0 << 1350.0;
    }
    void places_and_pixels_go_together() {
        QFETCH(double, x);
        QFETCH(double, y);
        const cv::Mat picture = chart(2003, 1401);
        const Detection face = face_of({x, y}, 640.0);
        const Shrunk near = shrunk_around(picture, face, 200.0);
        QCOMPARE(near.scale(), 3.0);
        QVERIFY(near.pixels.cols <= 3 * 640 / 3 && near.pixels.rows <= 3 * 640 / 3);
        QVERIFY(length(near.to_picture(near.face.right_eye) - face.right_eye) < 1e-9);
        QVERIFY(length(near.to_picture(near.face.box.max) - face.box.max) < 1e-9);
        for (const cv::Point at : {cv::Point(0, 0), cv::Point(near.pixels.cols - 1, near.pixels.rows - 1)}) {
            const Vec2 there = near.to_picture(Vec2(at.x + 0.5, at.y + 0.5));
            const cv::Vec3b pixel = near.pixels.at<cv::Vec3b>(at);
            QVERIFY(std::abs(pixel[0] - there.x / 8.0) < 1.5);
            QVERIFY(std::abs(pixel[1] - there.y / 8.0) < 1.5);
        }
    }

    void hostile_boxes_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("size");
        QTest::newRow("far outside") << 1e9 << 900.0;
        QTest::newRow("enormous") << 100.0 << 1e12;
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << 900.0;
        QTest::newRow("of no finite size") << 100.0 << std::numeric_limits<double>::infinity();
        QTest::newRow("of no size") << 100.0 << 0.0;
    }
    void hostile_boxes() {
        QFETCH(double, x);
        QFETCH(double, size);
        const cv::Mat picture = chart(400, 300);
        const Shrunk near = shrunk_around(picture, face_of({x, 100.0}, size), 100.0);
        QVERIFY(!near.pixels.empty());
        QVERIFY(near.scale() >= 1.0);
    }
};

} // namespace shrunk_test

TP_TEST(shrunk_test, ShrunkTest, nothing)
#include "shrunk_test.moc"
