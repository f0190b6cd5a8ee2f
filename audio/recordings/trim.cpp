// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/trim.hpp"

#include "audio/recordings/flac_file.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/recording_name.hpp"
#include "audio/recordings/sound_reader.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

/// The next so many frames of a sound.
class Piece : public SoundStream {
public:
    Piece(SoundReader& sound, std::uint64_t frames) : sound_(sound), frames_(frames), left_(frames) {}

    SoundFormat format() const override { return sound_.format(); }
    SampleDepth depth() const override { return sound_.depth(); }
    std::uint64_t frames() const override { return frames_; }
    std::size_t read(std::span<std::int32_t> to) override {
        const auto channels = static_cast<std::size_t>(format().channels);
        const std::size_t most =
            static_cast<std::size_t>(std::min<std::uint64_t>(left_, to.size() / channels));
        const std::size_t frames = most == 0 ? 0 : sound_.read(to.first(most * channels));
        left_ -= frames;
        return frames;
    }

private:
    SoundReader& sound_;
    std::uint64_t frames_;
    std::uint64_t left_;
};

std::string store_piece(const std::filesystem::path& recording, std::uint64_t begin, std::uint64_t end,
                        const VorbisComments& comments, const std::filesystem::path& place) {
    auto sound = SoundReader::open(recording);
    if (!sound)
        return sound.error();
    if (!sound->seek(begin))
        return "it is damaged.";
    Piece piece(*sound, end - begin);
    return store_flac(piece, comments, place).error();
}

} // namespace

Result<std::filesystem::path> trim_recording(const std::filesystem::path& recording, std::uint64_t begin,
                                             std::uint64_t end) {
    const auto about = about_recording(recording);
    if (!about)
        return Error{about.error()};
    if (begin >= end || end > about->frames)
        return Error{"there is no such piece in it."};
    auto carried = comments_of(recording);
    if (!carried)
        return Error{carried.error()};
    VorbisComments comments = std::move(*carried);
    RecordingNotes notes = about->notes;
    notes.chapters = chapters_between(notes.chapters, static_cast<double>(begin) / about->format.rate,
                                      static_cast<double>(end) / about->format.rate);
    set_notes(comments, notes);
    return under_free_name(recording.parent_path(), recording.stem().string(), ".flac",
                           [&](const std::filesystem::path& place) {
                               return store_piece(recording, begin, end, comments, place);
                           });
}

} // namespace tp
