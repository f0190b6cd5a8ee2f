// SPDX-License-Identifier: Apache-2.0
#include "audio/video/sound_of_video.hpp"

#include "audio/recordings/byte_source.hpp"
#include "audio/video/sound_messages.hpp"
#include "audio/video/video_sound.hpp"
#include "core/files/file_words.hpp"
#include "core/files/open_file.hpp"
#include "core/processes/foreign_decoder.hpp"
#include "core/processes/helper.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>

namespace tp {
namespace {

/// A sound that a helper decodes.
class HelpersSound final : public SoundStream {
public:
    HelpersSound(HelperLease helper, SoundFacts facts) : helper_(std::move(helper)), facts_(facts) {}
    HelpersSound(const HelpersSound&) = delete;
    HelpersSound& operator=(const HelpersSound&) = delete;
    ~HelpersSound() override { helper_->tell(message_of(SoundQuestion{})); }

    SoundFormat format() const override { return facts_.format; }
    SampleDepth depth() const override { return facts_.depth; }
    std::uint64_t frames() const override { return facts_.frames; }
    std::size_t read(std::span<std::int32_t> to) override {
        const auto channels = static_cast<std::size_t>(facts_.format.channels);
        const std::size_t wanted = to.size() / channels * channels;
        std::size_t done = 0;
        while (done < wanted) {
            const std::size_t some =
                next(to.subspan(done, std::min(wanted - done, most_samples / channels * channels)));
            if (some == 0)
                break;
            done += some;
        }
        return done / channels;
    }

private:
    /// How many samples there were, those of whole frames.
    std::size_t next(std::span<std::int32_t> to) {
        SoundQuestion question;
        question.what = SoundQuestion::What::read;
        question.samples = static_cast<std::int64_t>(to.size());
        auto answer = helper_->ask(message_of(std::move(question)));
        auto* const message = std::get_if<Message>(&answer);
        const std::size_t count = message == nullptr ? 0 : samples_in(*message, to);
        return count - count % static_cast<std::size_t>(facts_.format.channels);
    }

    HelperLease helper_;
    SoundFacts facts_;
};

Result<std::unique_ptr<SoundStream>> by_helper(HelperPool& helpers, SoundQuestion question) {
    Result<HelperLease> helper = helpers.lease();
    if (!helper)
        return Error{helper.error()};
    auto answer = helper->operator->()->ask(message_of(std::move(question)));
    auto* const message = std::get_if<Message>(&answer);
    if (message == nullptr)
        return Error{std::get<NoAnswer>(answer) == NoAnswer::too_long
                         ? "its sound takes too long to decode."
                         : "its sound cannot be decoded: decoding it broke off. It may be damaged."};
    const Result<SoundFacts> facts = sound_facts(*message);
    if (!facts)
        return Error{facts.error()};
    return std::unique_ptr<SoundStream>(std::make_unique<HelpersSound>(std::move(helper).value(), *facts));
}

} // namespace

Result<std::unique_ptr<SoundStream>> sound_of_video(const std::filesystem::path& file, std::uint64_t begin,
                                                    std::uint64_t size) {
    auto bytes = FileBytes::open(file);
    if (!bytes)
        return Error{bytes.error()};
    auto part = std::make_unique<PartOfBytes>(std::move(*bytes), begin, size);
    if (ForeignDecoders* const decoders = foreign_decoders()) {
        SoundQuestion question;
        question.what = SoundQuestion::What::open;
        question.begin = static_cast<std::int64_t>(begin);
        question.size = static_cast<std::int64_t>(part->size());
        question.file = OpenFile(file, {}).handed_over();
        if (!question.file.ok())
            return Error{"it cannot be read: " + reason_of(errno)};
        return by_helper(decoders->videos, std::move(question));
    }
    auto sound = VideoSound::open(std::move(part));
    if (!sound)
        return Error{sound.error()};
    return std::unique_ptr<SoundStream>(std::make_unique<VideoSound>(std::move(sound).value()));
}

} // namespace tp
