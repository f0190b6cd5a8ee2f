// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/import_sound.hpp"

#include "audio/recordings/flac_file.hpp"
#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/recording_name.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "core/files/durable_file.hpp"

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

} // namespace

Result<ImportedSound> import_sound(const fs::path& from, const fs::path& folder,
                                   const RecordingNotes& notes) {
    const auto about = about_recording(from);
    if (!about)
        return Error{about.error()};
    if (std::string reason = make_folder(folder, Readers::owner_only); !reason.empty())
        return Error{reason};
    VorbisComments comments = about->flac ? comments_of(from) : VorbisComments{};
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
    ImportedSound imported{*file, {}};
    const auto second = static_cast<std::uint64_t>(about->format.rate); // MP3 only estimates its length
    if (frames + (about->exact_length ? 0 : second) < about->frames)
        imported.warning = "It is damaged; only the first " + seconds_in_words(frames, about->format.rate) +
                           " of " + seconds_in_words(about->frames, about->format.rate) + " could be read.";
    return imported;
}

} // namespace tp
