// SPDX-License-Identifier: Apache-2.0
// Frames of a folder and of a photograph in a simulated hand.
#include "app/capture/frames/folder_camera.hpp"
#include "app/capture/frames/paced_camera.hpp"
#include "app/capture/frames/photo_view.hpp"
#include "app/capture/frames/simulated_camera.hpp"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

using namespace tp;

namespace {

/// Dark, with a white dot at this place, shares of the picture.
cv::Mat dotted(double x, double y, cv::Size size = {2000, 1500}) {
    cv::Mat photo(size, CV_8UC3, cv::Scalar(20, 20, 20));
    cv::circle(photo, cv::Point(static_cast<int>(x * size.width), static_cast<int>(y * size.height)), 12,
               cv::Scalar(255, 255, 255), cv::FILLED);
    return photo;
}

/// The middle of what is white, shares of the frame; not finite where nothing is.
Vec2 dot_in(const cv::Mat& frame) {
    cv::Mat grey;
    cv::cvtColor(frame, grey, cv::COLOR_BGR2GRAY);
    cv::threshold(grey, grey, 180, 255, cv::THRESH_BINARY);
    const cv::Moments moments = cv::moments(grey, true);
    return {(moments.m10 / moments.m00 + 0.5) / frame.cols, (moments.m01 / moments.m00 + 0.5) / frame.rows};
}

TremorManner no_tremor() {
    TremorManner still;
    still.peak_g = still.sway_deg = 0.0;
    return still;
}

SimulatedHold steady() {
    SimulatedHold hold;
    hold.tremor = no_tremor();
    hold.taking.size = {640, 360};
    return hold;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

cv::Mat pixels_of(FrameSource& source) { return (*source.next())->pixels; }

/// Width over height of what is white, px.
cv::Rect extent(const cv::Mat& frame, int level = 60) {
    cv::Mat grey;
    cv::cvtColor(frame, grey, cv::COLOR_BGR2GRAY);
    return cv::boundingRect(grey > level);
}

} // namespace

class FramesTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }

