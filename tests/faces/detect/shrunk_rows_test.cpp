// SPDX-License-Identifier: Apache-2.0
#include "drawn_pictures.hpp"
#include "faces/detect/shrunk_rows.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <algorithm>

using namespace tp;

namespace {

/// The shrunk picture made at once.
cv::Mat whole(const cv::Mat& picture, int longer) {
    const cv::Mat blocks = shrunk_by_blocks(picture, longer);
    cv::Mat result;
    cv::resize(blocks, result, size_with_longer_side(blocks.size(), longer), 0, 0, cv::INTER_AREA);
    return result;
}

double largest_difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

#ifdef __aarch64__
constexpr double rounding = 1.0; ///< grey levels: OpenCV's own products and sums round once there
#else
constexpr double rounding = 0.0;
#endif

} // namespace

class ShrunkRowsTest : public QObject {
    Q_OBJECT
private slots:
    void rows_are_those_of_the_whole_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("longer");
        QTest::newRow("two fifths, landscape") << 1733 << 1155 << 693;
        QTest::newRow("two fifths, portrait") << 1155 << 1733 << 693;
        QTest::newRow("by whole blocks only") << 1200 << 900 << 400;
        QTest::newRow("by less than two") << 1000 << 700 << 667;
        QTest::newRow("as it is") << 320 << 240 << 320;
        QTest::newRow("a strip of 16 rows") << 4000 << 16 << 1600;
        QTest::newRow("one row") << 4000 << 1 << 1600;
        QTest::newRow("one column") << 1 << 4000 << 1600;
    }
    void rows_are_those_of_the_whole() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, longer);
        cv::RNG random(5);
        const cv::Mat picture = drawn::noise(random, {width, height});
        const cv::Mat wanted = whole(picture, longer);
        const ShrunkRows shrunk(picture, longer);
        QCOMPARE(shrunk.size().width, wanted.cols);
        QCOMPARE(shrunk.size().height, wanted.rows);
        QVERIFY(largest_difference(shrunk.rows({0, wanted.rows}), wanted) <= rounding);
        for (int from = 0; from < wanted.rows; from += 37) {
            const cv::Range rows(from, std::min(from + 50, wanted.rows));
            QVERIFY(largest_difference(shrunk.rows(rows), wanted.rowRange(rows)) <= rounding);
        }
    }

    void a_part_of_a_larger_picture_is_shrunk_like_a_copy_of_it() {
        cv::RNG random(6);
        const cv::Mat part = drawn::noise(random, {900, 800})(cv::Rect(101, 57, 701, 503));
        QCOMPARE(largest_difference(ShrunkRows(part, 280).rows({20, 90}),
                                    ShrunkRows(part.clone(), 280).rows({20, 90})),
                 0.0);
    }

    void blocks_leave_the_longer_side_long_enough() {
        QCOMPARE(block_factor({8660, 5773}, 3464), 2);
        QCOMPARE(block_factor({8660, 5773}, 640), 13);
        QCOMPARE(block_factor({639, 400}, 640), 1);
        QCOMPARE(block_factor({1, 4000}, 100), 1);
        const cv::Mat picture(100, 90, CV_8UC3);
        QCOMPARE(shrunk_by_blocks(picture, 60).data, picture.data);
        QCOMPARE(shrunk_by_blocks(picture, 30).rows, 33);
    }
};

QTEST_APPLESS_MAIN(ShrunkRowsTest)
#include "shrunk_rows_test.moc"
