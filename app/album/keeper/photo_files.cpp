// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/photo_files.hpp"

#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/open_file.hpp"
#include "core/files/photo_endings.hpp"

#include <QCryptographicHash>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// `other` is the name or the stem and then .xmp, in capitals or not.
bool is_sidecar_of(const std::string& name, const std::string& other) {
    return other.size() == name.size() + 4 && other.starts_with(name) && small_ending(other) == ".xmp";
}

using Names = std::span<const std::string>; ///< in order

/// Those that begin so.
Names beginning_with(Names names, const std::string& beginning) {
    const auto first = std::lower_bound(names.begin(), names.end(), beginning);
    const auto last = std::find_if_not(first, names.end(),
                                       [&](const std::string& name) { return name.starts_with(beginning); });
    return {first, last};
}

/// Whether what is named by this photograph's stem may be another one's: of its stem, or of the stem as its
/// name.
bool shares_its_stem(Names names, const fs::path& photo) {
    if (std::binary_search(names.begin(), names.end(), photo.stem().string()))
        return true;
    const Names alike = beginning_with(names, photo.stem().string() + '.');
    return std::any_of(alike.begin(), alike.end(), [&](const fs::path& other) {
        return other != photo.filename() && other.stem() == photo.stem() && has_photo_name(other);
    });
}

/// Whether a folder holds photographs, or what is an album's.
bool looks_like_album(const fs::path& folder) {
    const std::vector<FolderEntry> entries = entries_of(folder);
    return std::any_of(entries.begin(), entries.end(), [](const FolderEntry& entry) {
        return entry.name == ".touchphoto" || has_photo_name(entry.name) || entry.name.ends_with(".tags") ||
               small_ending(entry.name) == ".xmp";
    });
}

/// Whether a person's own folders lie in it, where a link is theirs: ~/Pictures on another disk.
bool is_above_home(const fs::path& folder) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing in the program changes its environment while threads run
    const char* const home = std::getenv("HOME");
    const fs::path own = fs::path(home != nullptr ? home : "").lexically_normal();
    return !own.empty() &&
           std::mismatch(folder.begin(), folder.end(), own.begin(), own.end()).first == folder.end();
}

/// The outermost album in which a link lies that this way goes by.
std::optional<fs::path> album_with_link_to(const fs::path& folder) {
    fs::path above, here;
    for (const fs::path& name : folder) {
        above = std::exchange(here, here / name);
        if (name.has_filename() && link_there(here) && !is_above_home(above) && looks_like_album(above))
            return above;
    }
    return std::nullopt;
}

} // namespace

fs::path tags_folder(const fs::path& photo) { return fs::path(photo) += ".tags"; }
fs::path contours_file(const fs::path& photo) { return fs::path(photo) += ".contours.svg"; }

bool is_own_folder(const fs::path& folder) { return folder.filename() == ".touchphoto"; }

fs::path album_around(const fs::path& photo) {
    if (auto album = album_with_link_to(photo.parent_path()))
        return *std::move(album);
    for (fs::path folder = photo.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
        if (folder_there(folder / ".touchphoto") || link_there(folder / ".touchphoto"))
            return folder;
    return photo.parent_path();
}

std::vector<Companion> companions_of(const fs::path& photo, std::vector<fs::path>* left) {
    return FolderCompanions().of(photo, left);
}

void FolderCompanions::read(const fs::path& folder) {
    folder_ = folder;
    names_.clear();
    left_.clear();
    for (const FolderEntry& entry : entries_of(folder, &fault_)) {
        names_.push_back(entry.name);
        if (entry.link || entry.facts.kind == FileFacts::Kind::other)
            left_.insert(entry.name);
    }
}

std::vector<Companion> FolderCompanions::of(const fs::path& photo, std::vector<fs::path>* left) {
    if (folder_ != photo.parent_path())
        read(photo.parent_path());
    std::vector<Companion> found;
    const auto add = [&](Companion companion, const std::string& called) {
        if (!left_.contains(called))
            found.push_back(std::move(companion));
        else if (left)
            left->push_back(companion.file);
    };
    const std::string name = photo.filename().string();
    for (const std::string& other : beginning_with(names_, name)) {
        const fs::path place = photo.parent_path() / other;
        const std::string suffix = other.substr(name.size());
        const auto original = conflict_original(other); // another machine's sidecar, not merged yet
        if (is_sidecar_of(name, other) || (original && is_sidecar_of(name, *original)) ||
            place == contours_file(photo) || place == tags_folder(photo))
            add({place, suffix, false}, other);
    }
    for (const std::string& other : beginning_with(names_, photo.stem().string() + '.')) {
        const fs::path place = photo.parent_path() / other;
        if (is_sidecar_of(photo.stem().string(), other) && !other.starts_with(name) &&
            !shares_its_stem(names_, photo))
            add({place, place.extension().string(), true}, other);
    }
    return found;
}

fs::path numbered(const fs::path& place, int number) {
    if (number == 1)
        return place;
    fs::path name = place.stem();
    name += " (" + std::to_string(number) + ")";
    name += place.extension();
    return place.parent_path() / name;
}

fs::path beside(const fs::path& photo, const Companion& companion) {
    fs::path base = companion.by_stem ? photo.parent_path() / photo.stem() : photo;
    return base += companion.suffix;
}

std::uintmax_t size_or_zero(const fs::path& file) {
    const auto facts = facts_of(file);
    return facts && facts->kind == FileFacts::Kind::file ? facts->bytes : 0;
}

Result<std::string> content_hash(const fs::path& file) {
    const Error unreadable{"The file " + quoted(file) + " cannot be read."};
    OpenFile opened(file, {.looked_at = true});
    const auto facts = opened.ok() ? opened.facts() : std::nullopt;
    if (!facts || facts->kind != FileFacts::Kind::file)
        return unreadable;
    QCryptographicHash hash(QCryptographicHash::Sha256);
    std::array<char, 1 << 16> block{};
    while (true) {
        const std::int64_t count = opened.read(block);
        if (count < 0)
            return unreadable;
        if (count == 0)
            return hash.result().toHex().toStdString();
        hash.addData(QByteArrayView(block.data(), static_cast<qsizetype>(count)));
    }
}

} // namespace tp
