// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/playback_stream.hpp"

#include "audio/sound/sound_format.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr double buffer_s = 2.0; ///< a disk may sleep so long without being heard
constexpr std::size_t block_frames = 4096;

} // namespace

PlaybackStream::PlaybackStream(What what)
    : what_(std::move(what)), silence_frames_(std::llround(what_.silence_s * sound_rate)),
      gain_(static_cast<float>(std::pow(10.0, what_.gain_db / 20.0))),
      ring_(static_cast<std::size_t>(buffer_s * sound_rate) * played_channels),
      silence_left_(silence_frames_) {}

std::string PlaybackStream::open() {
    Result<SoundFile> file = SoundFile::open(what_.file);
    if (!file)
        return file.error();
    file_.emplace(std::move(file).value());
    duration_s_ = file_->duration_s();
    stretcher_.emplace(file_->rate(), file_->channels(), what_.speed);
    if (what_.begin_s > 0.0 && !file_->wind_to(what_.begin_s))
        return "The recording " + quoted(what_.file.filename()) + " can only be played from its beginning.";
    return {};
}

bool PlaybackStream::fill() {
    for (;;) {
        const std::size_t written = ring_.write(waiting_);
        waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(written));
        if (!waiting_.empty())
            return true;
        if (all_read_) {
            all_given_.store(true, std::memory_order_release);
            return false;
        }
        const std::vector<float>& block = file_->read(block_frames);
        all_read_ = block.empty();
        if (all_read_)
            stretcher_->end();
        else
            stretcher_->put(block);
        give(stretcher_->take());
    }
}

/// With its gain and on both sides, to what waits for the ring.
void PlaybackStream::give(std::span<const float> samples) {
    const auto repeat = static_cast<std::size_t>(file_->channels() == 1 ? played_channels : 1);
    waiting_.reserve(samples.size() * repeat);
    for (const float sample : samples)
        waiting_.insert(waiting_.end(), repeat, std::clamp(sample * gain_, -1.0F, 1.0F));
}

std::size_t PlaybackStream::pull(std::span<float> samples) {
    const auto silent = static_cast<std::size_t>(
        std::min<std::int64_t>(silence_left_ * played_channels, static_cast<std::int64_t>(samples.size())));
    std::fill_n(samples.begin(), silent, 0.0F);
    silence_left_ -= static_cast<std::int64_t>(silent) / played_channels;

    const bool no_more = all_given_.load(std::memory_order_acquire); // before reading: what comes is the last
    const std::size_t got = silent + ring_.read(samples.subspan(silent));
    if (got == samples.size() || no_more)
        return got;
    std::fill(samples.begin() + static_cast<std::ptrdiff_t>(got), samples.end(), 0.0F);
    starved_ += static_cast<std::int64_t>(samples.size() - got) / played_channels;
    return samples.size();
}

/// What was starved may still be on its way; the place then stands still until it has been heard.
void PlaybackStream::heard(std::int64_t frames) {
    begun_.store(frames >= silence_frames_, std::memory_order_relaxed);
    const std::int64_t sounded = frames - silence_frames_ - starved_;
    if (sounded > sounded_.load(std::memory_order_relaxed))
        sounded_.store(sounded, std::memory_order_relaxed);
}

double PlaybackStream::position_s() const {
    const double since =
        static_cast<double>(sounded_.load(std::memory_order_relaxed)) / sound_rate * what_.speed;
    return std::min(what_.begin_s + since, duration_s_);
}

double PlaybackStream::buffered() const {
    return static_cast<double>(ring_.filled()) / static_cast<double>(ring_.capacity());
}

} // namespace tp
