// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/part_lock.hpp"
#include "audio/recordings/recording_notes.hpp"
#include "audio/recordings/sound_format.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

namespace tp {

/// What the name of a recording that is not finished ends in.
constexpr std::string_view wav_part_end = ".wav.part";

/// A recording while it is being made: 16 bit PCM behind a WAV header that says "unknown length" and carries
/// the recording's notes, so that the header never has to be written again and a crash costs nothing that was
/// synced. Readable by its owner only. One thread at a time; append and sync write to the disk and may take
/// long, so the thread that hands over sound from the microphone is none to call them.
class WavPart {
public:
    /// `place` ends in ".wav.part" and must not exist; it appears whole and locked. Mono or stereo, 8 to
    /// 192 kHz. An error is the end of a sentence.
    static Result<WavPart> create(const std::filesystem::path& place, const SoundFormat& format,
                                  const RecordingNotes& notes);

    /// Adds whole frames, channel beside channel, and syncs when a second of sound is not yet on the disk.
    /// The reason why not, else empty; then `frames` says how many more there are (a full disk takes the
    /// first few), and the rest may be offered again. At most `longest_recording_s` in all.
    std::string append(std::span<const std::int16_t> samples);
    /// Brings what was added to the disk: when this returns empty, a power cut does not undo it. Once it has
    /// failed, it fails for ever: the system forgets which bytes it could not write.
    std::string sync();

    std::uint64_t frames() const { return frames_; }
    std::uint64_t frames_synced() const { return synced_; }
    const SoundFormat& format() const { return format_; }
    const std::filesystem::path& place() const { return place_; }
    const PartLock& lock() const { return lock_; }

private:
    WavPart(std::filesystem::path place, const SoundFormat& format, std::uint64_t header_bytes, PartLock lock)
        : place_(std::move(place)), format_(format), header_bytes_(header_bytes), lock_(std::move(lock)) {}
    std::uint64_t frame_bytes() const { return 2u * static_cast<std::uint64_t>(format_.channels); }

    std::filesystem::path place_;
    SoundFormat format_;
    std::uint64_t header_bytes_;
    PartLock lock_;
    std::uint64_t frames_ = 0;
    std::uint64_t synced_ = 0;
    std::string broken_; ///< why nothing can be synced any more
};

} // namespace tp
