// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/recording_check.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/keeper/recording_facts.hpp"
#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/repair_folder.hpp"
#include "audio/recordings/wav_part.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"

#include <algorithm>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

void missing_recording(const fs::path& photo, const Tag& tag, Deleted& deleted, Findings& findings) {
    const fs::path file = tags_folder(photo) / tag.file;
    if (link_on_the_way(file)) // which is told of already
        return;
    if (const std::string fault = is_gone(file) ? std::string{} : fault_in_reading(file); !fault.empty()) {
        findings.add(Finding::Kind::unreadable_recording, file, quoted(file) + " cannot be read: " + fault);
        return;
    }
    const std::string sentence = quoted(file) + " is listed but not there.";
    if (const fs::path album = album_around(photo); deleted.holds(album, file))
        findings.add(Finding::Kind::missing_recording, file, sentence,
                     "It is in the trash, so it is taken off the list.",
                     [&] { return AlbumKeeper(album).forget_recording(photo, tag.file); });
    else
        findings.add(Finding::Kind::missing_recording, file,
                     sentence + " Bring it back from a copy of the album.");
}

} // namespace

std::set<std::string> recordings_in(const fs::path& folder, int* error) {
    std::set<std::string> there;
    for (const FolderEntry& file : entries_of(folder, error))
        if (!file.link && file.facts.kind == FileFacts::Kind::file && !is_temporary(file.name) &&
            !file.name.ends_with(wav_part_end))
            there.insert(file.name);
    return there;
}

void check_unfinished(const fs::path& folder, Findings& findings) {
    std::vector<fs::path> parts;
    int error = 0;
    for (const FolderEntry& file : entries_of(folder, &error))
        if (!file.link && file.name.ends_with(wav_part_end))
            parts.push_back(folder / file.name);
    findings.add_folder(folder, error);
    if (parts.empty())
        return;
    if (!findings.mends()) {
        for (const fs::path& part : parts)
            findings.add(Finding::Kind::unfinished_recording, part,
                         quoted(part) + " was not finished, or is being recorded now.", "It is finished.",
                         [] { return std::string{}; });
        return;
    }
    const auto repaired = repair_folder(folder);
    if (!repaired) {
        findings.add(Finding::Kind::unfinished_recording, folder, repaired.error());
        return;
    }
    for (const RepairedPart& part : *repaired)
        if (part.outcome != RepairedPart::Outcome::in_use)
            findings.add(Finding::Kind::unfinished_recording, part.part,
                         quoted(part.part) + " was not finished.", "It is finished.", [&] {
                             return part.outcome == RepairedPart::Outcome::failed ? part.sentence
                                                                                  : std::string{};
                         });
}

bool Deleted::holds(const fs::path& album, const fs::path& file) {
    const auto [known, is_new] = albums_.try_emplace(album);
    if (is_new)
        for (const TrashEntry& entry : Trash(album).entries())
            known->second.insert(entry.files.begin(), entry.files.end());
    return known->second.contains(file.lexically_relative(album));
}

std::size_t check_recordings(const fs::path& photo, const PhotoRecord& record, Deleted& deleted,
                             Findings& findings) {
    const fs::path folder = tags_folder(photo);
    int error = 0;
    const std::set<std::string> there = recordings_in(folder, &error);
    const bool may_have_more = findings.add_folder(folder, error);
    for (const std::string& file : there) {
        const auto facts = looked_twice([&] { return recording_facts(folder / file); });
        if (!facts) {
            findings.add(Finding::Kind::unreadable_recording, folder / file, facts.error());
            continue;
        }
        if (std::none_of(record.tags.begin(), record.tags.end(),
                         [&](const Tag& tag) { return tag.file == file; }))
            findings.add(Finding::Kind::unlisted_recording, folder / file,
                         quoted(folder / file) + " is not in the list of its photograph.",
                         "It is listed by its own comments.",
                         [&] { return findings.keeper().list_recording(photo, file).error(); });
    }
    for (const Tag& tag : record.tags)
        if (!there.contains(tag.file) && !may_have_more)
            missing_recording(photo, tag, deleted, findings);
    check_readers(folder, there, findings);
    return there.size();
}

void check_readers(const fs::path& folder, const std::set<std::string>& files, Findings& findings) {
    std::vector<fs::path> open;
    for (const std::string& file : files)
        if (open_to_others(folder / file))
            open.push_back(folder / file);
    if ((!open_to_others(folder) && open.empty()) || names_its_readers(folder))
        return;
    findings.add(Finding::Kind::open_to_others, folder,
                 "Other people on this machine may listen to recordings in " + quoted(folder) + ".",
                 "Only their owner may from then on.", [&] {
                     for (const fs::path& file : open)
                         if (const int error = only_for_owner(file); error != 0)
                             return reason_of(error);
                     const int error = only_for_owner(folder);
                     return error != 0 ? reason_of(error) : std::string{};
                 });
}

} // namespace tp
