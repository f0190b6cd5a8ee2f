// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/newest_frame.hpp"

#include <utility>

namespace tp {

void NewestFrame::put(const QVideoFrame& frame, double time_s) {
    {
        const std::lock_guard lock(mutex_);
        newest_ = Taken{frame, time_s};
    }
    came_.notify_one();
}

void NewestFrame::fail(CameraTrouble trouble) {
    {
        const std::lock_guard lock(mutex_);
        if (!ended_ && !trouble_)
            trouble_ = trouble;
    }
    came_.notify_one();
}

void NewestFrame::end() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    came_.notify_one();
}

NewestFrame::Came NewestFrame::take(Taken& taken, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    came_.wait_for(lock, patience, [this] { return newest_ || trouble_ || ended_; });
    if (ended_)
        return Came::end;
    if (trouble_)
        return Came::trouble;
    if (!newest_)
        return Came::nothing;
    taken = *std::exchange(newest_, {});
    return Came::frame;
}

CameraTrouble NewestFrame::trouble() const {
    const std::lock_guard lock(mutex_);
    return trouble_.value_or(CameraTrouble::silent);
}

} // namespace tp
