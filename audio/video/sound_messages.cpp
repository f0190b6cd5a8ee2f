// SPDX-License-Identifier: Apache-2.0
#include "audio/video/sound_messages.hpp"

#include "audio/video/video_sound.hpp"
#include "core/files/file_words.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace tp {
namespace {

constexpr std::size_t longest_sentence = 1000; ///< bytes

bool is_depth(std::int64_t bits) { return bits == 8 || bits == 16 || bits == 24; }

} // namespace

Message message_of(SoundQuestion question) {
    MessageWriter message;
    message.add(static_cast<std::int64_t>(question.what));
    message.add(question.begin).add(question.size).add(question.samples);
    if (question.file.ok())
        message.hand_over(std::move(question.file));
    return message.take();
}

std::optional<SoundQuestion> sound_question(MessageReader& message) {
    SoundQuestion question;
    const std::int64_t what = message.number();
    if (what < 0 || what > static_cast<std::int64_t>(SoundQuestion::What::forget))
        return std::nullopt;
    question.what = static_cast<SoundQuestion::What>(what);
    question.begin = message.number();
    question.size = message.number();
    question.samples = message.number();
    if (question.what == SoundQuestion::What::open)
        question.file = message.descriptor();
    return message.whole() ? std::optional(std::move(question)) : std::nullopt;
}

Message message_of(const Result<SoundFacts>& facts) {
    MessageWriter message;
    message.add(std::string_view(facts.error()).substr(0, longest_sentence));
    if (facts)
        message.add(std::int64_t{facts->format.rate})
            .add(std::int64_t{facts->format.channels})
            .add(static_cast<std::int64_t>(facts->depth))
            .add(static_cast<std::int64_t>(facts->frames));
    return message.take();
}

Result<SoundFacts> sound_facts(Message& message) {
    MessageReader reader(message);
    if (const std::string sentence = reader.text(); !sentence.empty())
        return Error{readable(std::string_view(sentence).substr(0, longest_sentence))};
    const std::int64_t rate = reader.number(), channels = reader.number(), depth = reader.number(),
                       frames = reader.number();
    if (!reader.whole() || rate < lowest_video_rate || rate > highest_video_rate || channels < 1 ||
        channels > most_video_channels || !is_depth(depth) || frames < 0)
        return Error{"its sound cannot be decoded."};
    return SoundFacts{{static_cast<int>(rate), static_cast<int>(channels)},
                      static_cast<SampleDepth>(depth),
                      static_cast<std::uint64_t>(frames)};
}

Message message_of_samples(std::span<const std::int32_t> samples) {
    return MessageWriter().add(samples).take();
}

std::size_t samples_in(Message& message, std::span<std::int32_t> to) {
    MessageReader reader(message);
    const std::size_t count = reader.numbers(to);
    return reader.whole() ? count : 0;
}

} // namespace tp
