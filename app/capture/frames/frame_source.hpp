// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/held_camera.hpp"
#include "core/base/result.hpp"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace tp {

/// One picture of a camera.
struct CameraFrame {
    cv::Mat pixels;      ///< 8-bit BGR, upright; the receiver may keep it
    double time_s = 0.0; ///< when it was taken, of the camera's clock
    /// What the camera knows of its own place, degrees: looking up, and turned clockwise. Where nothing measures it, none.
    std::optional<double> elevation_deg;
    std::optional<double> roll_deg;
};

/// Whatever gives frames: a camera, a folder of frames, a photograph in a simulated hand. One thread, but for `interrupt`.
class FrameSource {
public:
    virtual ~FrameSource() = default;
    /// The next frame; none where there is no more (a folder's end). An error, in one sentence, where there should be one.
    /// A camera may wait for it.
    virtual Result<std::optional<CameraFrame>> next() = 0;
    /// How the camera lies in the hand.
    virtual HeldCamera held() const = 0;
    /// From any thread: a `next` that waits ends at once, with anything; so does each later one. Nothing to do for whoever
    /// never waits.
    virtual void interrupt() {}
};

} // namespace tp
