// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/camera/camera.hpp"
#include "app/capture/frames/simulated_camera.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace tp {

/// How the simulated camera is held at a desk: before a photograph whose one face is about as large as life, and beside it at
/// first, so that there is something to be told.
SimulatedHold hold_before(const cv::Mat& photo);

/// A camera for tests and for trying at a desk: a photograph in a simulated hand, a folder of frames, or a video, in
/// real time.
class StandInCamera final : public Camera {
public:
    enum class Of { photo, folder, video };
    StandInCamera(Of of, std::filesystem::path path);
    ~StandInCamera() override;

    Result<std::unique_ptr<FrameSource>> open(CameraSide side) override;
    void close() override;
    bool move_by(const HeldPose& way) override;
    bool moved_by_keys() const override { return of_ == Of::photo; }

private:
    class Hand;
    class Frames;

    Of of_;
    std::filesystem::path path_;
    std::shared_ptr<Hand> hand_; ///< while it is on
};

/// "simulated:PHOTO", "folder:DIR", "video:FILE", or empty for this machine's own; none for anything else.
std::unique_ptr<Camera> camera_named(const std::string& wish);

} // namespace tp
