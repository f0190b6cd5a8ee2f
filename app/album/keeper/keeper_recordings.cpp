// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/path_text.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/keeper/recording_facts.hpp"
#include "app/album/keeper/tag_note.hpp"
#include "app/album/metadata/motion_photo.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "audio/recordings/import_sound.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/trim.hpp"
#include "audio/video/sound_of_video.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_name.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/new_file.hpp"

#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t longest_video_s = 60; // a Live Photo lasts 3 s, a motion photo a few

auto find_tag(std::vector<Tag>& tags, const std::string& file) {
    return std::find_if(tags.begin(), tags.end(), [&](const Tag& tag) { return tag.file == file; });
}

std::string words_for(const Tag& tag) {
    const std::string person = readable(tag.label.person);
    switch (tag.label.kind) {
    case RecordingKind::memo:
        return person.empty() ? "the memo" : "the memo about " + person;
    case RecordingKind::person:
        return person.empty() ? "the recording of who it is" : "the recording of who " + person + " is";
    case RecordingKind::place:
        return person.empty() ? "the recording of the place" : "the recording of the place (" + person + ")";
    case RecordingKind::story:
        return person.empty() ? "the story" : "the story about " + person;
    case RecordingKind::ambient:
        return person.empty() ? "the recording of background sounds"
                              : "the recording of background sounds (" + person + ")";
    }
    return {};
}

/// When a file was last changed, which for a sound is when it ended: ISO 8601 with offset.
std::string time_of(const fs::path& file) {
    const QDateTime time = QFileInfo(QString::fromStdString(name_in_utf8(file))).lastModified();
    return time.isValid() ? time.toOffsetFromUtc(time.offsetFromUtc()).toString(Qt::ISODate).toStdString()
                          : std::string{};
}

/// Why a recording could not be listed, before it is stored.
std::string unlistable(const fs::path& photo) {
    const fs::path sidecar = sidecar_of(photo);
    return link_there(sidecar) ? left_alone(sidecar) : std::string{};
}

Error unknown(const fs::path& photo, const std::string& file) {
    return Error{"There is no recording " + quoted(fs::path(file)) + " on " + quoted(photo.filename()) + "."};
}

} // namespace

std::string AlbumKeeper::list(const fs::path& photo, const Tag& tag, const Behind& behind) {
    return change_sidecar(photo, [&](const PhotoRecord& record) {
        SidecarChanges changes;
        changes.tags = record.tags;
        std::vector<Tag>& tags = *changes.tags;
        const auto there = find_tag(tags, tag.file), before = behind ? find_tag(tags, *behind) : tags.end();
        if (there != tags.end())
            *there = tag;
        else if (before != tags.end())
            tags.insert(before + 1, tag);
        else
            tags.insert(behind == "" ? tags.begin() : tags.end(), tag);
        return changes;
    });
}

std::string AlbumKeeper::listed_behind(const fs::path& photo, const std::string& file) const {
    std::string before;
    if (const auto record = read_record(photo))
        for (const Tag& tag : record->tags) {
            if (tag.file == file)
                break;
            before = tag.file;
        }
    return before;
}

std::string AlbumKeeper::unlist(const fs::path& photo, const std::string& file) {
    return change_sidecar(photo, [&](const PhotoRecord& record) {
        SidecarChanges changes;
        changes.tags = record.tags;
        std::erase_if(*changes.tags, [&](const Tag& tag) { return tag.file == file; });
        return changes;
    });
}

Result<Tag> AlbumKeeper::tag_of(const fs::path& photo, const std::string& file) const {
    if (std::string problem = outside(photo); !problem.empty())
        return Error{problem};
    auto record = read_record(photo);
    if (!record)
        return Error{record.error()};
    const auto tag = find_tag(record->tags, file);
    return tag == record->tags.end() ? Result<Tag>(unknown(photo, file)) : Result<Tag>(*tag);
}

Result<AlbumKeeper::Added> AlbumKeeper::add_recording(const fs::path& photo, const fs::path& sound,
                                                      const RecordingLabel& label) {
    if (std::string problem = outside(photo); !problem.empty())
        return Error{problem};
    if (std::string problem = unlistable(photo); !problem.empty())
        return Error{problem};
    RecordingNotes notes{label, {}};
    if (const auto about = about_recording(sound))
        notes.chapters = about->notes.chapters;
    if (notes.label.recorded.empty())
        notes.label.recorded = time_of(sound);
    MadeTogether with_list;
    const auto kept = import_sound(sound, tags_folder(photo), notes);
    if (!kept)
        return Error{quoted(sound) + " cannot be added: " + kept.error()};
    with_list.next_completes();
    return listed(photo, *kept);
}

