// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"
#include "app/capture/seeing/frame_motion.hpp"
#include "app/capture/seeing/frame_sharpness.hpp"
#include "core/aiming/aim_frame.hpp"
#include "core/aiming/held_camera.hpp"
#include "faces/base/face.hpp"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace tp {

/// Whose face this is, where it is known; `face` as QuickFaces::face_at, in pixels of the frame. May take its time: one face is
/// asked for at a time, and not at every frame.
using FaceName = std::function<std::string(const cv::Mat& frame, const Face& face)>;

/// From a frame of the camera to what `core/aiming` asks of it, with nets of its own. One thread; never throws.
class AimEye {
public:
    explicit AimEye(HeldCamera held = {});
    AimEye(AimEye&&) noexcept;
    AimEye& operator=(AimEye&&) noexcept;
    ~AimEye();

    void hold(HeldCamera held);
    void name_by(FaceName name_of);

    /// What cannot be seen is left out; a frame without pixels has only a time.
    AimFrame see(const CameraFrame& frame);

    static constexpr int small_px = 320;        ///< longer side of what the detector sees
    static constexpr int smallest_px = 160;     ///< longer side of what motion and light are told from
    static constexpr double eyes_from_px = 80;  ///< of a face in the frame, from where on shut eyes are told
    static constexpr double eyes_every_s = 0.3; ///< and how often: it takes as long as all the rest
    static constexpr double name_every_s = 1.0; ///< one face is asked for its name

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace tp
