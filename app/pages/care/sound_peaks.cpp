// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/sound_peaks.hpp"

#include "audio/recordings/sound_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tp {

namespace {

constexpr std::size_t frames_at_a_time = 1 << 15;

/// The largest sample of each `frames` frames.
class FinePeaks {
public:
    FinePeaks(std::size_t channels, std::uint64_t frames) : channels_(channels), frames_(frames) {}

    void add(const std::vector<std::int32_t>& samples, std::size_t frames) {
        for (std::size_t i = 0; i < frames; ++i) {
            for (std::size_t c = 0; c < channels_; ++c)
                largest_ = std::max(largest_, std::abs(static_cast<float>(samples[i * channels_ + c]) / 2147483648.0F));
            if (++in_part_ == frames_)
                end_part();
        }
    }
    std::vector<float> take() {
        if (in_part_ > 0)
            end_part();
        return std::move(peaks_);
    }

private:
    void end_part() {
        peaks_.push_back(std::min(largest_, 1.0F));
        largest_ = 0.0F;
        in_part_ = 0;
    }
    std::size_t channels_;
    std::uint64_t frames_;
    std::uint64_t in_part_ = 0;
    float largest_ = 0.0F;
    std::vector<float> peaks_;
};

/// As many as asked for, each the largest of those that it stands for.
std::vector<float> gathered(const std::vector<float>& fine, std::size_t count) {
    if (fine.size() <= count)
        return fine;
    std::vector<float> result(count, 0.0F);
    for (std::size_t i = 0; i < fine.size(); ++i) {
        float& peak = result[i * count / fine.size()];
        peak = std::max(peak, fine[i]);
    }
    return result;
}

} // namespace

Result<SoundPeaks> sound_peaks(const std::filesystem::path& file, std::size_t count, const std::stop_token& stop) {
    auto reader = SoundReader::open(file);
    if (!reader)
        return Error{reader.error()};
    const auto channels = static_cast<std::size_t>(reader->format().channels);
    // Finer than asked for: how many frames there are is only known at the end (a damaged file has fewer than it claims).
    FinePeaks fine(channels, std::max<std::uint64_t>(1, reader->frames() / (16 * count)));
    std::vector<std::int32_t> block(frames_at_a_time * channels);
    std::uint64_t frames = 0;
    while (const std::size_t got = reader->read(block)) {
        if (stop.stop_requested())
            return Error{};
        fine.add(block, got);
        frames += got;
    }
    return SoundPeaks{gathered(fine.take(), count), static_cast<double>(frames) / reader->format().rate};
}

} // namespace tp
