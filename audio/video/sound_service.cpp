// SPDX-License-Identifier: Apache-2.0
#include "audio/video/sound_service.hpp"

#include "audio/video/handed_bytes.hpp"
#include "audio/video/libav.hpp"
#include "audio/video/sound_messages.hpp"
#include "audio/video/video_sound.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tp {

void load_video_decoders() { load_libav(); }

std::optional<Message> SoundService::answer(MessageReader& message) {
    std::optional<SoundQuestion> question = sound_question(message);
    if (!question)
        return std::nullopt;
    switch (question->what) {
    case SoundQuestion::What::open: {
        sound_.reset();
        Result<VideoSound> opened = VideoSound::open(
            std::make_unique<HandedBytes>(std::move(question->file), question->begin, question->size));
        if (!opened)
            return message_of(Result<SoundFacts>(Error{opened.error()}));
        sound_ = std::make_unique<VideoSound>(std::move(opened).value());
        return message_of(
            Result<SoundFacts>(SoundFacts{sound_->format(), sound_->depth(), sound_->frames()}));
    }
    case SoundQuestion::What::read: {
        const auto wanted = static_cast<std::size_t>(
            std::clamp<std::int64_t>(question->samples, 0, static_cast<std::int64_t>(most_samples)));
        std::vector<std::int32_t> samples(sound_ ? wanted : 0);
        const std::size_t frames = sound_ ? sound_->read(samples) : 0;
        samples.resize(frames * static_cast<std::size_t>(sound_ ? sound_->format().channels : 0));
        return message_of_samples(samples);
    }
    case SoundQuestion::What::forget:
        break;
    }
    sound_.reset();
    return std::nullopt;
}

} // namespace tp
