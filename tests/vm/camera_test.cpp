// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: a camera of the kernel's own, which draws bars of colour (vivid), through Qt to what whoever aims it
// would see and hear. Its faults are those of a cable that is pulled out, of another program that has it, and of one that is
// slow or silent.
#include "app/capture/camera/media_backend.hpp"
#include "app/capture/camera/system_camera.hpp"
#include "video_node.hpp"

#include <QGuiApplication>
#include <QTest>

#include <opencv2/core.hpp>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

using namespace tp;
using namespace std::chrono_literals;

namespace {

constexpr const char* node = "/dev/video0";
constexpr double rate = 12.5; ///< a second, of the largest pictures that are fast enough

/// What a page's camera gave until `enough` or its end.
struct Seen {
    std::string camera; ///< what it is called
    std::vector<CameraFrame> frames;
    std::string why; ///< it ended, in a sentence
};

Seen watch(SystemCamera& camera, const std::function<bool(const Seen&)>& enough) {
    Seen seen;
    auto opened = camera.open(CameraSide::front);
    if (!opened) {
        seen.why = opened.error();
        return seen;
    }
    seen.camera = camera.name();
    FrameSource& source = **opened;
    auto pulled = std::async(std::launch::async, [&] { // as "camera" does, the thread of CameraWatch
        while (!enough(seen)) {
            auto next = source.next();
            if (!next || !*next) {
                seen.why = next ? "It ended." : next.error();
                return;
            }
            seen.frames.push_back(**std::move(next));
        }
    });
    while (pulled.wait_for(0s) != std::future_status::ready)
        QTest::qWait(10);
    camera.close();
    return seen;
}

auto at_least(std::size_t frames) {
    return [frames](const Seen& seen) { return seen.frames.size() >= frames; };
}

double seconds_of(const Seen& seen) { return seen.frames.back().time_s - seen.frames.front().time_s; }

} // namespace

class CameraVmTest : public QObject {
    Q_OBJECT

    SystemCamera camera_;

private slots:
    /// While files are read from outside the machine its time runs on: once all are there, it does not.
    void initTestCase() {
        constexpr int tries = 5;
        for (int i = 0; i < tries && !watch(camera_, at_least(3)).why.empty(); ++i)
            continue;
    }

    void the_largest_pictures_that_are_fast_enough_come_in_time_and_in_colour() {
        const Seen seen = watch(camera_, at_least(15));
        QCOMPARE(seen.why, std::string());
        QCOMPARE(seen.camera, std::string("vivid"));
        for (std::size_t i = 0; i < seen.frames.size(); ++i) {
            QCOMPARE(seen.frames[i].pixels.cols, 1280);
            QCOMPARE(seen.frames[i].pixels.rows, 720);
            QCOMPARE(seen.frames[i].pixels.type(), CV_8UC3);
            QVERIFY(i == 0 || seen.frames[i].time_s > seen.frames[i - 1].time_s);
        }
        const double took = seconds_of(seen) * rate / 14.0;
        QVERIFY2(took > 0.9 && took < 1.3, qPrintable(QString::number(took)));
        // Bars of 75 % from the left: white, yellow, cyan, green, magenta, red, blue, black (ITU-R BT.801); BGR.
        const std::vector<cv::Vec3b> bars{{191, 191, 191}, {0, 191, 191}, {191, 191, 0}, {0, 191, 0},
                                          {191, 0, 191},   {0, 0, 191},   {191, 0, 0},   {0, 0, 0}};
        for (std::size_t i = 0; i < bars.size(); ++i) {
            const cv::Mat bar = seen.frames[9].pixels({static_cast<int>(i) * 160 + 60, 500, 40, 100});
            const cv::Scalar mean = cv::mean(bar);
            for (int c = 0; c < 3; ++c)
                QVERIFY2(
                    std::abs(mean[c] - bars[i][c]) < 25.0,
                    qPrintable(QString("bar %1: %2 %3 %4").arg(i).arg(mean[0]).arg(mean[1]).arg(mean[2])));
        }
    }

    void switched_off_it_is_free_for_others() {
        QVERIFY(watch(camera_, at_least(2)).why.empty());
        QVERIFY(vm::VideoNode(node).occupy());
    }

    void what_another_program_has_is_said_and_works_when_that_has_ended() {
        {
            const vm::VideoNode another(node);
            QVERIFY(another.occupy());
            const Seen seen = watch(camera_, at_least(1));
            QCOMPARE(seen.why, sentence_of(CameraTrouble::in_use));
        }
        QCOMPARE(watch(camera_, at_least(3)).why, std::string());
    }

    void slow_frames_are_waited_for() {
        // Three in four frames are lost by chance: sixteen pauses are shorter than this once in a hundred thousand times.
        constexpr int pauses = 16;
        constexpr double least_s = 1.5 * pauses / rate;
        const vm::VideoNode fault(node);
        QVERIFY(fault.set("Percentage of Dropped Buffers", 75));
        const Seen seen = watch(camera_, at_least(pauses + 1));
        QVERIFY(fault.set("Percentage of Dropped Buffers", 0));
        QCOMPARE(seen.why, std::string());
        QVERIFY2(seconds_of(seen) > least_s, qPrintable(QString::number(seconds_of(seen))));
    }

    void a_camera_that_falls_silent_is_said() {
        const vm::VideoNode fault(node);
        const Seen seen = watch(camera_, [&](const Seen& so_far) {
            if (so_far.frames.size() == 3)
                fault.set("Percentage of Dropped Buffers", 100);
            return false;
        });
        QVERIFY(fault.set("Percentage of Dropped Buffers", 0));
        QVERIFY(seen.frames.size() >= 3);
        QCOMPARE(seen.why, sentence_of(CameraTrouble::silent));
    }

    void a_cable_pulled_out_is_said_and_works_when_it_is_back() {
        {
            const vm::VideoNode cable(node); // it is out until everybody has closed it
            const Seen seen = watch(camera_, [&](const Seen& so_far) {
                if (so_far.frames.size() == 3)
                    cable.set("Disconnect", 1);
                return false;
            });
            QVERIFY(seen.frames.size() >= 3);
            QCOMPARE(seen.why, sentence_of(CameraTrouble::unplugged));
        }
        QCOMPARE(watch(camera_, at_least(3)).why, std::string());
    }
};

int main(int argc, char** argv) {
    use_steady_media_backend();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("QTEST_FUNCTION_TIMEOUT", "100000000"); // ms
    QGuiApplication app(argc, argv);
    CameraVmTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "camera_test.moc"