Result<AlbumKeeper::Added> AlbumKeeper::add_video_sound(const fs::path& photo, const fs::path& file,
                                                        const VideoPlace& video,
                                                        const RecordingLabel& label) {
    if (std::string problem = outside(photo); !problem.empty())
        return Error{problem};
    if (std::string problem = unlistable(photo); !problem.empty())
        return Error{problem};
    RecordingNotes notes{label, {}};
    if (notes.label.recorded.empty())
        notes.label.recorded = time_of(file);
    const auto open = [&]() -> Result<std::unique_ptr<SoundStream>> {
        auto sound = sound_of_video(file, video.begin, video.size);
        if (sound &&
            (*sound)->frames() > longest_video_s * static_cast<std::uint64_t>((*sound)->format().rate))
            return Error{"it is longer than a minute, so it is a film and not the photograph's."};
        return sound;
    };
    MadeTogether with_list;
    const auto kept = import_sound(open, tags_folder(photo), notes);
    with_list.next_completes();
    if (!kept)
        return Error{"The sound of the video " + std::string(video.begin > 0 ? "in " : "") + quoted(file) +
                     " is not imported: " + kept.error()};
    return listed(photo, *kept);
}

Result<AlbumKeeper::Added> AlbumKeeper::listed(const fs::path& photo, const ImportedSound& kept) {
    auto tag = list_recording(photo, kept.file.filename().string());
    return tag ? Result<Added>(Added{*std::move(tag), kept.warning}) : Error{tag.error()};
}

Result<Tag> AlbumKeeper::list_recording(const fs::path& photo, const std::string& file,
                                        const Behind& behind) {
    if (std::string problem = outside(photo); !problem.empty())
        return Error{problem};
    const auto tag = recording_facts(tags_folder(photo) / file);
    if (!tag)
        return Error{tag.error()};
    if (std::string problem = list(photo, *tag, behind); !problem.empty())
        return Error{"The recording " + quoted(tags_folder(photo) / file) +
                     " is kept, but the photograph's list could not be written: " + problem};
    auto id = std::make_shared<std::string>();
    history_.done({words_for(*tag) + " was added",
                   [this, photo, tag = *tag, id] {
                       const auto put = put_recording(photo, tag);
                       if (put)
                           *id = *put;
                       return put.error();
                   },
                   [this, id, behind] { return restore(*id, behind); }});
    return *tag;
}

Result<std::string> AlbumKeeper::put_recording(const fs::path& photo, const Tag& tag) {
    const auto id = trash_.put({tags_folder(photo) / tag.file},
                               words_for(tag) + " of " + readable(photo.filename().string()),
                               note_of({photo.lexically_relative(album_), tag}));
    if (!id)
        return id;
    if (std::string problem = unlist(photo, tag.file); !problem.empty()) {
        if (const std::string stuck = trash_.restore(*id); !stuck.empty())
            return Error{stuck};
        return Error{problem};
    }
    return id;
}

std::string AlbumKeeper::delete_recording(const fs::path& photo, const std::string& file) {
    const auto tag = tag_of(photo, file);
    if (!tag)
        return tag.error();
    const std::string behind = listed_behind(photo, file);
    const auto put = put_recording(photo, *tag);
    if (!put)
        return put.error();
    auto id = std::make_shared<std::string>(*put);
    history_.done({words_for(*tag) + " was deleted", [this, id, behind] { return restore(*id, behind); },
                   [this, photo, tag = *tag, id] {
                       const auto again = put_recording(photo, tag);
                       if (again)
                           *id = *again;
                       return again.error();
                   }});
    return {};
}

std::string AlbumKeeper::relabel(const fs::path& photo, const std::string& file, const RecordingLabel& label,
                                 const std::stop_token& stop) {
    auto tag = tag_of(photo, file);
    if (!tag)
        return tag.error();
    const auto about = about_recording(tags_folder(photo) / file);
    if (!about)
        return quoted(tags_folder(photo) / file) + " cannot be changed: " + about.error();
    RecordingNotes notes = about->notes;
    notes.label = label;
    if (const std::string reason = relabel_recording(tags_folder(photo) / file, notes, stop); !reason.empty())
        return quoted(tags_folder(photo) / file) + " cannot be changed: " + reason;
    tag->label = label;
    return list(photo, *tag);
}

std::string AlbumKeeper::label_recording(const fs::path& photo, const std::string& file,
                                         const RecordingLabel& label, const std::stop_token& stop) {
    const auto tag = tag_of(photo, file);
    std::string problem = tag ? relabel(photo, file, label, stop) : tag.error();
    if (!problem.empty())
        return problem;
    history_.done({words_for(*tag) + " was labelled",
                   [this, photo, file, before = tag->label] { return relabel(photo, file, before); },
                   [this, photo, file, label] { return relabel(photo, file, label); }});
    return {};
}

