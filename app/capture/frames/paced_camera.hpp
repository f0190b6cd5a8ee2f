// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

namespace tp {

/// Frames of another source at the pace of their own clock, as a camera would give them: for a folder or a simulated camera that a
/// person uses. A frame that was asked for too late comes at once.
class PacedCamera final : public FrameSource {
public:
    explicit PacedCamera(std::unique_ptr<FrameSource> source) : source_(std::move(source)) {}

    Result<std::optional<CameraFrame>> next() override;
    HeldCamera held() const override { return source_->held(); }
    void interrupt() override;

private:
    using Clock = std::chrono::steady_clock;

    std::unique_ptr<FrameSource> source_;
    std::optional<Clock::time_point> begin_; ///< when the frames' clock was 0
    std::mutex mutex_;
    std::condition_variable wakes_;
    bool interrupted_ = false;
};

} // namespace tp
