// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording_file.hpp"

#include "audio/recordings/flac_file.hpp"
#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/recording_name.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "audio/recordings/wav_layout.hpp"
#include "audio/recordings/wav_stream.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/new_file.hpp"

#include <cerrno>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view flac_end = ".flac";

/// The name of the recording that `part` becomes, without its end.
std::string stem_of_part(const fs::path& part) {
    std::string name = part.filename().string();
    if (name.ends_with(wav_part_end))
        name.resize(name.size() - wav_part_end.size());
    return name;
}

bool holds(const fs::path& flac, const ByteSource& bytes, const WavLayout& layout) {
    auto reader = SoundReader::open(flac);
    if (!reader || reader->frames() != layout.frames || reader->format() != layout.format)
        return false;
    WavStream part(bytes, layout);
    return fingerprint_of(*reader) == fingerprint_of(part);
}

/// The FLAC that was made of the part before, by who was killed before the part was removed.
std::optional<fs::path> made_before(const fs::path& part, const ByteSource& bytes, const WavLayout& layout) {
    for (int number = 1;; ++number) {
        const fs::path name = numbered_name(part.parent_path(), stem_of_part(part), flac_end, number);
        if (!is_taken(name))
            return std::nullopt;
        if (holds(name, bytes, layout))
            return name;
    }
}

std::string remove_durably(const fs::path& file) {
    if (const int error = remove_name(file); error != 0 && error != ENOENT)
        return reason_of(error);
    return sync_folder(file.parent_path());
}

} // namespace

Result<WavPart> start_recording(const fs::path& folder, const RecordingNotes& notes,
                                const SoundFormat& format) {
    if (std::string reason = make_folder(folder, Readers::owner_only); !reason.empty())
        return Error{reason};
    const std::string stem = recording_stem(notes.label);
    std::optional<WavPart> part;
    const auto made = under_free_name(folder, stem, wav_part_end, [&](const fs::path& place) -> std::string {
        auto created = WavPart::create(place, format, notes);
        if (created)
            part.emplace(std::move(*created));
        return created.error();
    });
    if (!made)
        return Error{made.error()};
    return std::move(*part);
}

Result<std::optional<fs::path>> finish_recording(WavPart part, const RecordingNotes& notes) {
    if (std::string reason = part.sync(); !reason.empty())
        return Error{reason};
    return finish_part(part.place(), part.lock(), notes);
}

Result<std::optional<fs::path>> finish_part(const fs::path& part, const PartLock& lock,
                                            const std::optional<RecordingNotes>& notes) {
    const auto bytes = FileBytes::of(lock.file());
    if (!bytes)
        return Error{bytes.error()};
    const auto layout = wav_layout(**bytes);
    if (!layout)
        return Error{layout.error()};
    if ((*bytes)->fault() != 0)
        return Error{reason_of((*bytes)->fault())};
    if (layout->frames == 0) {
        if (std::string reason = remove_durably(part); !reason.empty())
            return Error{reason};
        return std::optional<fs::path>();
    }
    std::optional<fs::path> flac = made_before(part, **bytes, *layout);
    if (!flac) {
        VorbisComments comments;
        if (notes)
            set_notes(comments, *notes);
        else if (auto carried = vorbis_comments(layout->notes))
            comments = std::move(*carried);
        const auto stored =
            under_free_name(part.parent_path(), stem_of_part(part), flac_end, [&](const fs::path& place) {
                WavStream sound(**bytes, *layout);
                return store_flac(sound, comments, place).error();
            });
        if (!stored)
            return Error{stored.error()};
        flac = *stored;
    }
    if (std::string reason = sync_folder(part.parent_path()); !reason.empty())
        return Error{reason};
    // One that cannot be removed is found again by the next repair, which then finds the FLAC made.
    static_cast<void>(remove_durably(part));
    return flac;
}

Result<VorbisComments> comments_of(const fs::path& file) {
    VorbisComments comments;
    const auto bytes = FileBytes::open(file);
    if (!bytes)
        return Error{bytes.error()};
    if (is_flac(**bytes)) {
        if (auto head = flac_head(**bytes))
            comments = std::move(head->comments);
    } else if (const auto reader = SoundReader::open(file)) {
        comments.fields = {{"ARTIST", reader->artist()}, {"DATE", reader->date()}};
    }
    if ((*bytes)->fault() != 0)
        return Error{reason_of((*bytes)->fault())};
    return comments;
}

Result<RecordingAbout> about_recording(const fs::path& file) {
    const auto reader = SoundReader::open(file);
    if (!reader)
        return Error{reader.error()};
    const auto comments = comments_of(file);
    if (!comments)
        return Error{comments.error()};
    const auto bytes = FileBytes::open(file);
    if (!bytes)
        return Error{bytes.error()};
    const bool flac = is_flac(**bytes);
    if ((*bytes)->fault() != 0)
        return Error{reason_of((*bytes)->fault())};
    return RecordingAbout{notes_in(*comments), reader->format(), reader->frames(), reader->exact_length(),
                          flac};
}

std::string relabel_recording(const fs::path& file, const RecordingNotes& notes,
                              const std::stop_token& stop) {
    const auto bytes = FileBytes::open(file);
    if (!bytes)
        return bytes.error();
    const auto head = flac_head(**bytes);
    if (!head)
        return head.error();
    auto made = NewFile::beside(file, Readers::owner_only);
    if (!made)
        return made.error();
    VorbisComments comments = head->comments;
    set_notes(comments, notes);
    std::string reason =
        write_with_comments(**bytes, *head, comments, [&](std::string_view block) -> std::string {
            return stop.stop_requested() ? "it was stopped." : made->write(block);
        });
    return reason.empty() ? made->take_place() : reason;
}

} // namespace tp
