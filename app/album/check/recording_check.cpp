// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/recording_check.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/keeper/recording_facts.hpp"
#include "audio/recordings/repair_folder.hpp"
#include "audio/recordings/wav_part.hpp"
#include "core/files/file_words.hpp"
#include "core/files/new_file.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

void missing_recording(const fs::path& photo, const Tag& tag, Findings& findings) {
    const fs::path file = tags_folder(photo) / tag.file;
    const std::string sentence = quoted(file) + " is listed but not there.";
    if (AlbumKeeper keeper(album_around(photo)); keeper.is_in_trash(photo, tag.file))
        findings.add(Finding::Kind::missing_recording, file, sentence,
                     "It is in the trash, so it is taken off the list.",
                     [&] { return keeper.forget_recording(photo, tag.file); });
    else
        findings.add(Finding::Kind::missing_recording, file,
                     sentence + " Bring it back from a copy of the album.");
}

constexpr fs::perms others = fs::perms::group_all | fs::perms::others_all;
constexpr fs::perms owner_may_write = fs::perms::owner_read | fs::perms::owner_write;

bool open_to_others(const fs::path& place) {
    std::error_code error;
    const fs::perms allowed = fs::status(place, error).permissions();
    return !error && (allowed & others) != fs::perms::none;
}

/// Empty: done.
std::string only_for_owner(const fs::path& place, fs::perms allowed) {
    std::error_code error;
    fs::permissions(place, allowed, error);
    return error ? reason_of(error.value()) : std::string{};
}

} // namespace

std::set<std::string> recordings_in(const fs::path& folder) {
    std::error_code error;
    std::set<std::string> there;
    for (const auto& file : fs::directory_iterator(folder, error))
        if (file.is_regular_file(error) && !is_temporary(file.path()) &&
            !file.path().filename().string().ends_with(wav_part_end))
            there.insert(file.path().filename().string());
    return there;
}

void check_unfinished(const fs::path& folder, Findings& findings) {
    std::error_code error;
    bool any = false;
    for (const auto& file : fs::directory_iterator(folder, error))
        any = any || file.path().filename().string().ends_with(wav_part_end);
    if (!any)
        return;
    if (!findings.mends()) {
        for (const auto& file : fs::directory_iterator(folder, error))
            if (file.path().filename().string().ends_with(wav_part_end))
                findings.add(Finding::Kind::unfinished_recording, file.path(),
                             quoted(file.path()) + " was not finished, or is being recorded now.",
                             "It is finished.", [] { return std::string{}; });
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

std::size_t check_recordings(const fs::path& photo, const PhotoRecord& record, Findings& findings) {
    const fs::path folder = tags_folder(photo);
    const std::set<std::string> there = recordings_in(folder);
    for (const std::string& file : there) {
        const auto facts = recording_facts(folder / file);
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
        if (!there.contains(tag.file))
            missing_recording(photo, tag, findings);
    check_readers(folder, there, findings);
    return there.size();
}

void check_readers(const fs::path& folder, const std::set<std::string>& files, Findings& findings) {
    std::vector<fs::path> open;
    for (const std::string& file : files)
        if (open_to_others(folder / file))
            open.push_back(folder / file);
    if (!open_to_others(folder) && open.empty())
        return;
    findings.add(Finding::Kind::open_to_others, folder,
                 "Other people on this machine may listen to recordings in " + quoted(folder) + ".",
                 "Only their owner may from then on.", [&] {
                     for (const fs::path& file : open)
                         if (const std::string reason = only_for_owner(file, owner_may_write);
                             !reason.empty())
                             return reason;
                     return only_for_owner(folder, fs::perms::owner_all);
                 });
}

} // namespace tp
