// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"
#include "audio/video/film_stream.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace tp {

/// The pictures of a video as frames, at its own times, at most some sixteen a second. At its end it begins again, and the clock
/// of the frames runs on.
class VideoCamera final : public FrameSource {
public:
    /// An error, in one sentence, where the video cannot be played.
    static Result<VideoCamera> open(const std::filesystem::path& file, HeldCamera held = {});

    Result<std::optional<CameraFrame>> next() override;
    HeldCamera held() const override { return held_; }

private:
    VideoCamera(std::filesystem::path file, HeldCamera held) : file_(std::move(file)), held_(held) {}
    std::string begin();

    std::filesystem::path file_;
    HeldCamera held_;
    std::unique_ptr<FilmStream> film_;
    std::optional<double> last_s_; ///< of the video's clock, in this round
    double round_s_ = 0.0;         ///< when this round began, of the frames' clock
};

} // namespace tp
