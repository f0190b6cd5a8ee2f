// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"
#include "app/capture/frames/photo_view.hpp"
#include "core/handheld/hand_tremor.hpp"

#include <cstdint>
#include <filesystem>

namespace tp {

/// How the simulated camera looks into a photograph.
struct SimulatedHold {
    HeldPose start; ///< relative to the wall's `aim`
    PhotoWall wall;
    CameraOptics optics;
    FrameTaking taking;
    TremorManner tremor;
    double frames_per_s = 15.0; ///< > 0
    std::uint64_t seed = 1;
    HeldCamera held; ///< `mirrored`: the frames are
};

/// A camera without a camera: a hand holds it before a photograph, trembles, and goes where it is told. Its clock runs with its
/// frames; the same seed and the same moves give the same bytes.
class SimulatedCamera final : public FrameSource {
public:
    /// An error, in one sentence, where the photograph cannot be read.
    static Result<SimulatedCamera> open(const std::filesystem::path& photo, const SimulatedHold& hold);
    SimulatedCamera(cv::Mat photo, const SimulatedHold& hold);

    /// Always a frame.
    Result<std::optional<CameraFrame>> next() override;
    HeldCamera held() const override { return hold_.held; }

    /// Where the hand holds it from now on, without its tremor.
    void move_to(const HeldPose& pose) { wished_ = pose; }
    void expose(double factor) { hold_.taking.exposure = factor; }
    const HeldPose& pose() const { return wished_; }

private:
    cv::Mat photo_;
    SimulatedHold hold_;
    HandTremor tremor_;
    HeldPose wished_;
    HeldPose last_;
    std::uint64_t taken_ = 0;
};

} // namespace tp
