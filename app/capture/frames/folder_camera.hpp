// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/frames/frame_source.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace tp {

/// The pictures of a folder as frames, in the order of their names, `frames_per_s` of its own clock.
class FolderCamera final : public FrameSource {
public:
    /// An error where the folder cannot be read. `frames_per_s` > 0. What is no picture by its name (`.jpg`, `.jpeg`, `.png`,
    /// `.webp`, `.bmp`) is passed over.
    static Result<FolderCamera> open(const std::filesystem::path& folder, double frames_per_s,
                                     HeldCamera held = {});

    /// A picture that cannot be read is an error; the call after it goes on with the next one.
    Result<std::optional<CameraFrame>> next() override;
    HeldCamera held() const override { return held_; }
    std::size_t frame_count() const { return files_.size(); }

private:
    FolderCamera(std::vector<std::filesystem::path> files, double frames_per_s, HeldCamera held);

    std::vector<std::filesystem::path> files_;
    double frames_per_s_;
    HeldCamera held_;
    std::size_t at_ = 0;
};

} // namespace tp
