// SPDX-License-Identifier: Apache-2.0
// The camera that a page holds: what is wrong in one sentence, the newest frame between two threads, the desk's camera.
#include "app/capture/camera/camera_trouble.hpp"
#include "app/capture/camera/newest_frame.hpp"
#include "app/capture/camera/stand_in_camera.hpp"

#include <QDir>
#include <QFile>
#include <QSize>
#include <QTemporaryDir>
#include <QTest>
#include <QVideoFrameFormat>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

using namespace tp;
using namespace std::chrono_literals;

namespace {

constexpr auto no_patience = 0ms;
constexpr std::chrono::minutes long_patience{1};

/// A place for cameras like the system's, with this camera in it where a file may stand for one.
struct Places {
    QTemporaryDir folder;
    CameraPlaces places;
    explicit Places(const QString& name = {}) {
        places.devices = folder.filePath("dev").toStdString();
        places.names = folder.filePath("names").toStdString();
        QDir().mkpath(folder.filePath("dev"));
        if (name.isEmpty())
            return;
        put("dev/video0", "");
        QDir().mkpath(folder.filePath("names/video0"));
        put("names/video0/name", name.toUtf8() + '\n');
    }
    void put(const QString& file, const QByteArray& text) const {
        QFile at(folder.filePath(file));
        if (at.open(QIODevice::WriteOnly))
            at.write(text);
    }
};

QVideoFrame frame_of(int width) {
    return QVideoFrame(QVideoFrameFormat(QSize(width, 2), QVideoFrameFormat::Format_Y8));
}

/// A photograph with a white left half.
std::string half_white_photo(const QTemporaryDir& folder) {
    cv::Mat photo(600, 450, CV_8UC3, cv::Scalar(0, 0, 0));
    photo.colRange(0, 225).setTo(cv::Scalar(255, 255, 255));
    const std::string file = folder.filePath("photo.png").toStdString();
    cv::imwrite(file, photo);
    return file;
}

double white_share(const cv::Mat& frame) {
    cv::Mat bright;
    cv::inRange(frame, cv::Scalar(230, 230, 230), cv::Scalar(255, 255, 255), bright);
    return static_cast<double>(cv::countNonZero(bright)) / static_cast<double>(bright.total());
}

} // namespace

class CameraTest : public QObject {
    Q_OBJECT

private slots:
    void each_trouble_has_a_sentence_of_its_own() {
        std::set<std::string> sentences;
        for (const CameraTrouble trouble :
             {CameraTrouble::none_there, CameraTrouble::denied, CameraTrouble::in_use,
              CameraTrouble::unplugged, CameraTrouble::silent, CameraTrouble::unreadable}) {
            const std::string sentence = sentence_of(trouble);
            QVERIFY(sentence.ends_with('.'));
            sentences.insert(sentence);
        }
        QCOMPARE(sentences.size(), std::size_t{6});
    }

    void what_the_system_says_of_a_camera() {
        QCOMPARE(trouble_of(EACCES), CameraTrouble::denied);
        QCOMPARE(trouble_of(EBUSY), CameraTrouble::in_use);
        QCOMPARE(trouble_of(ENODEV), CameraTrouble::unplugged);
        QCOMPARE(trouble_of(EIO), CameraTrouble::silent);
    }

    void without_any_camera_none_is_there() {
        QCOMPARE(why_none(Places().places), CameraTrouble::none_there);
    }

    void a_camera_that_may_not_be_opened_is_denied() {
        const Places at("Webcam");
        QFile(at.folder.filePath("dev/video0")).setPermissions({});
        if (QFile(at.folder.filePath("dev/video0")).open(QIODevice::ReadOnly))
            QSKIP("Whoever runs this test may open everything.");
        QCOMPARE(why_none(at.places), CameraTrouble::denied);
        QCOMPARE(why_silent("Webcam", true, at.places), CameraTrouble::denied);
    }

    void a_silent_camera_is_there_and_an_unplugged_one_is_not() {
        const Places at("Webcam");
        QCOMPARE(why_silent("Webcam", true, at.places), CameraTrouble::silent);
        QCOMPARE(why_silent("Another", true, at.places), CameraTrouble::unplugged);
    }

