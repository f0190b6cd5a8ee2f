// SPDX-License-Identifier: Apache-2.0
// Places of faces, and shut eyes, as fast as a camera is aimed.
#include "effort.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "faces/extract/quick_faces.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quick_faces_test {

using namespace tp;

namespace {

cv::Mat shrunk(const cv::Mat& picture, int longer) {
    cv::Mat small;
    const double scale = static_cast<double>(longer) / std::max(picture.cols, picture.rows);
    cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
    return small;
}

cv::Mat sample() { return *read_picture(test::in_source("resources/samples/anna_smiling.jpg")); }

} // namespace

class QuickFacesTest : public QObject {
    Q_OBJECT
private slots:
    void each_head_is_found_once_the_largest_first() {
        QuickFaces faces;
        cv::Mat scene(320, 640, CV_8UC3, cv::Scalar(120, 130, 140));
        const cv::Mat large = shrunk(sample(), 300), small = shrunk(sample(), 160);
        large.copyTo(scene(cv::Rect({330, 10}, large.size())));
        small.copyTo(scene(cv::Rect({40, 80}, small.size())));
        const std::vector<Detection> found = faces.find(shrunk(scene, 320));
        QCOMPARE(found.size(), std::size_t{2});
        QVERIFY(found[0].size() > 1.4 * found[1].size());
        QVERIFY(found[0].box.centre().x > 160.0 && found[1].box.centre().x < 160.0);
    }

    void small_heads_are_not_found_twice() {
        NEEDS_PORTRAITS();
        QuickFaces faces;
        const auto people = portraits::held_out();
        for (std::size_t i = 0; i < tp::test::tried_of(12); ++i) {
            cv::Mat scene(180, 320, CV_8UC3, cv::Scalar(128, 128, 128));
            const cv::Mat small = shrunk(*read_picture(people[i].photo), 45);
            small.copyTo(scene(cv::Rect({140, 60}, small.size())));
            QCOMPARE(faces.find(scene).size(), std::size_t{1});
        }
    }

    void shut_eyes_are_told_from_open_ones() {
        NEEDS_PORTRAITS();
        QuickFaces faces;
        const auto people = portraits::held_out();
        for (std::size_t i = 0; i < tp::test::tried_of(12); ++i) {
            const cv::Mat open = *read_picture(people[i].photo);
            const cv::Mat shut =
                with_closed_eyes(open, people[i].truth, 1.0, static_cast<unsigned>(i)).picture;
            for (const int side : {720, 220}) {
                const cv::Mat picture = shrunk(open, side);
                const std::vector<Detection> found = faces.find(picture);
                QVERIFY(!found.empty());
                QVERIFY(!faces.eyes_shut(picture, found.front()));
                QVERIFY(faces.eyes_shut(shrunk(shut, side), found.front()));
            }
        }
    }

    void nobody_has_no_shut_eyes() {
        QuickFaces faces;
        cv::Mat plain(320, 320, CV_8UC3, cv::Scalar(90, 100, 110));
        QVERIFY(faces.find(plain).empty());
        QVERIFY(
            !faces.eyes_shut(plain, {{{100.0, 100.0}, {200.0, 200.0}}, {130.0, 140.0}, {170.0, 140.0}, 0.9}));
    }
};

} // namespace quick_faces_test

TP_TEST(quick_faces_test, QuickFacesTest, nothing)
#include "quick_faces_test.moc"
