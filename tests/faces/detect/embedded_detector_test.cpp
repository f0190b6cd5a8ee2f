// SPDX-License-Identifier: Apache-2.0
#include "drawn_pictures.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

namespace embedded_detector_test {

using namespace tp;

namespace {

/// A drawn portrait, `px` wide, amid clouds; only clouds where `px` is 0.
cv::Mat portrait_in_clouds(cv::Size size, int px) {
    cv::RNG random(11);
    cv::Mat picture = drawn::clouds(random, size, 60);
    if (px > 0) {
        cv::Mat small = read_picture(tp::test::in_source("resources/samples/anna_smiling.jpg")).value();
        cv::resize(small, small, {px, px * small.rows / small.cols}, 0, 0, cv::INTER_AREA);
        small.copyTo(picture(cv::Rect(cv::Point(size.width / 3, size.height / 4), small.size())));
    }
    return picture;
}

} // namespace

class EmbeddedDetectorTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { quiet_opencv(); }

    void a_search_that_goes_on_finds_what_one_from_the_start_finds_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("portrait_px");
        QTest::newRow("no face") << 1400 << 900 << 0;
        QTest::newRow("no face, in tiles") << 3600 << 2500 << 0;
        QTest::newRow("a large face ends the usual search early") << 1400 << 1100 << 600;
        QTest::newRow("the same, in tiles") << 2500 << 3600 << 1300;
        QTest::newRow("a small face, in tiles") << 3600 << 2500 << 150;
        QTest::newRow("a picture smaller than any level") << 120 << 90 << 0;
    }
    void a_search_that_goes_on_finds_what_one_from_the_start_finds() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, portrait_px);
        const cv::Mat picture = portrait_in_clouds({width, height}, portrait_px);
        EmbeddedDetector detector;
        const std::vector<Detection> at_once = detector.detect(picture, Effort::thorough);
        Looks looks;
        const std::vector<Detection> usual = detector.detect(picture, Effort::usual, looks, {});
        QVERIFY(usual == detector.detect(picture, Effort::usual));
        const std::size_t taken = looks.taken;
        QVERIFY(detector.detect(picture, Effort::thorough, looks, {}) == at_once);
        QVERIFY(looks.taken >= taken);
        if (portrait_px > 0)
            QVERIFY(!at_once.empty());
    }

    void a_stopped_search_takes_no_look() {
        std::stop_source stop;
        stop.request_stop();
        Looks looks;
        EmbeddedDetector detector;
        detector.detect(portrait_in_clouds({3600, 2500}, 0), Effort::thorough, looks, stop.get_token());
        QCOMPARE(looks.taken, std::size_t{0});
    }
};

} // namespace embedded_detector_test

TP_TEST(embedded_detector_test, EmbeddedDetectorTest, nothing)
#include "embedded_detector_test.moc"
