// SPDX-License-Identifier: Apache-2.0
#include "app/capture/seeing/camera_watch.hpp"

#include <utility>

namespace tp {

CameraWatch::CameraWatch(std::unique_ptr<FrameSource> source, FrameLook look, CameraTold told,
                         std::size_t held)
    : source_(std::move(source)), look_(std::move(look)), told_(std::move(told)), held_(source_->held()),
      most_held_(held) {
    pulling_ = std::thread([this] { pull(); });
    watching_ = std::thread([this] { watch(); });
}

CameraWatch::~CameraWatch() { stop(); }

void CameraWatch::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
    }
    changed_.notify_all();
    source_->interrupt();
    for (std::thread* const thread : {&pulling_, &watching_})
        if (thread->joinable())
            thread->join();
}

std::vector<CameraFrame> CameraWatch::last_frames() const {
    const std::lock_guard lock(mutex_);
    return {last_.begin(), last_.end()};
}

void CameraWatch::pull() {
    int failures = 0;
    while (true) {
        auto next = source_->next();
        if (!next) {
            if (++failures == most_failures)
                return end(next.error());
            continue;
        }
        failures = 0;
        if (!*next)
            return end({});
        if (!keep(std::move(**next)))
            return;
    }
}

bool CameraWatch::keep(CameraFrame frame) {
    {
        const std::lock_guard lock(mutex_);
        if (stopped_)
            return false;
        last_.push_back(frame);
        if (last_.size() > most_held_)
            last_.pop_front();
        newest_ = std::move(frame);
    }
    changed_.notify_all();
    return true;
}

void CameraWatch::end(std::string why) {
    {
        const std::lock_guard lock(mutex_);
        ended_ = std::move(why);
    }
    changed_.notify_all();
}

void CameraWatch::watch() {
    while (true) {
        std::optional<CameraFrame> frame;
        std::optional<std::string> ended;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return stopped_ || newest_ || ended_; });
            if (stopped_)
                return;
            frame = std::exchange(newest_, std::nullopt);
            if (!frame)
                ended = ended_;
        }
        if (!frame) {
            told_.ended(*ended);
            return;
        }
        const AimFrame seen = look_(*frame);
        {
            const std::lock_guard lock(mutex_);
            if (stopped_)
                return;
        }
        told_.seen(seen, *frame);
    }
}

} // namespace tp
