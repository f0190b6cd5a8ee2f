// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/flac_file.hpp"
#include "audio/recordings/sound_reader.hpp"

#include <QProcess>
#include <QStandardPaths>
#include <QString>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp::test {

/// Samples in which none can be taken for another.
inline std::vector<std::int16_t> noise(std::size_t samples, std::uint32_t seed = 1) {
    std::mt19937 random(seed);
    std::vector<std::int16_t> result(samples);
    for (std::int16_t& sample : result)
        sample = static_cast<std::int16_t>(random());
    return result;
}

/// A tone of `peak` (1: full scale), its samples 32 bit wide.
inline std::vector<std::int32_t> tone(double peak, double seconds, double hertz = 997.0, int rate = 48'000) {
    std::vector<std::int32_t> result(static_cast<std::size_t>(seconds * rate));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<std::int32_t>(std::lround(
            peak * 2147483647.0 * std::sin(2.0 * std::numbers::pi * hertz * static_cast<double>(i) / rate)));
    return result;
}

/// Samples of 16 bit, 32 bit wide.
inline std::vector<std::int32_t> widened(std::span<const std::int16_t> samples) {
    std::vector<std::int32_t> result;
    for (const std::int16_t sample : samples)
        result.push_back(sample * 65'536);
    return result;
}

/// A sound in memory.
class MemorySound : public SoundStream {
public:
    MemorySound(std::vector<std::int32_t> samples, SoundFormat format,
                SampleDepth depth = SampleDepth::bits_16)
        : samples_(std::move(samples)), format_(format), depth_(depth) {}

    SoundFormat format() const override { return format_; }
    SampleDepth depth() const override { return depth_; }
    std::uint64_t frames() const override {
        return samples_.size() / static_cast<std::size_t>(format_.channels);
    }
    std::size_t read(std::span<std::int32_t> to) override {
        const auto channels = static_cast<std::size_t>(format_.channels);
        const std::size_t count = std::min(to.size() / channels * channels, samples_.size() - next_);
        std::copy_n(samples_.begin() + static_cast<std::ptrdiff_t>(next_), count, to.begin());
        next_ += count;
        return count / channels;
    }

private:
    std::vector<std::int32_t> samples_;
    SoundFormat format_;
    SampleDepth depth_;
    std::size_t next_ = 0;
};

/// All samples of a sound file, 32 bit wide; none where it cannot be read.
inline std::vector<std::int32_t> samples_of(const std::filesystem::path& file) {
    std::vector<std::int32_t> all;
    auto reader = SoundReader::open(file);
    if (!reader)
        return all;
    std::vector<std::int32_t> block(sound_block);
    while (const std::size_t frames = reader->read(block))
        all.insert(all.end(), block.begin(),
                   block.begin() + static_cast<std::ptrdiff_t>(
                                       frames * static_cast<std::size_t>(reader->format().channels)));
    return all;
}

inline std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_bytes(const std::filesystem::path& file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// The names in a folder, sorted and joined by blanks.
inline std::string names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    std::string result;
    for (const std::string& name : names)
        (result += result.empty() ? "" : " ") += name;
    return result;
}

inline bool has_program(const char* name) {
    return !QStandardPaths::findExecutable(QString::fromUtf8(name)).isEmpty();
}

struct Ran {
    int status = -1;
    std::string output; ///< both streams
};
inline Ran run(const char* program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QString::fromUtf8(program), arguments);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), process.readAll().toStdString()};
}

} // namespace tp::test
