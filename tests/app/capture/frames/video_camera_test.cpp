// SPDX-License-Identifier: Apache-2.0
// A video as a camera, in the video's own time.
#include "app/capture/frames/video_camera.hpp"
#include "made_video.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <opencv2/core.hpp>

#include <cmath>
#include <filesystem>
#include <string>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

/// Its left half is red, its right half is blue.
const QStringList two_colours{"-vf", "drawbox=w=32:h=48:c=red:t=fill,drawbox=x=32:w=32:h=48:c=blue:t=fill"};

CameraFrame next(VideoCamera& camera) {
    const auto frame = camera.next();
    return frame && *frame ? **frame : CameraFrame{};
}

bool is_near(const cv::Vec3b& pixel, const cv::Vec3b& colour) {
    return cv::norm(cv::Vec3i(pixel) - cv::Vec3i(colour)) < 40.0;
}
const cv::Vec3b red{0, 0, 255}, blue{255, 0, 0};

} // namespace

class VideoCameraTest : public QObject {
    Q_OBJECT
    QTemporaryDir dir_;
    fs::path path(const char* name) const { return fs::path(dir_.path().toStdString()) / name; }

private slots:
    void initTestCase() { QVERIFY2(can_make_videos(), "ffmpeg is not installed"); }

    void its_pictures_come_in_their_colours_and_at_their_times() {
        QVERIFY(make_video(path("Über uns 1.mp4"), {QString(), QString(), "mp4", two_colours, true}));
        auto camera = VideoCamera::open(path("Über uns 1.mp4"), {true, false});
        QVERIFY2(camera.ok(), camera.error().c_str());
        QVERIFY(camera->held().front);
        for (int i = 0; i < 5; ++i) {
            const CameraFrame frame = next(*camera);
            QCOMPARE(frame.pixels.size(), cv::Size(64, 48));
            QVERIFY(is_near(frame.pixels.at<cv::Vec3b>(24, 10), red));
            QVERIFY(is_near(frame.pixels.at<cv::Vec3b>(24, 54), blue));
            QVERIFY(std::abs(frame.time_s - 0.2 * i) < 0.01);
        }
    }

    void at_its_end_it_begins_again_and_its_clock_runs_on() {
        QVERIFY(make_video(path("video"), {QString(), QString(), "mp4", {}, true}));
        auto camera = VideoCamera::open(path("video"));
        QVERIFY2(camera.ok(), camera.error().c_str());
        const CameraFrame first = next(*camera);
        double last_s = first.time_s;
        for (int i = 1; i < 5; ++i)
            last_s = next(*camera).time_s;
        for (int round = 0; round < 3; ++round) {
            const CameraFrame again = next(*camera);
            QCOMPARE(again.pixels.size(), first.pixels.size());
            QVERIFY(cv::norm(again.pixels, first.pixels, cv::NORM_INF) == 0.0);
            QVERIFY(again.time_s > last_s && again.time_s < last_s + 0.3);
            for (int i = 1; i < 5; ++i)
                last_s = next(*camera).time_s;
        }
    }

    void no_more_come_than_one_aims_with() {
        QVERIFY(make_video(path("video"), {QString(), QString(), "mp4", {"-r", "60"}, true}));
        auto camera = VideoCamera::open(path("video"));
        QVERIFY2(camera.ok(), camera.error().c_str());
        double last_s = next(*camera).time_s;
        for (int i = 0; i < 40; ++i) {
            const double time_s = next(*camera).time_s;
            QVERIFY(time_s - last_s > 0.059);
            last_s = time_s;
        }
    }

    void a_telephones_is_upright() {
        QVERIFY(make_video(path("video"), {QString(), QString(), "mp4", two_colours, true}));
        QVERIFY(turn_video(path("video"), 48)); // clockwise: what was at the left is above
        auto camera = VideoCamera::open(path("video"));
        QVERIFY2(camera.ok(), camera.error().c_str());
        const cv::Mat pixels = next(*camera).pixels;
        QCOMPARE(pixels.size(), cv::Size(48, 64));
        QVERIFY(is_near(pixels.at<cv::Vec3b>(10, 24), red));
        QVERIFY(is_near(pixels.at<cv::Vec3b>(54, 24), blue));
    }

    void what_cannot_be_played_is_one_sentence_also_when_it_is_gone_at_its_end() {
        QVERIFY(make_video(path("video"), {QString(), QString(), "mp4", {}, true}));
        auto camera = VideoCamera::open(path("video"));
        QVERIFY2(camera.ok(), camera.error().c_str());
        fs::remove(path("video"));
        for (int i = 0; i < 5; ++i)
            QVERIFY(!next(*camera).pixels.empty());
        for (int i = 0; i < 2; ++i) {
            const std::string why = camera->next().error();
            QVERIFY2(why.starts_with("The video ") && why.ends_with('.'), why.c_str());
        }
        QVERIFY(!VideoCamera::open(path("video")));
    }
};

QTEST_GUILESS_MAIN(VideoCameraTest)
#include "video_camera_test.moc"
