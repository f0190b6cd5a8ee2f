// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/loudness.hpp"

#include "audio/recordings/flac_file.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ebur128.h>
#include <vector>

namespace tp {

double Loudness::gain_db() const {
    if (!integrated_lufs)
        return 0.0;
    return std::min(
        {loudness_target_lufs - *integrated_lufs, highest_true_peak_dbtp - true_peak_dbtp, largest_gain_db});
}

struct LoudnessMeter::Impl {
    ebur128_state* state; ///< null where there is no memory for it; then nothing is measured

    explicit Impl(const SoundFormat& format)
        : state(ebur128_init(static_cast<unsigned>(format.channels), static_cast<unsigned long>(format.rate),
                             EBUR128_MODE_I | EBUR128_MODE_TRUE_PEAK | EBUR128_MODE_HISTOGRAM)) {
        if (state != nullptr && format.channels == 1)
            ebur128_set_channel(state, 0, EBUR128_DUAL_MONO);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (state != nullptr)
            ebur128_destroy(&state);
    }
};

LoudnessMeter::LoudnessMeter(const SoundFormat& format) : impl_(std::make_unique<Impl>(format)) {}
LoudnessMeter::LoudnessMeter(LoudnessMeter&&) noexcept = default;
LoudnessMeter::~LoudnessMeter() = default;

void LoudnessMeter::add(std::span<const std::int16_t> samples) {
    if (impl_->state != nullptr)
        ebur128_add_frames_short(impl_->state, samples.data(), samples.size() / impl_->state->channels);
}

void LoudnessMeter::add(std::span<const std::int32_t> samples) {
    if (impl_->state != nullptr)
        ebur128_add_frames_int(impl_->state, samples.data(), samples.size() / impl_->state->channels);
}

Loudness LoudnessMeter::loudness() const {
    Loudness result;
    if (impl_->state == nullptr)
        return result;
    double lufs = 0.0;
    if (ebur128_loudness_global(impl_->state, &lufs) == EBUR128_SUCCESS && std::isfinite(lufs))
        result.integrated_lufs = lufs;
    double highest = 0.0;
    for (unsigned channel = 0; channel < impl_->state->channels; ++channel) {
        double peak = 0.0;
        if (ebur128_true_peak(impl_->state, channel, &peak) == EBUR128_SUCCESS)
            highest = std::max(highest, peak);
    }
    result.true_peak_dbtp = 20.0 * std::log10(highest);
    return result;
}

Result<Loudness> loudness_of(const std::filesystem::path& file) {
    auto reader = SoundReader::open(file);
    if (!reader)
        return Error{reader.error()};
    LoudnessMeter meter(reader->format());
    std::vector<std::int32_t> block(sound_block);
    std::uint64_t all = 0;
    while (const std::size_t frames = reader->read(block)) {
        meter.add(std::span<const std::int32_t>(
            block.data(), frames * static_cast<std::size_t>(reader->format().channels)));
        all += frames;
    }
    if (reader->fault() != 0)
        return Error{reason_of(reader->fault())};
    if (all < reader->frames() && reader->exact_length())
        return Error{"it is damaged, and cannot be read to its end."};
    return meter.loudness();
}

} // namespace tp
