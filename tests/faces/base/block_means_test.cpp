// SPDX-License-Identifier: Apache-2.0
#include "drawn_pictures.hpp"
#include "faces/base/block_means.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

using namespace tp;

class BlockMeansTest : public QObject {
    Q_OBJECT

    /// Of a picture, what OpenCV makes of the same blocks.
    static cv::Mat by_opencv(const cv::Mat& picture, int factor) {
        const cv::Size size(picture.cols / factor, picture.rows / factor);
        cv::Mat result;
        cv::resize(picture(cv::Rect(0, 0, size.width * factor, size.height * factor)), result, size, 0, 0,
                   cv::INTER_AREA);
        return result;
    }

private slots:
    void means_are_those_of_opencv_data() {
        QTest::addColumn<int>("factor");
        for (const int factor : {2, 3, 4, 5, 7, 16, 61})
            QTest::addRow("by %d", factor) << factor;
    }
    /// Noise, and what would overflow first: white.
    void means_are_those_of_opencv() {
        QFETCH(int, factor);
        cv::RNG random(3);
        for (const cv::Mat& picture :
             {drawn::noise(random, {211, 137}), cv::Mat(137, 211, CV_8UC3, cv::Scalar::all(255))}) {
            const cv::Mat found = block_means(picture, factor), wanted = by_opencv(picture, factor);
            QCOMPARE(found.size(), wanted.size());
            QCOMPARE(cv::norm(found, wanted, cv::NORM_INF), 0.0);
        }
    }
    void a_window_of_a_picture_is_shrunk_alone() {
        cv::RNG random(4);
        const cv::Mat part = drawn::noise(random, {90, 80})(cv::Rect(11, 7, 50, 40));
        QCOMPARE(cv::norm(block_means(part, 4), block_means(part.clone(), 4), cv::NORM_INF), 0.0);
    }
    /// Blocks whose rows would not fit into 16 bits, and one block.
    void large_blocks_keep_their_level() {
        const cv::Mat white(600, 400, CV_8UC3, cv::Scalar(255, 254, 3));
        for (const int factor : {257, 258, 400}) {
            const cv::Mat found = block_means(white, factor);
            QCOMPARE(found.size(), cv::Size(400 / factor, 600 / factor));
            QCOMPARE(found.at<cv::Vec3b>(0, 0), cv::Vec3b(255, 254, 3));
        }
    }
    void by_one_it_is_the_picture() {
        const cv::Mat picture(5, 6, CV_8UC3, cv::Scalar::all(7));
        QCOMPARE(block_means(picture, 1).data, picture.data);
    }
};

QTEST_GUILESS_MAIN(BlockMeansTest)
#include "block_means_test.moc"
