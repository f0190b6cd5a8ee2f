// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/sound_format.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tp {

/// Where the samples lie in a WAV file of 16 bit, also in one that was never finished.
struct WavLayout {
    SoundFormat format;
    std::uint64_t data_begin = 0; ///< bytes before the first sample
    std::uint64_t frames = 0;     ///< whole frames that the file holds
    std::string notes; ///< what the chunk of ours says (Vorbis comments); empty where there is none
};

/// The chunk that holds a recording's comments while it is being made. Chunk names in lower case are free for
/// each program (RIFF, Multimedia Programming Interface and Data Specifications 1.0, 1991).
constexpr std::string_view wav_notes_chunk = "tpvc";
constexpr std::size_t most_wav_notes = 1 << 20; ///< bytes

/// Finds the samples in whatever a crash left: sizes in the header that are 0, too small or too large, a file
/// that ends within its header (no frames) or within a sample, foreign chunks before the samples, RF64. The
/// size that the header claims is believed only where what follows is a chunk; else the samples go on to the
/// end of the file. Mono or stereo, 16 bit PCM, 8 to 192 kHz; anything else, and a file in which no samples
/// can be found, is an error (the end of a sentence).
Result<WavLayout> wav_layout(const ByteSource& file);

/// A header after which samples follow to the end of the file, however many: its sizes say "unknown"
/// (0xFFFFFFFF). `notes` at most `most_wav_notes`.
std::string open_ended_wav_header(const SoundFormat& format, std::string_view notes);

/// Reads frames from number `first` on, channel beside channel; how many there were.
std::size_t read_frames(const ByteSource& file, const WavLayout& layout, std::uint64_t first,
                        std::span<std::int16_t> to);

} // namespace tp
