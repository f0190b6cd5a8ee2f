// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/folder_listing.hpp"

#include "app/album/index/photo_content.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/file_system.hpp"
#include "core/files/new_file.hpp"
#include "core/files/open_folder.hpp"

#include <QCryptographicHash>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view recordings_end = ".tags";

/// What is not hidden, by name; the system's number in `error` where it would not say.
std::vector<FolderEntry> entries_of(const OpenFolder& folder, int& error) {
    return folder.entries(
        [](std::string_view name) { return !name.starts_with('.') && !is_temporary(std::string(name)); },
        error);
}

/// Joins what a file shows of its state. The system stamps changes with a clock that stands still for some
/// milliseconds: of a file that changed in this very tick a further change might leave the same stamp.
class Stamp {
public:
    void add(const FileFacts& facts) {
        constexpr std::int64_t tick_ns = 10'000'000; // CONFIG_HZ=100, the slowest
        number(static_cast<std::int64_t>(facts.bytes));
        number(facts.written_ns);
        number(facts.changed_ns);
        number(static_cast<std::int64_t>(facts.identity.second));
        settled_ = settled_ && std::abs(facts.changed_ns - now_ns_) > tick_ns;
    }
    void add(std::string_view name) {
        number(static_cast<std::int64_t>(name.size()));
        bytes_ += name;
    }

    std::string result() const {
        if (!settled_)
            return {};
        return QCryptographicHash::hash({bytes_.data(), static_cast<qsizetype>(bytes_.size())},
                                        QCryptographicHash::Md5)
            .toStdString();
    }

private:
    void number(std::int64_t value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }

    std::string bytes_;
    std::int64_t now_ns_ = file_clock_ns();
    bool settled_ = true;
};

std::string stamp_of(const FileFacts& facts) {
    Stamp stamp;
    stamp.add(facts);
    return stamp.result();
}

/// "IMG_1" and what goes on with something else than a letter or digit belong together.
bool goes_with(std::string_view stem, std::string_view name) {
    const unsigned char next =
        name.size() > stem.size() ? static_cast<unsigned char>(name[stem.size()]) : 'x';
    return name.starts_with(stem) && std::isalnum(next) == 0 && next < 0x80;
}

void add_recordings(Stamp& stamp, const fs::path& folder) {
    const OpenFolder opened(folder);
    if (!opened.ok())
        return;
    int error = 0;
    for (const FolderEntry& recording : entries_of(opened, error)) {
        stamp.add(recording.name);
        stamp.add(recording.facts);
    }
}

std::string stamp_beside(const fs::path& folder, const std::vector<FolderEntry>& entries,
                         std::string_view photo) {
    const std::string_view stem = photo.substr(0, std::max<std::size_t>(photo.rfind('.'), 1));
    Stamp stamp;
    auto entry = std::lower_bound(entries.begin(), entries.end(), stem,
                                  [](const FolderEntry& e, std::string_view name) { return e.name < name; });
    for (; entry != entries.end() && entry->name.starts_with(stem); ++entry) {
        const bool is_folder = entry->facts.kind == FileFacts::Kind::folder;
        if (!goes_with(stem, entry->name) ||
            (is_folder ? !is_recordings_folder(entry->name) : has_photo_name(entry->name)))
            continue;
        stamp.add(entry->name);
        stamp.add(entry->facts);
        if (is_folder)
            add_recordings(stamp, folder / entry->name);
    }
    return stamp.result();
}

/// Of what the name leads to; a photograph may be a link itself.
FileFacts facts_looked_at(const fs::path& folder, const FolderEntry& entry) {
    const bool own = !entry.link || entry.facts.kind != FileFacts::Kind::link;
    return own ? entry.facts : facts_of_photo(folder / entry.name).value_or(entry.facts);
}

} // namespace

FolderListing list_folder(const fs::path& folder) {
    FolderListing listing;
    const OpenFolder opened(folder);
    if (!opened.ok()) {
        listing.error = errno;
        return listing;
    }
    if (opened.is_of_kernel()) // nobody's photographs
        return listing;
    if (const auto facts = opened.facts())
        listing.stamp = stamp_of(*facts);
    const std::vector<FolderEntry> entries = entries_of(opened, listing.error);
    for (const FolderEntry& entry : entries) {
        const FileFacts facts = facts_looked_at(folder, entry);
        if (facts.kind == FileFacts::Kind::folder) {
            if (entry.link)
                listing.linked.push_back(folder / entry.name);
            else if (!is_recordings_folder(entry.name))
                listing.folders.push_back({folder / entry.name, stamp_of(facts)});
        } else if (facts.kind == FileFacts::Kind::file &&
                   (entry.link ? has_photo_name(entry.name) : may_be_photo(entry.name))) {
            listing.photos.push_back({entry.name, static_cast<std::int64_t>(facts.bytes), facts.written_ns,
                                      static_cast<std::int64_t>(facts.identity.second), stamp_of(facts),
                                      stamp_beside(folder, entries, entry.name)});
        }
    }
    return listing;
}

std::string folder_stamp(const fs::path& folder) {
    const auto facts = facts_of(folder);
    return facts ? stamp_of(*facts) : "gone";
}

std::vector<fs::path> recordings_of(const fs::path& photo) {
    const fs::path folder = recordings_folder(photo);
    std::vector<fs::path> recordings;
    if (const OpenFolder opened(folder); opened.ok()) {
        int error = 0;
        for (const FolderEntry& entry : entries_of(opened, error))
            if (!entry.link && entry.facts.kind == FileFacts::Kind::file)
                recordings.push_back(folder / entry.name);
    }
    return recordings;
}

fs::path recordings_folder(const fs::path& photo) {
    fs::path folder = photo;
    folder += recordings_end;
    return folder;
}

bool is_recordings_folder(const fs::path& folder) {
    return folder.filename().string().ends_with(recordings_end);
}

} // namespace tp
