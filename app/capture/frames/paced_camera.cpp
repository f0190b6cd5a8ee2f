// SPDX-License-Identifier: Apache-2.0
#include "app/capture/frames/paced_camera.hpp"

#include <utility>

namespace tp {

Result<std::optional<CameraFrame>> PacedCamera::next() {
    auto frame = source_->next();
    if (!frame || !*frame)
        return frame;
    const auto taken =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>((*frame)->time_s));
    if (!begin_)
        begin_ = Clock::now() - taken;
    std::unique_lock lock(mutex_);
    wakes_.wait_until(lock, *begin_ + taken, [this] { return interrupted_; });
    return frame;
}

void PacedCamera::interrupt() {
    {
        const std::lock_guard lock(mutex_);
        interrupted_ = true;
    }
    wakes_.notify_all();
    source_->interrupt();
}

} // namespace tp
