// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/import_sound.hpp"

#include "audio/recordings/flac_file.hpp"
#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/recording_name.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "core/files/durable_file.hpp"

#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// The file's bytes where it is a FLAC that says how long it is and can be decoded to its end.
std::unique_ptr<FileBytes> sound_flac(const fs::path& file) {
    auto bytes = FileBytes::open(file);
    if (!bytes)
        return nullptr;
    const auto head = flac_head(**bytes);
    if (!head || head->frames == 0)
        return nullptr;
    auto reader = SoundReader::open(file);
    if (!reader)
        return nullptr;
    std::uint64_t frames = 0;
    std::vector<std::int32_t> block(sound_block);
    while (const std::size_t more = reader->read(block))
        frames += more;
    return frames == reader->frames() && !reader->failed() ? std::move(*bytes) : nullptr;
}

std::string seconds_in_words(std::uint64_t frames, int rate) {
    return std::to_string(frames / static_cast<std::uint64_t>(rate)) + " s";
}

/// A sentence where more than `slack` frames of those that were claimed are missing; else empty.
std::string warning_of(std::uint64_t frames, std::uint64_t claimed, std::uint64_t slack, int rate) {
    return frames + slack >= claimed ? std::string{}
                                     : "It is damaged; only the first " + seconds_in_words(frames, rate) +
                                           " of " + seconds_in_words(claimed, rate) + " could be read.";
}

} // namespace

Result<ImportedSound> import_sound(const fs::path& from, const fs::path& folder,
                                   const RecordingNotes& notes) {
    const auto about = about_recording(from);
    if (!about)
        return Error{about.error()};
    if (std::string reason = make_folder(folder, Readers::owner_only); !reason.empty())
        return Error{reason};
    auto carried = about->flac ? comments_of(from) : Result<VorbisComments>(VorbisComments{});
    if (!carried)
        return Error{carried.error()};
    VorbisComments comments = std::move(*carried);
    set_notes(comments, notes);

    const std::unique_ptr<FileBytes> flac = about->flac ? sound_flac(from) : nullptr;
    std::uint64_t frames = about->frames;
    const auto store = [&](const fs::path& place) -> std::string {
        if (flac)
            return store_flac_copy(*flac, comments, place);
        auto reader = SoundReader::open(from);
        if (!reader)
            return reader.error();
        const auto stored = store_flac(*reader, comments, place, Incomplete::stored);
        if (stored)
            frames = *stored;
        return stored.error();
    };
    const auto file = under_free_name(folder, recording_stem(notes.label), ".flac", store);
    if (!file)
        return Error{file.error()};
    const auto second = static_cast<std::uint64_t>(about->format.rate); // MP3 only estimates its length
    return ImportedSound{
        *file, warning_of(frames, about->frames, about->exact_length ? 0 : second, about->format.rate)};
}

Result<ImportedSound> import_sound(const std::function<Result<std::unique_ptr<SoundStream>>()>& open,
                                   const fs::path& folder, const RecordingNotes& notes) {
    if (const auto begins = open(); !begins)
        return Error{begins.error()};
    if (std::string reason = make_folder(folder, Readers::owner_only); !reason.empty())
        return Error{reason};
    VorbisComments comments;
    set_notes(comments, notes);
    std::string warning;
    const auto store = [&](const fs::path& place) -> std::string {
        const auto sound = open();
        if (!sound)
            return sound.error();
        const int rate = (*sound)->format().rate;
        const auto stored = store_flac(**sound, comments, place, Incomplete::stored);
        if (stored) // a codec fills its last block up, and its container says so or not
            warning = warning_of(*stored, (*sound)->frames(), static_cast<std::uint64_t>(rate), rate);
        return stored.error();
    };
    const auto file = under_free_name(folder, recording_stem(notes.label), ".flac", store);
    return file ? Result<ImportedSound>(ImportedSound{*file, warning}) : Error{file.error()};
}

} // namespace tp
