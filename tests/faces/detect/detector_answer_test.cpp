// SPDX-License-Identifier: Apache-2.0
#include "drawn_pictures.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/detect/detector_answer.hpp"
#include "faces/models/model_catalog.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QSize>
#include <QTest>

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace detector_answer_test {

using namespace tp;

namespace {

/// Drawn portraits amid clouds, so that there is something to answer everywhere.
cv::Mat crowd(cv::Size size) {
    cv::RNG random(17);
    cv::Mat picture = drawn::clouds(random, size, 60);
    const cv::Mat portrait = read_picture(tp::test::in_source("resources/samples/anna_smiling.jpg")).value();
    for (int px = 40; px < std::min(size.width, size.height) / 2; px += px / 2) {
        cv::Mat small;
        cv::resize(portrait, small, {px, px * portrait.rows / portrait.cols}, 0, 0, cv::INTER_AREA);
        small.copyTo(picture(cv::Rect(
            {random.uniform(0, size.width - small.cols), random.uniform(0, size.height - small.rows)},
            small.size())));
    }
    return picture;
}

double largest_difference(const cv::Mat& a, const cv::Mat& b) {
    if (a.dims != 4 || b.dims != 4 || a.size != b.size)
        return 1e9;
    return cv::norm(a.reshape(1, 1), b.reshape(1, 1), cv::NORM_INF);
}

} // namespace

class DetectorAnswerTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { quiet_opencv(); }

    void parts_answer_as_the_whole_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("longest_part");
        QTest::newRow("3:2") << QSize(1280, 853) << 640;
        QTest::newRow("2:3") << QSize(853, 1280) << 640;
        QTest::newRow("square") << QSize(1280, 1280) << 640;
        QTest::newRow("panorama") << QSize(1280, 200) << 640;
        QTest::newRow("one px too long") << QSize(641, 480) << 640;
        QTest::newRow("parts of one block") << QSize(300, 70) << 32;
        QTest::newRow("parts that differ in size") << QSize(1000, 700) << 300;
        QTest::newRow("one part") << QSize(500, 640) << 640;
    }
    /// Not nearly: the same bits, so that cutting changes no face.
    void parts_answer_as_the_whole() {
        QFETCH(QSize, size);
        QFETCH(int, longest_part);
        const cv::Mat picture = crowd({size.width(), size.height()});
        cv::dnn::Net net = embedded_net(EmbeddedModel::detector);
        const cv::Mat whole = detector_answer(net, picture);
        QCOMPARE(whole.size[2], (size.height() + 31) / 32 * 32 / detector_cell);
        QCOMPARE(whole.size[3], (size.width() + 31) / 32 * 32 / detector_cell);
        QCOMPARE(largest_difference(whole, detector_answer_in_parts(picture, longest_part)), 0.0);
    }

    /// Colour order, scale, offset and border are those of the training.
    void the_net_is_shown_what_blobs_of_opencv_show() {
        const cv::Mat picture = crowd({310, 200});
        cv::Mat padded;
        cv::copyMakeBorder(picture, padded, 0, 24, 0, 10, cv::BORDER_CONSTANT, cv::Scalar::all(127));
        cv::dnn::Net net = embedded_net(EmbeddedModel::detector);
        net.setInput(cv::dnn::blobFromImage(padded, 1.0 / 255.0, {}, cv::Scalar::all(127.5)));
        const cv::Mat expected = net.forward().clone();
        QCOMPARE(largest_difference(expected, detector_answer(net, picture)), 0.0);
    }

    /// A part of a larger picture is no different from the same pixels alone.
    void rows_of_a_larger_picture_are_read_as_they_lie() {
        const cv::Mat picture = crowd({400, 400}), part = picture(cv::Rect(37, 51, 200, 160));
        cv::dnn::Net net = embedded_net(EmbeddedModel::detector);
        const cv::Mat expected = detector_answer(net, part.clone()).clone();
        QCOMPARE(largest_difference(expected, detector_answer(net, part)), 0.0);
    }
};

} // namespace detector_answer_test

TP_TEST(detector_answer_test, DetectorAnswerTest, nothing)
#include "detector_answer_test.moc"
