// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_format.hpp"
#include "audio/recordings/sound_stream.hpp"
#include "core/base/descriptor.hpp"
#include "core/base/result.hpp"
#include "core/processes/message.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tp {

/// Samples in one answer, all channels together.
inline constexpr std::size_t most_samples = 15'000;
static_assert(most_samples * sizeof(std::int32_t) + 64 < longest_message);

/// What is asked of a helper that decodes the sound of a video.
struct SoundQuestion {
    enum class What : std::uint8_t {
        open,  ///< the video that is those bytes of `file`
        read,  ///< the next `samples` of the one that is open
        forget ///< that one; not answered
    };
    What what = What::forget;
    std::int64_t begin = 0; ///< bytes
    std::int64_t size = 0;  ///< bytes
    std::int64_t samples = 0;
    Descriptor file;
};
Message message_of(SoundQuestion question);
/// None where it is no such question.
std::optional<SoundQuestion> sound_question(MessageReader& message);

/// What a video's sound is.
struct SoundFacts {
    SoundFormat format;
    SampleDepth depth = SampleDepth::bits_16;
    std::uint64_t frames = 0;
};
Message message_of(const Result<SoundFacts>& facts);
/// Believed is only what can be true: a helper may have been taken over by what it decoded.
Result<SoundFacts> sound_facts(Message& message);

Message message_of_samples(std::span<const std::int32_t> samples);
/// How many there are; 0 where it is no such answer.
std::size_t samples_in(Message& message, std::span<std::int32_t> to);

} // namespace tp
