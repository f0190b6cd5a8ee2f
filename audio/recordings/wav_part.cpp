// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/wav_part.hpp"

#include "audio/recordings/wav_layout.hpp"
#include "core/files/file_words.hpp"
#include "core/files/new_file.hpp"

#include <algorithm>

namespace tp {

Result<WavPart> WavPart::create(const std::filesystem::path& place, const SoundFormat& format,
                                const RecordingNotes& notes) {
    if (format.channels < 1 || format.channels > 2 || format.rate < 8'000 || format.rate > 192'000)
        return Error{"a recording is mono or stereo, with 8000 to 192000 samples a second."};
    VorbisComments comments;
    set_notes(comments, notes);
    const auto block = vorbis_comment_block(comments);
    if (!block || block->size() > most_wav_notes)
        return Error{"its texts are too long."};
    const std::string header = open_ended_wav_header(format, *block);

    auto made = NewFile::beside(place, Readers::owner_only);
    if (!made)
        return Error{made.error()};
    // Locked before it has its name: who looks for parts that were left behind never sees it free.
    auto lock = PartLock::take(made->temporary());
    if (!lock)
        return Error{lock.error()};
    if (!*lock)
        return Error{"another program is using it."};
    std::string reason = made->write(header);
    if (reason.empty())
        reason = made->take_place(Existing::kept);
    if (!reason.empty())
        return Error{reason};
    return WavPart(place, format, header.size(), std::move(**lock));
}

std::string WavPart::append(std::span<const std::int16_t> samples) {
    if (!broken_.empty())
        return broken_;
    const std::uint64_t most = longest_recording_s * static_cast<std::uint64_t>(format_.rate);
    const std::uint64_t offered = samples.size() / static_cast<std::size_t>(format_.channels);
    const std::uint64_t begin = header_bytes_ + frames_ * frame_bytes();
    const std::uint64_t bytes = std::min(offered, most - frames_) * frame_bytes();
    const auto* const first = reinterpret_cast<const char*>(samples.data());
    const Written written = lock_.file().write_at(begin, {first, static_cast<std::size_t>(bytes)});
    std::string reason = written.error == 0 ? std::string{} : reason_of(written.error);
    frames_ += written.count / frame_bytes();
    if (!reason.empty())
        return reason;
    if (frames_ - synced_ >= static_cast<std::uint64_t>(format_.rate))
        reason = sync();
    if (reason.empty() && bytes < offered * frame_bytes())
        return "a recording is at most " + std::to_string(longest_recording_s / 3600) + " hours long.";
    return reason;
}

std::string WavPart::sync() {
    if (!broken_.empty())
        return broken_;
    if (synced_ == frames_)
        return {};
    if (const int error = lock_.file().bytes_to_disk(); error != 0)
        return broken_ = reason_of(error);
    synced_ = frames_;
    return {};
}

} // namespace tp
