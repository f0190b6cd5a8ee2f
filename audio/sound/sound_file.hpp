// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_reader.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tp {

/// A recording being read for playing. One thread at a time.
class SoundFile {
public:
    /// An error is a whole sentence with the file's name.
    static Result<SoundFile> open(const std::filesystem::path& file);

    int rate() const { return reader_.format().rate; }
    /// Of what `read` gives: 1 or 2. A file with more is mixed to one.
    int channels() const { return reader_.format().channels == 2 ? 2 : 1; }
    double duration_s() const { return static_cast<double>(reader_.frames()) / rate(); }

    /// Goes to a place, or to the end where it lies behind that; false where the file does not let itself be
    /// wound.
    bool wind_to(double position_s);
    /// The next frames, at most `most`, interleaved, ±1; empty at the end or where the rest is damaged.
    const std::vector<float>& read(std::size_t most);

private:
    explicit SoundFile(SoundReader reader) : reader_(std::move(reader)) {}

    SoundReader reader_;
    std::vector<std::int32_t> raw_;
    std::vector<float> block_;
};

} // namespace tp
