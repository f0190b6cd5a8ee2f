// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"
#include "app/capture/shutter/burst_order.hpp"
#include "app/capture/shutter/photograph_file.hpp"
#include "core/aiming/held_camera.hpp"
#include "core/base/result.hpp"
#include "faces/extract/quick_faces.hpp"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <vector>

namespace tp {

/// The frames round a shutter, of which one is kept. Pictures are as a photograph shows them: a mirrored camera's are turned back.
class Burst {
public:
    static constexpr std::size_t most_frames = 8;

    /// Of more than `most_frames` those nearest to `shutter_s`, of the frames' clock; in the order of time.
    Burst(std::vector<CameraFrame> frames, HeldCamera held, double shutter_s);

    std::size_t size() const { return frames_.size(); }
    const CameraFrame& frame(std::size_t number) const { return frames_[number]; }
    /// 8-bit BGR, as it is kept.
    cv::Mat picture(std::size_t number) const;
    /// The same as the JPEG that it becomes where it is kept.
    Result<CodedPicture> coded(std::size_t number) const;
    /// The same burst with all of it as those JPEGs, in a tenth of the memory: nothing is lost that keeping would not lose. Itself
    /// where they cannot be made. About a tenth of a second a frame of 12 megapixel. It is chosen from before.
    Burst packed() const;
    /// The frame that was there when the shutter acted.
    std::size_t wished() const { return wished_; }

    /// Looks at all of them; takes some ten ms a frame. Never throws: a frame that cannot be looked at is as one that shows nobody.
    BurstOrder choose(QuickFaces& faces) const;

private:
    std::vector<CameraFrame> frames_;
    HeldCamera held_;
    std::size_t wished_ = 0;
    std::vector<CodedPicture> coded_; ///< of all frames, which have no pixels then; or of none
};

/// What there is to see on one frame of it.
BurstLook burst_look(const cv::Mat& picture, QuickFaces& faces);

} // namespace tp
