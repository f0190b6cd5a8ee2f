// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_camera.hpp"

#include <QTest>

#include <opencv2/core/mat.hpp>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the test's camera gives, from the test to the thread that pulls. A frame's pixels say nothing; what is seen on it goes
/// beside it.
class Film {
public:
    void show(tp::AimFrame seen) { put(std::move(seen)); }
    void fail(const std::string& why) {
        const std::lock_guard lock(mutex_);
        why_ = why;
        came_.notify_all();
    }
    void end() {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        came_.notify_all();
    }
    tp::Result<std::optional<tp::CameraFrame>> next() {
        std::unique_lock lock(mutex_);
        came_.wait(lock, [this] { return given_ < shown_.size() || ended_ || !why_.empty(); });
        if (ended_)
            return std::optional<tp::CameraFrame>();
        if (!why_.empty())
            return tp::Error{why_};
        tp::CameraFrame frame;
        frame.pixels = cv::Mat(36, 64, CV_8UC3, cv::Scalar(90, 120, 150));
        frame.time_s = shown_[given_++].time_s;
        return std::optional(std::move(frame));
    }
    tp::AimFrame seen_on(const tp::CameraFrame& frame) {
        const std::lock_guard lock(mutex_);
        for (const tp::AimFrame& seen : shown_)
            if (seen.time_s == frame.time_s)
                return seen;
        return {};
    }

private:
    void put(tp::AimFrame seen) {
        const std::lock_guard lock(mutex_);
        shown_.push_back(std::move(seen));
        came_.notify_all();
    }
    std::mutex mutex_;
    std::condition_variable came_;
    std::deque<tp::AimFrame> shown_;
    std::size_t given_ = 0;
    std::string why_;
    bool ended_ = false;
};

class FilmSource final : public tp::FrameSource {
public:
    FilmSource(std::shared_ptr<Film> film, tp::HeldCamera held) : film_(std::move(film)), held_(held) {}
    tp::Result<std::optional<tp::CameraFrame>> next() override { return film_->next(); }
    tp::HeldCamera held() const override { return held_; }
    void interrupt() override { film_->end(); }

private:
    std::shared_ptr<Film> film_;
    tp::HeldCamera held_;
};

class FakeCamera final : public tp::Camera {
public:
    tp::Result<std::unique_ptr<tp::FrameSource>> open(tp::CameraSide side) override {
        if (!why_not.empty())
            return tp::Error{why_not};
        on = true;
        ++opened;
        film = std::make_shared<Film>();
        const bool front = side == tp::CameraSide::front && !only_back;
        return std::unique_ptr<tp::FrameSource>(
            std::make_unique<FilmSource>(film, tp::HeldCamera{front, false}));
    }
    void close() override { on = false; }
    bool has_both() const override { return both; }
    bool has_torch() const override { return torch; }
    void light(bool wanted) override { lit = wanted; }
    bool move_by(const tp::HeldPose& way) override {
        moved.pan_deg += way.pan_deg;
        moved.tilt_deg += way.tilt_deg;
        moved.roll_deg += way.roll_deg;
        moved.forward_m += way.forward_m;
        return movable;
    }
    bool moved_by_keys() const override { return movable; }

    /// What is seen on its frames.
    tp::CaptureCamera::MakeLook look() {
        return [this] { return [this](const tp::CameraFrame& frame) { return film->seen_on(frame); }; };
    }
    /// A frame, until the page has seen it.
    void show(tp::CaptureCamera& page, const tp::AimFrame& frame) {
        int heard = 0;
        const auto counts = QObject::connect(&page, &tp::CaptureCamera::seen, &page, [&] { ++heard; });
        film->show(frame);
        QTRY_COMPARE(heard, 1);
        QObject::disconnect(counts);
    }

    std::string why_not;
    bool on = false, both = false, only_back = false, torch = false, lit = false, movable = false;
    int opened = 0;
    tp::HeldPose moved;
    std::shared_ptr<Film> film = std::make_shared<Film>(); ///< of the camera that was opened last
};
