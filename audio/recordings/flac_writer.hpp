// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_stream.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace tp {

/// Writes a FLAC file through libsndfile, without comments. Where something fails, the reason is the
/// system's.
class FlacWriter {
public:
    /// Writes over `file`, which exists. An error is the end of a sentence.
    static Result<FlacWriter> over(const std::filesystem::path& file, const SoundFormat& format,
                                   SampleDepth depth);
    FlacWriter(FlacWriter&&) noexcept;
    FlacWriter& operator=(FlacWriter&&) = delete;
    ~FlacWriter();

    /// Whole frames as in `SoundStream::read`; the reason why not, else empty.
    std::string write(std::span<const std::int32_t> samples);
    /// Writes what is still held back; then the file is whole, though not yet on the disk. The reason why
    /// not, else empty.
    std::string finish();

private:
    struct Impl;
    explicit FlacWriter(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

} // namespace tp
