// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/face_square.hpp"
#include "faces/identity/sharpened.hpp"
#include "faces/identity/unfit.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <string>

namespace sharpened_test {

using namespace tp;

namespace {

/// Dots of all sizes and colours, blurred.
cv::Mat dots(double blur_px) {
    cv::Mat square(face_square_px, face_square_px, CV_8UC3, cv::Scalar(120, 130, 140));
    cv::RNG random(3);
    for (int i = 0; i < 60; ++i)
        cv::circle(square, {random.uniform(0, face_square_px), random.uniform(0, face_square_px)},
                   random.uniform(2, 14),
                   cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256)),
                   cv::FILLED);
    cv::GaussianBlur(square, square, {}, blur_px);
    return square;
}

double difference(const cv::Mat& one, const cv::Mat& other) { return cv::norm(one, other, cv::NORM_L1); }

} // namespace

class SharpenedTest : public QObject {
    Q_OBJECT

private slots:
    void a_sharp_face_is_given_back_as_it_is() {
        const cv::Mat sharp = dots(0.5);
        QVERIFY(sharpness(sharp) > 0.12);
        QCOMPARE(difference(sharpened_where_soft(sharp), sharp), 0.0);
    }
    void a_soft_one_comes_nearer_to_what_it_was() {
        const cv::Mat before = dots(0.5), soft = dots(4.0);
        QVERIFY(sharpness(soft) < 0.06);
        const cv::Mat sharpened = sharpened_where_soft(soft);
        QVERIFY(sharpened.type() == CV_8UC3 && sharpened.size() == soft.size());
        QVERIFY(sharpness(sharpened) > sharpness(soft));
        QVERIFY(difference(sharpened, before) < 0.9 * difference(soft, before));
    }
    void the_softer_the_more() {
        double less = 0.0;
        for (const double blur_px : {2.0, 2.5, 3.0, 4.0}) {
            const cv::Mat soft = dots(blur_px);
            cv::Mat mask;
            cv::GaussianBlur(soft, mask, {}, 2.5);
            const double amount = difference(sharpened_where_soft(soft), soft) / difference(soft, mask);
            QVERIFY2(amount > less || (less > 1.7 && amount > 1.7), std::to_string(blur_px).c_str());
            less = amount;
        }
        QVERIFY(less > 1.7 && less < 2.1);
    }
    void what_has_no_steps_stays_so() {
        const cv::Mat plain(face_square_px, face_square_px, CV_8UC3, cv::Scalar(90, 100, 110));
        QCOMPARE(difference(sharpened_where_soft(plain), plain), 0.0);
    }
};

} // namespace sharpened_test

TP_TEST(sharpened_test, SharpenedTest, event_loop)
#include "sharpened_test.moc"