    void a_name_that_has_no_end_is_no_camera_s() {
        const QString name(5000, 'x');
        const Places at(name);
        QCOMPARE(why_silent(name.toStdString(), true, at.places), CameraTrouble::unplugged);
        const Places last(name.left(1024));
        QCOMPARE(why_silent(name.left(1024).toStdString(), true, last.places), CameraTrouble::silent);
    }

    void a_camera_without_a_name_is_none_whose_name_is_not_told() {
        const Places at("Webcam");
        at.put("names/video0/name", "");
        QCOMPARE(why_silent("", true, at.places), CameraTrouble::unplugged);
    }

    void only_the_newest_frame_is_taken_and_only_once() {
        NewestFrame frames;
        NewestFrame::Taken taken;
        QCOMPARE(frames.take(taken, no_patience), NewestFrame::Came::nothing);
        frames.put(frame_of(2), 1.0);
        frames.put(frame_of(4), 2.0);
        QCOMPARE(frames.take(taken, no_patience), NewestFrame::Came::frame);
        QCOMPARE(taken.frame.width(), 4);
        QCOMPARE(taken.time_s, 2.0);
        QCOMPARE(frames.take(taken, no_patience), NewestFrame::Came::nothing);
    }

    void the_first_trouble_is_told_and_an_end_is_none() {
        NewestFrame frames, ended;
        NewestFrame::Taken taken;
        frames.put(frame_of(2), 1.0);
        frames.fail(CameraTrouble::unplugged);
        frames.fail(CameraTrouble::silent);
        QCOMPARE(frames.take(taken, no_patience), NewestFrame::Came::trouble);
        QCOMPARE(frames.trouble(), CameraTrouble::unplugged);
        ended.put(frame_of(2), 1.0);
        ended.end();
        ended.fail(CameraTrouble::unplugged);
        QCOMPARE(ended.take(taken, no_patience), NewestFrame::Came::end);
    }

    void whoever_waits_is_woken_by_the_end() {
        NewestFrame frames;
        std::thread ends([&] { frames.end(); });
        NewestFrame::Taken taken;
        QCOMPARE(frames.take(taken, long_patience), NewestFrame::Came::end);
        ends.join();
    }

    void names_of_cameras() {
        QVERIFY(camera_named("simulated:a.jpg"));
        QVERIFY(camera_named("folder:."));
        QVERIFY(camera_named("video:a.mp4"));
        for (const char* wrong : {"simulated:", "folder:", "video:", "simulated", "a.jpg", "other:a.jpg"})
            QVERIFY2(!camera_named(wrong), wrong);
    }

    void a_person_at_a_desk_moves_the_camera() {
        const QTemporaryDir folder;
        StandInCamera camera(StandInCamera::Of::photo, half_white_photo(folder));
        QVERIFY(!camera.move_by({})); // it is off
        const auto opened = camera.open(CameraSide::back);
        FrameSource* const source = opened->get();
        const double first = white_share((*source->next())->pixels);
        HeldPose left;
        left.pan_deg = -60.0;
        QVERIFY(camera.move_by(left));
        const double beside = white_share((*source->next())->pixels);
        QVERIFY2(first > 0.02 && beside < 0.5 * first, qPrintable(QString("%1 %2").arg(first).arg(beside)));
        camera.close();
        QVERIFY(!camera.move_by(left));
    }

    void a_photograph_that_is_not_there_is_one_sentence() {
        StandInCamera camera(StandInCamera::Of::photo, "/no/such/photo.jpg");
        const auto opened = camera.open(CameraSide::back);
        FrameSource* const source = opened->get();
        QVERIFY(!source->next().error().empty());
    }

    void a_video_that_is_not_there_is_one_sentence() {
        StandInCamera camera(StandInCamera::Of::video, "/no/such/video.mp4");
        const auto opened = camera.open(CameraSide::back);
        QVERIFY(!camera.moved_by_keys());
        const std::string why = (*opened)->next().error();
        QVERIFY2(why.starts_with("The video \"/no/such/video.mp4\" cannot be played: "), why.c_str());
    }
};

QTEST_GUILESS_MAIN(CameraTest)
#include "camera_test.moc"
