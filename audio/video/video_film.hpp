// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "audio/video/film_stream.hpp"
#include "core/base/result.hpp"

#include <memory>
#include <optional>

namespace tp {

/// The pictures of a video: MP4, QuickTime or 3GP, as cameras and telephones write them (H.264, HEVC, MPEG-4, Motion JPEG).
/// Colours of more than 8 bit, or of more places than every other one, are made to fit.
class VideoFilm final : public FilmStream {
public:
    /// An error is the end of a sentence, such as "it has no pictures.".
    static Result<VideoFilm> open(std::unique_ptr<ByteSource> video);
    VideoFilm(VideoFilm&&) noexcept;
    VideoFilm& operator=(VideoFilm&&) = delete;
    ~VideoFilm() override;

    /// What is damaged within is left out.
    std::optional<FilmPicture> next(double from_s) override;

private:
    struct Impl;
    explicit VideoFilm(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

} // namespace tp
