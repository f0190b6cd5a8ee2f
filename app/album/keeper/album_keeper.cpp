// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_keeper.hpp"

#include "app/album/keeper/path_text.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/keeper/tag_note.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/free_name.hpp"

#include <cerrno>
#include <memory>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// The name, or the name with a number where another recording has it by now.
Result<fs::path> free_place(const fs::path& file) {
    return free_name([&](int number) {
        const std::string end = number == 1 ? "" : "-" + std::to_string(number);
        return std::vector{file.parent_path() / (file.stem().string() + end + file.extension().string())};
    });
}

} // namespace

AlbumKeeper::AlbumKeeper(fs::path album) : album_(std::move(album)), held_(album_), trash_(album_) {}

std::string AlbumKeeper::outside(const fs::path& photo) const {
    if (!stays_below(photo.lexically_relative(album_)))
        return quoted(photo) + " is not in the album " + quoted(album_) + ".";
    if (const auto link = link_on_the_way(photo.parent_path()))
        return left_alone(*link);
    if (!photo_there(photo))
        return is_disks_fault(errno)
                   ? "The photograph " + quoted(photo) + " cannot be read: " + reason_of(errno)
                   : "There is no photograph " + quoted(photo) + ".";
    return {};
}

std::string AlbumKeeper::change_sidecar(const fs::path& photo, const Change& change) {
    if (std::string problem = outside(photo); !problem.empty())
        return problem;
    std::string unreadable;
    const std::string problem = write_sidecar(photo, [&](const PhotoRecord& record) {
        SidecarChanges changes = change(record);
        if (changes == SidecarChanges{} || !record.content_hash.empty())
            return changes;
        const auto hash = content_hash(photo); // by it the sidecar finds its photograph again
        if (hash)
            changes.content_hash = *hash;
        else
            unreadable = hash.error();
        return changes;
    });
    return problem.empty() ? unreadable : problem;
}

std::string AlbumKeeper::describe(const fs::path& photo, const std::string& language,
                                  const std::string& alt_text, const std::string& description) {
    struct Texts {
        std::string alt_text, description;
    };
    const auto set = [this, photo, language](const Texts& to, Texts* before) {
        return change_sidecar(photo, [&](const PhotoRecord& record) {
            const auto changed = [&](LanguageTexts texts, const std::string& text, std::string* earlier) {
                if (const auto found = texts.find(language); earlier && found != texts.end())
                    *earlier = found->second;
                if (text.empty())
                    texts.erase(language);
                else
                    texts[language] = text;
                return texts;
            };
            SidecarChanges changes;
            changes.alt_text = changed(record.alt_text, to.alt_text, before ? &before->alt_text : nullptr);
            changes.description =
                changed(record.description, to.description, before ? &before->description : nullptr);
            return changes;
        });
    };
    Texts before;
    const Texts after{alt_text, description};
    if (std::string problem = set(after, &before); !problem.empty())
        return problem;
    history_.done({readable(photo.filename().string()) + " was described",
                   [set, before] { return set(before, nullptr); },
                   [set, after] { return set(after, nullptr); }});
    return {};
}

std::string AlbumKeeper::move_companions(const fs::path& from, const fs::path& to) {
    if (std::string problem = outside(to); !problem.empty())
        return problem;
    const FolderLock lock(to.parent_path());
    if (!lock.held())
        return "Another program is using " + quoted(to) + "; try again.";
    const std::vector<Companion> companions = companions_of(from);
    for (const Companion& companion : companions)
        if (name_taken(beside(to, companion)))
            return quoted(beside(to, companion)) + " already exists, so nothing was moved.";
    std::vector<Companion> moved;
    for (const Companion& companion : companions) {
        const std::string reason = move_file(companion.file, beside(to, companion));
        if (reason.empty()) {
            moved.push_back(companion);
            continue;
        }
        for (const Companion& back : moved)
            move_file(beside(to, back), back.file);
        return quoted(companion.file) + " cannot be moved: " + reason;
    }
    return {};
}

std::string AlbumKeeper::restore(const std::string& id) { return restore(id, {}); }

std::string AlbumKeeper::restore(const std::string& id, const Behind& behind) {
    const auto entry = trash_.entry(id);
    if (!entry)
        return entry.error();
    auto note = tag_note(entry->note);
    if (!note)
        return trash_.restore(id);
    const fs::path photo = album_ / note->photo;
    if (const std::string problem = outside(photo); !problem.empty())
        return problem + " Bring the photograph back first, then its recording.";
    const auto place = free_place(tags_folder(photo) / note->tag.file);
    if (!place)
        return "The recording cannot be restored: " + place.error();
    note->tag.file = place->filename().string();
    if (std::string problem = trash_.restore(id, place->lexically_relative(album_)); !problem.empty())
        return problem;
    return list(photo, note->tag, behind);
}

} // namespace tp