private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }

    void the_way_to_a_place_and_back_is_none() {
        const CameraOptics optics;
        const PhotoWall wall;
        const HeldPose pose{
            .pan_deg = 11.0, .tilt_deg = -7.0, .roll_deg = 16.0, .forward_m = 0.4, .zoom = 1.7};
        const double photo_aspect = 4.0 / 3.0;
        for (const Vec2 in_frame : {Vec2(0.5), Vec2(0.1, 0.2), Vec2(0.9, 0.95)}) {
            const Vec2 at = place_on_photo(in_frame, photo_aspect, wall, pose, optics);
            const ScenePlace place{(at.x - wall.aim.x) * wall.width_m,
                                   (wall.aim.y - at.y) * wall.width_m / photo_aspect, wall.ahead_m};
            QVERIFY(length(projected(place, pose, optics)->at - in_frame) < 1e-9);
        }
        QVERIFY(!is_finite(place_on_photo({0.5, 0.5}, photo_aspect, wall, {.pan_deg = 95.0}, optics)));
        QVERIFY(!is_finite(place_on_photo({0.5, 0.5}, photo_aspect, wall, {.forward_m = 2.0}, optics)));
    }

    void a_dot_lies_where_geometry_says() {
        const cv::Mat photo = dotted(0.6, 0.4);
        const CameraOptics optics;
        const PhotoWall wall;
        for (const HeldPose& pose :
             {HeldPose{}, HeldPose{.pan_deg = 8.0, .tilt_deg = 5.0}, HeldPose{.roll_deg = 30.0},
              HeldPose{.forward_m = 0.5}, HeldPose{.zoom = 2.0}}) {
            const ScenePlace place{0.1 * wall.width_m, 0.1 * wall.width_m * 0.75, wall.ahead_m};
            const cv::Mat frame = view_of(photo, wall, pose, {}, optics, {});
            QCOMPARE(frame.size(), cv::Size(1280, 720));
            QVERIFY(length(dot_in(frame) - projected(place, pose, optics)->at) < 2e-3);
        }
    }

    void beside_the_photograph_is_grey() {
        const cv::Mat frame = view_of(dotted(0.5, 0.5), {}, {.pan_deg = 120.0}, {}, {}, {});
        QCOMPARE(frame.at<cv::Vec3b>(300, 600), cv::Vec3b(128, 128, 128));
    }

    void exposure_is_a_factor() {
        const cv::Mat photo(1500, 2000, CV_8UC3, cv::Scalar(100, 100, 100));
        FrameTaking taking;
        taking.exposure = 0.5;
        QCOMPARE(view_of(photo, {}, {}, {}, {}, taking).at<cv::Vec3b>(360, 640)[0],
                 static_cast<unsigned char>(50));
        taking.exposure = 5.0;
        QCOMPARE(view_of(photo, {}, {}, {}, {}, taking).at<cv::Vec3b>(360, 640)[0],
                 static_cast<unsigned char>(255));
    }

    void a_moving_camera_smears_and_a_rolling_shutter_leans() {
        const cv::Mat photo = dotted(0.5, 0.5);
        FrameTaking taking;
        taking.readout_s = 0.0;
        const int still = extent(view_of(photo, {}, {}, {}, {}, taking)).width;
        const int smeared = extent(view_of(photo, {}, {}, {.pan_deg = 60.0}, {}, taking)).width;
        QVERIFY(smeared > still + 8); // 60°/s in 1/60 s are 18 px
        // A line from top to bottom leans by what the camera turns while it is read out.
        cv::Mat line(1500, 2000, CV_8UC3, cv::Scalar(20, 20, 20));
        cv::line(line, {1000, 0}, {1000, 1499}, cv::Scalar(255, 255, 255), 6);
        taking.exposed_s = 1e-4;
        const int straight = extent(view_of(line, {}, {}, {.pan_deg = 60.0}, {}, taking)).width;
        taking.readout_s = 1.0 / 30.0;
        const int leaning = extent(view_of(line, {}, {}, {.pan_deg = 60.0}, {}, taking)).width;
        QVERIFY(leaning > straight + 25); // 2° are 37 px
    }

    void a_seed_gives_the_same_bytes_and_another_one_others() {
        SimulatedHold hold;
        hold.taking.size = {320, 180};
        SimulatedCamera one(dotted(0.5, 0.5), hold);
        SimulatedCamera again(dotted(0.5, 0.5), hold);
        hold.seed = 2;
        SimulatedCamera other(dotted(0.5, 0.5), hold);
        bool differs = false;
        for (int i = 0; i < 5; ++i) {
            const cv::Mat frame = pixels_of(one);
            QVERIFY(same(frame, pixels_of(again)));
            differs = differs || !same(frame, pixels_of(other));
        }
        QVERIFY(differs);
    }

    void it_goes_where_it_is_moved() {
        SimulatedCamera camera(dotted(0.5, 0.5), steady());
        QVERIFY(length(dot_in(pixels_of(camera)) - Vec2(0.5)) < 5e-3);
        camera.move_to({.pan_deg = 10.0});
        QVERIFY(pixels_of(camera).size() == cv::Size(640, 360));
        const CameraFrame frame = **camera.next();
        QVERIFY(dot_in(frame.pixels).x < 0.4);
        QVERIFY(std::abs(frame.time_s - 2.0 / 15.0) < 1e-9);
        QCOMPARE(frame.elevation_deg, std::optional(0.0));
        camera.expose(0.1);
        QVERIFY(!is_finite(dot_in(pixels_of(camera))));
    }

    void a_mirrored_one_swaps_the_sides() {
        SimulatedHold hold = steady();
        hold.held = {true, true};
        SimulatedCamera camera(dotted(0.7, 0.5), hold);
        QVERIFY(camera.held().front && camera.held().mirrored);
        QVERIFY(dot_in(pixels_of(camera)).x < 0.4);
    }

    void a_folder_is_its_pictures_in_order() {
        const std::filesystem::path folder = path("frames");
        std::filesystem::create_directory(folder);
        for (int i = 0; i < 3; ++i)
            QVERIFY(cv::imwrite((folder / ("frame" + std::to_string(i) + ".png")).string(),
                                cv::Mat(20, 30, CV_8UC3, cv::Scalar(10 * i, 0, 0))));
        QFile notes(QString::fromStdString((folder / "a_note.txt").string()));
        QVERIFY(notes.open(QIODevice::WriteOnly));
        auto camera = FolderCamera::open(folder, 5.0, {true, false});
        QVERIFY(camera);
        QCOMPARE(camera->frame_count(), std::size_t{3});
        QVERIFY(camera->held().front);
        for (int i = 0; i < 3; ++i) {
            const auto frame = camera->next();
            QVERIFY(frame && *frame);
            QCOMPARE((*frame)->pixels.at<cv::Vec3b>(5, 5)[0], static_cast<unsigned char>(10 * i));
            QVERIFY(std::abs((*frame)->time_s - 0.2 * i) < 1e-9);
        }
        const auto over = camera->next();
        QVERIFY(over && !*over);
    }

    void a_paced_one_gives_the_same_frames_and_waits_no_longer_than_it_is_let() {
        SimulatedHold hold = steady();
        hold.held = {true, false};
        SimulatedCamera bare(dotted(0.5, 0.5), hold);
        PacedCamera quick(std::make_unique<SimulatedCamera>(dotted(0.5, 0.5), hold));
        QVERIFY(quick.held().front);
        for (int i = 0; i < 3; ++i)
            QVERIFY(same(pixels_of(bare), pixels_of(quick)));

        hold.frames_per_s = 1e-5; // one a day
        PacedCamera slow(std::make_unique<SimulatedCamera>(dotted(0.5, 0.5), hold));
        QVERIFY(*slow.next());
        std::atomic<bool> ended = false;
        std::thread waiting([&] {
            (void)slow.next();
            ended = true;
        });
        QVERIFY(!ended);
        slow.interrupt();
        waiting.join();
        (void)slow.next(); // nor does any later one wait
    }

    void a_picture_that_is_none_is_one_error() {
        const std::filesystem::path folder = path("broken");
        std::filesystem::create_directory(folder);
        QVERIFY(cv::imwrite((folder / "b.png").string(), cv::Mat(20, 30, CV_8UC3, cv::Scalar(1, 2, 3))));
        QFile broken(QString::fromStdString((folder / "a.jpg").string()));
        QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("no picture") > 0);
        broken.close();
        auto camera = FolderCamera::open(folder, 5.0);
        QVERIFY(camera);
        QVERIFY(!camera->next());
        const auto good = camera->next();
        QVERIFY(good && *good);
        QVERIFY(std::abs((*good)->time_s - 0.2) < 1e-9);
    }

    void what_cannot_be_opened_says_why() {
        QVERIFY(!FolderCamera::open(path("nowhere"), 5.0));
        std::filesystem::create_directory(path("empty"));
        auto empty = FolderCamera::open(path("empty"), 5.0);
        QVERIFY(empty);
        const auto nothing = empty->next();
        QVERIFY(nothing && !*nothing);
        const auto missing = SimulatedCamera::open(path("nowhere.jpg"), {});
        QVERIFY(!missing);
        QVERIFY(missing.error().ends_with('.'));
    }
};

QTEST_APPLESS_MAIN(FramesTest)
#include "frames_test.moc"