std::string AlbumKeeper::set_orders(const fs::path& photo, const std::vector<std::string>& files) {
    return change_sidecar(photo, [&](const PhotoRecord& record) {
        SidecarChanges changes;
        changes.tags = record.tags;
        for (Tag& tag : *changes.tags) {
            const auto place = std::find(files.begin(), files.end(), tag.file);
            tag.order = place == files.end() ? 0 : static_cast<int>(place - files.begin()) + 1;
        }
        return changes;
    });
}

std::string AlbumKeeper::order_recordings(const fs::path& photo, const std::vector<std::string>& files) {
    const auto record =
        outside(photo).empty() ? read_record(photo) : Result<PhotoRecord>(Error{outside(photo)});
    if (!record)
        return record.error();
    std::vector<Tag> ordered = record->tags;
    for (const std::string& file : files)
        if (find_tag(ordered, file) == ordered.end())
            return unknown(photo, file).sentence;
    std::erase_if(ordered, [](const Tag& tag) { return tag.order <= 0; });
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const Tag& a, const Tag& b) { return a.order < b.order; });
    std::vector<std::string> before;
    for (const Tag& tag : ordered)
        before.push_back(tag.file);
    if (std::string problem = set_orders(photo, files); !problem.empty())
        return problem;
    history_.done({"the recordings of " + readable(photo.filename().string()) + " were put in order",
                   [this, photo, before] { return set_orders(photo, before); },
                   [this, photo, files] { return set_orders(photo, files); }});
    return {};
}

Result<Tag> AlbumKeeper::trim_recording(const fs::path& photo, const std::string& file, double begin_s,
                                        double end_s) {
    const auto whole = tag_of(photo, file);
    if (!whole)
        return Error{whole.error()};
    const auto about = about_recording(tags_folder(photo) / file);
    if (!about || !(begin_s >= 0.0 && begin_s < end_s))
        return Error{quoted(tags_folder(photo) / file) + " cannot be trimmed: " +
                     (about ? "the part must begin before it ends." : about.error())};
    const auto frame = [&](double seconds) {
        const double last = static_cast<double>(about->frames);
        return static_cast<std::uint64_t>(std::llround(std::min(seconds * about->format.rate, last)));
    };
    MadeTogether with_list;
    const auto part = tp::trim_recording(tags_folder(photo) / file, frame(begin_s), frame(end_s));
    if (!part)
        return Error{quoted(tags_folder(photo) / file) + " cannot be trimmed: " + part.error()};
    const auto left_whole = [&](const std::string& problem) { // the part is of no use beside the whole one
        remove_file(*part);
        return Error{problem};
    };
    auto tag = recording_facts(*part);
    if (!tag)
        return left_whole(tag.error());
    tag->order = whole->order;
    with_list.next_completes();
    if (const std::string problem = list(photo, *tag, file); !problem.empty())
        return left_whole(problem);
    const auto put = put_recording(photo, *whole);
    if (!put)
        return unlist(photo, tag->file).empty() ? left_whole(put.error()) : Error{put.error()};
    auto whole_id = std::make_shared<std::string>(*put), part_id = std::make_shared<std::string>();
    const auto exchange = [this, photo](const Tag& away, std::string& away_id, const std::string& back_id) {
        if (std::string problem = restore(back_id, away.file); !problem.empty())
            return problem;
        const auto gone = put_recording(photo, away);
        if (gone)
            away_id = *gone;
        return gone.error();
    };
    history_.done({words_for(*whole) + " was trimmed",
                   [=, part = *tag] { return exchange(part, *part_id, *whole_id); },
                   [=, whole = *whole] { return exchange(whole, *whole_id, *part_id); }});
    return *tag;
}

bool AlbumKeeper::is_in_trash(const fs::path& photo, const std::string& file) const {
    const std::vector<TrashEntry> entries = trash_.entries();
    return std::any_of(entries.begin(), entries.end(), [&](const TrashEntry& entry) {
        return std::find(entry.files.begin(), entry.files.end(),
                         (tags_folder(photo) / file).lexically_relative(album_)) != entry.files.end();
    });
}

std::string AlbumKeeper::forget_recording(const fs::path& photo, const std::string& file) {
    if (!is_gone(tags_folder(photo) / file))
        return quoted(tags_folder(photo) / file) + " exists, so it stays on the list.";
    return unlist(photo, file);
}

} // namespace tp
