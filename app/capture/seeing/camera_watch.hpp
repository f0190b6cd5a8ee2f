// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"
#include "core/aiming/aim_frame.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tp {

/// From a frame to what is seen on it; `AimEye::see`, mostly.
using FrameLook = std::function<AimFrame(const CameraFrame&)>;

/// Whom a watch tells, on its own threads; whoever has a thread of their own posts it there.
struct CameraTold {
    /// The newest frame was looked at.
    std::function<void(const AimFrame& seen, const CameraFrame& frame)> seen;
    /// No more frames come; told once, and not after `stop`. Empty: the source has ended. Otherwise why, in one sentence.
    std::function<void(const std::string& why)> ended;
};

/// Watches a camera: one thread, "camera", pulls its frames and holds the last ones; another one, "aim eye", always looks at
/// the newest. What comes while it looks is not looked at, so that what is told is never older than one look and one frame.
/// Nothing is written anywhere.
class CameraWatch {
public:
    static constexpr std::size_t usually_held = 8; ///< frames: a burst
    /// A source that fails so often in a row has failed; a picture of a folder that cannot be read is passed over.
    static constexpr int most_failures = 3;

    CameraWatch(std::unique_ptr<FrameSource> source, FrameLook look, CameraTold told,
                std::size_t held = usually_held);
    /// As `stop`.
    ~CameraWatch();
    CameraWatch(const CameraWatch&) = delete;
    CameraWatch& operator=(const CameraWatch&) = delete;

    /// Interrupts the source and waits for the look that is under way. Nothing is told afterwards. Not from `CameraTold`.
    void stop();

    /// The last frames, the oldest first, looked at or not; also after the end.
    std::vector<CameraFrame> last_frames() const;
    /// How the camera lies in the hand.
    HeldCamera held() const { return held_; }

private:
    void pull();
    void watch();
    bool keep(CameraFrame frame); ///< false: it was stopped
    void end(std::string why);

    std::unique_ptr<FrameSource> source_;
    FrameLook look_;
    CameraTold told_;
    HeldCamera held_;
    std::size_t most_held_;

    mutable std::mutex mutex_; ///< guards what follows
    std::condition_variable changed_;
    std::deque<CameraFrame> last_;
    std::optional<CameraFrame> newest_; ///< not looked at yet
    std::optional<std::string> ended_;
    bool stopped_ = false;

    std::thread pulling_;  ///< "camera"
    std::thread watching_; ///< "aim eye"
};

} // namespace tp
