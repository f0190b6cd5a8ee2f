// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/sound_stream.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace tp {

/// A sound file through libsndfile: WAV, W64, AIFF, CAF, AU, FLAC, Ogg (Vorbis, Opus, FLAC), MP3.
class SoundReader : public SoundStream {
public:
    /// An error is the end of a sentence. Refused are files that claim more than eight channels, a sample
    /// rate of which no sound is, no frame at all, or more than `longest_recording_s`.
    static Result<SoundReader> open(const std::filesystem::path& file);
    static Result<SoundReader> open(std::unique_ptr<ByteSource> bytes);
    SoundReader(SoundReader&&) noexcept;
    SoundReader& operator=(SoundReader&&) = delete;
    ~SoundReader() override;

    SoundFormat format() const override;
    /// The depth that loses nothing of integer samples up to 24 bit. Samples of 32 bit and floating point
    /// have 24, rounded; what was compressed with loss has 16.
    SampleDepth depth() const override;
    /// As the file claims; a damaged one has less, and MP3 only estimates.
    std::uint64_t frames() const override;
    std::size_t read(std::span<std::int32_t> to) override;

    /// Whether `frames` is more than an estimate.
    bool exact_length() const;
    /// Goes on with this frame; false where the file cannot.
    bool seek(std::uint64_t frame);
    /// Whether reading met a fault other than the file's end.
    bool failed() const;
    /// The system's number of the first fault that the disk reported; 0: none.
    int fault() const;
    /// What libsndfile knows of the speaker (artist) and the date; empty: nothing.
    std::string artist() const;
    std::string date() const;

private:
    struct Impl;
    explicit SoundReader(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

} // namespace tp
