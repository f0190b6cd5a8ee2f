// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/sound_file.hpp"

#include "core/files/file_words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {
constexpr float full_scale = 2147483648.0F; // SoundStream's
} // namespace

Result<SoundFile> SoundFile::open(const std::filesystem::path& file) {
    Result<SoundReader> reader = SoundReader::open(file);
    if (!reader)
        return Error{"The recording " + quoted(file.filename()) + " cannot be played: " + reader.error()};
    return SoundFile(std::move(reader).value());
}

bool SoundFile::wind_to(double position_s) {
    const double frame = std::max(0.0, std::round(position_s * rate()));
    return reader_.seek(std::min(static_cast<std::uint64_t>(frame), reader_.frames()));
}

const std::vector<float>& SoundFile::read(std::size_t most) {
    const auto width = static_cast<std::size_t>(reader_.format().channels);
    const std::size_t mixed = width > 2 ? width : 1; // so many samples of the file make one
    raw_.resize(most * width);
    const std::size_t frames = reader_.read(raw_);
    block_.resize(frames * width / mixed);
    for (std::size_t i = 0; i < block_.size(); ++i) {
        float sum = 0.0F;
        for (std::size_t channel = 0; channel < mixed; ++channel)
            sum += static_cast<float>(raw_[i * mixed + channel]);
        block_[i] = sum / full_scale / static_cast<float>(mixed);
    }
    return block_;
}

} // namespace tp
