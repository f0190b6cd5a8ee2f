// SPDX-License-Identifier: Apache-2.0
// A camera is watched on threads: the newest frame is looked at, and it ends when it is to end.
#include "app/capture/seeing/camera_watch.hpp"

#include <QTest>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace tp;

namespace {

/// A camera whose frames come when the test says so.
class MadeCamera final : public FrameSource {
public:
    using Next = Result<std::optional<CameraFrame>>;

    Next next() override {
        std::unique_lock lock(mutex_);
        ++asked_;
        changed_.notify_all();
        changed_.wait(lock, [this] { return interrupted_ || !coming_.empty(); });
        if (coming_.empty())
            return Next(std::optional<CameraFrame>());
        Next next = std::move(coming_.front());
        coming_.pop_front();
        return next;
    }
    HeldCamera held() const override { return {true, false}; }
    void interrupt() override {
        const std::lock_guard lock(mutex_);
        interrupted_ = true;
        changed_.notify_all();
    }

    bool interrupted() {
        const std::lock_guard lock(mutex_);
        return interrupted_;
    }

    void give(Next next) {
        const std::lock_guard lock(mutex_);
        coming_.push_back(std::move(next));
        changed_.notify_all();
    }
    void give_frame(double time_s) {
        CameraFrame frame;
        frame.time_s = time_s;
        give(std::optional(std::move(frame)));
    }
    /// All that was given has been taken, and the next is asked for.
    void wait_until_asked(int times) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this, times] { return asked_ >= times; });
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Next> coming_;
    int asked_ = 0;
    bool interrupted_ = false;
};

/// A look that takes as long as the test wants, and what was told.
class Log {
public:
    AimFrame look(const CameraFrame& frame) {
        std::unique_lock lock(mutex_);
        looked_.push_back(frame.time_s);
        changed_.notify_all();
        changed_.wait(lock, [this] { return may_look_ > 0; });
        --may_look_;
        AimFrame seen;
        seen.time_s = frame.time_s;
        return seen;
    }
    CameraTold told() {
        return {[this](const AimFrame& seen, const CameraFrame& frame) {
                    const std::lock_guard lock(mutex_);
                    if (seen.time_s == frame.time_s)
                        told_.push_back(seen.time_s);
                    changed_.notify_all();
                },
                [this](const std::string& why) {
                    const std::lock_guard lock(mutex_);
                    ended_.push_back(why);
                    changed_.notify_all();
                }};
    }
    void let_look(int times) {
        const std::lock_guard lock(mutex_);
        may_look_ += times;
        changed_.notify_all();
    }
    void wait_until_looked(std::size_t times) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this, times] { return looked_.size() >= times; });
    }
    void wait_until_ended() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !ended_.empty(); });
    }
    std::vector<double> told_times() {
        const std::lock_guard lock(mutex_);
        return told_;
    }
    std::vector<std::string> endings() {
        const std::lock_guard lock(mutex_);
        return ended_;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<double> looked_, told_;
    std::vector<std::string> ended_;
    int may_look_ = 0;
};

struct Watched {
    Log log;
    MadeCamera* camera = nullptr; ///< the watch's
    std::unique_ptr<CameraWatch> watch;

    explicit Watched(std::size_t held = CameraWatch::usually_held) {
        auto made = std::make_unique<MadeCamera>();
        camera = made.get();
        watch = std::make_unique<CameraWatch>(
            std::move(made), [this](const CameraFrame& frame) { return log.look(frame); }, log.told(), held);
    }
};

std::vector<double> times_of(const std::vector<CameraFrame>& frames) {
    std::vector<double> times;
    for (const CameraFrame& frame : frames)
        times.push_back(frame.time_s);
    return times;
}

} // namespace

class CameraWatchTest : public QObject {
    Q_OBJECT
private slots:
    void what_comes_during_a_look_is_dropped_but_for_the_newest() {
        Watched it;
        it.camera->give_frame(1.0);
        it.log.wait_until_looked(1);
        for (int i = 2; i <= 5; ++i)
            it.camera->give_frame(i);
        it.camera->wait_until_asked(6); // all of them were pulled although the look goes on
        it.log.let_look(2);
        it.log.wait_until_looked(2);
        it.camera->give(std::optional<CameraFrame>());
        it.log.wait_until_ended();
        QCOMPARE(it.log.told_times(), (std::vector<double>{1.0, 5.0}));
        QVERIFY(it.watch->held().front);
    }

    void the_last_frames_are_held() {
        Watched it(3);
        it.log.let_look(100);
        for (int i = 1; i <= 5; ++i)
            it.camera->give_frame(i);
        it.camera->wait_until_asked(6);
        QCOMPARE(times_of(it.watch->last_frames()), (std::vector<double>{3.0, 4.0, 5.0}));
        it.camera->give(std::optional<CameraFrame>());
        it.log.wait_until_ended();
        QCOMPARE(it.watch->last_frames().size(), std::size_t{3});
    }

    void an_end_is_told_once_and_after_the_last_frame() {
        Watched it;
        it.log.let_look(100);
        it.camera->give_frame(1.0);
        it.camera->give(std::optional<CameraFrame>());
        it.log.wait_until_ended();
        it.watch->stop();
        QCOMPARE(it.log.endings(), std::vector<std::string>{std::string()});
        QCOMPARE(it.log.told_times(), std::vector<double>{1.0});
    }

    void one_bad_frame_is_passed_over_and_a_camera_that_fails_says_why() {
        Watched it;
        it.log.let_look(100);
        it.camera->give(Error{"One cannot be read."});
        it.camera->give(Error{"Two cannot be read."});
        it.camera->give_frame(1.0);
        it.log.wait_until_looked(1);
        for (int i = 0; i < CameraWatch::most_failures; ++i)
            it.camera->give(Error{"The camera was unplugged."});
        it.log.wait_until_ended();
        QCOMPARE(it.log.endings(), std::vector<std::string>{"The camera was unplugged."});
        QCOMPARE(it.log.told_times(), std::vector<double>{1.0});
    }

    void it_stops_while_the_camera_waits_and_says_nothing_more() {
        Watched it;
        it.camera->wait_until_asked(1);
        it.watch->stop();
        it.watch->stop();
        QVERIFY(it.log.endings().empty());
        QVERIFY(it.watch->last_frames().empty());
    }

    void a_look_under_way_is_not_told_after_the_stop() {
        Watched it;
        it.camera->give_frame(1.0);
        it.log.wait_until_looked(1);
        std::thread stopping([&] { it.watch->stop(); });
        it.camera->wait_until_asked(2);
        // The stop is under way once the interrupted camera gives its end; the look may then go on.
        while (!it.camera->interrupted())
            std::this_thread::yield();
        it.log.let_look(1);
        stopping.join();
        QVERIFY(it.log.told_times().empty() && it.log.endings().empty());
    }
};

QTEST_APPLESS_MAIN(CameraWatchTest)
#include "camera_watch_test.moc"
