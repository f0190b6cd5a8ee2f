// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/folder_listing.hpp"

#include "app/album/index/photo_content.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/new_file.hpp"

#include <QCryptographicHash>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <optional>
#include <string_view>
#include <sys/stat.h>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view recordings_end = ".tags";

struct Entry {
    std::string name;
    struct stat about {};
    bool link = false;
};

struct CloseFolder {
    void operator()(DIR* folder) const { ::closedir(folder); }
};
using OpenFolder = std::unique_ptr<DIR, CloseFolder>;

std::int64_t ns(const timespec& time) { return time.tv_sec * 1'000'000'000LL + time.tv_nsec; }

/// What is not hidden, by name; the system's number in `error` where it would not say.
std::vector<Entry> entries_of(DIR* folder, int& error) {
    std::vector<Entry> entries;
    errno = 0;
    while (const dirent* item = ::readdir(folder)) {
        Entry entry;
        entry.name = item->d_name;
        const bool wanted = !entry.name.starts_with('.') && !is_temporary(entry.name);
        if (wanted && ::fstatat(::dirfd(folder), item->d_name, &entry.about, AT_SYMLINK_NOFOLLOW) == 0) {
            entry.link = S_ISLNK(entry.about.st_mode);
            if (!entry.link || ::fstatat(::dirfd(folder), item->d_name, &entry.about, 0) == 0)
                entries.push_back(std::move(entry));
        }
        errno = 0; // a link to nothing, or a file that has just gone
    }
    error = errno;
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
    return entries;
}

/// Joins what a file shows of its state. The system stamps changes with a clock that stands still for some
/// milliseconds: of a file that changed in this very tick a further change might leave the same stamp.
class Stamp {
public:
    Stamp() {
        timespec now{};
        ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
        now_ns_ = ns(now);
    }

    void add(const struct stat& about) {
        constexpr std::int64_t tick_ns = 10'000'000; // CONFIG_HZ=100, the slowest
        number(about.st_size);
        number(ns(about.st_mtim));
        number(ns(about.st_ctim));
        number(static_cast<std::int64_t>(about.st_ino));
        settled_ = settled_ && std::abs(ns(about.st_ctim) - now_ns_) > tick_ns;
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
    std::int64_t now_ns_ = 0;
    bool settled_ = true;
};

std::string stamp_of(const struct stat& about) {
    Stamp stamp;
    stamp.add(about);
    return stamp.result();
}

/// "IMG_1" and what goes on with something else than a letter or digit belong together.
bool goes_with(std::string_view stem, std::string_view name) {
    const unsigned char next =
        name.size() > stem.size() ? static_cast<unsigned char>(name[stem.size()]) : 'x';
    return name.starts_with(stem) && std::isalnum(next) == 0 && next < 0x80;
}

void add_recordings(Stamp& stamp, int folder, const Entry& entry) {
    const int descriptor = ::openat(folder, entry.name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const OpenFolder opened(descriptor < 0 ? nullptr : ::fdopendir(descriptor));
    if (!opened)
        return;
    int error = 0;
    for (const Entry& recording : entries_of(opened.get(), error)) {
        stamp.add(recording.name);
        stamp.add(recording.about);
    }
}

std::string stamp_beside(int folder, const std::vector<Entry>& entries, std::string_view photo) {
    const std::string_view stem = photo.substr(0, std::max<std::size_t>(photo.rfind('.'), 1));
    Stamp stamp;
    auto entry = std::lower_bound(entries.begin(), entries.end(), stem,
                                  [](const Entry& e, std::string_view name) { return e.name < name; });
    for (; entry != entries.end() && entry->name.starts_with(stem); ++entry) {
        const bool is_folder = S_ISDIR(entry->about.st_mode);
        if (!goes_with(stem, entry->name) ||
            (is_folder ? !is_recordings_folder(entry->name) : has_photo_name(entry->name)))
            continue;
        stamp.add(entry->name);
        stamp.add(entry->about);
        if (is_folder)
            add_recordings(stamp, folder, *entry);
    }
    return stamp.result();
}

/// Where a folder in `folder` is walked; none where it is not.
std::optional<fs::path> walked(const fs::path& folder, const Entry& entry) {
    if (is_recordings_folder(entry.name))
        return std::nullopt;
    if (!entry.link)
        return folder / entry.name;
    std::error_code error;
    const fs::path target = fs::canonical(folder / entry.name, error);
    const auto [end, rest] = std::mismatch(target.begin(), target.end(), folder.begin(), folder.end());
    if (error || end == target.end() || target.filename().string().starts_with('.'))
        return std::nullopt;
    return target;
}

} // namespace

FolderListing list_folder(const fs::path& folder) {
    FolderListing listing;
    const OpenFolder opened(::opendir(folder.c_str()));
    if (!opened) {
        listing.error = errno;
        return listing;
    }
    if (struct stat about{}; ::fstat(::dirfd(opened.get()), &about) == 0)
        listing.stamp = stamp_of(about);
    const std::vector<Entry> entries = entries_of(opened.get(), listing.error);
    for (const Entry& entry : entries) {
        if (S_ISDIR(entry.about.st_mode)) {
            if (auto path = walked(folder, entry))
                listing.folders.push_back({std::move(*path), stamp_of(entry.about)});
        } else if (S_ISREG(entry.about.st_mode) && may_be_photo(entry.name)) {
            listing.photos.push_back({entry.name, entry.about.st_size, ns(entry.about.st_mtim),
                                      static_cast<std::int64_t>(entry.about.st_ino), stamp_of(entry.about),
                                      stamp_beside(::dirfd(opened.get()), entries, entry.name)});
        }
    }
    return listing;
}

std::string folder_stamp(const fs::path& folder) {
    struct stat about {};
    return ::stat(folder.c_str(), &about) == 0 ? stamp_of(about) : "gone";
}

std::vector<fs::path> recordings_of(const fs::path& photo) {
    const fs::path folder = recordings_folder(photo);
    std::vector<fs::path> recordings;
    if (const OpenFolder opened(::opendir(folder.c_str())); opened) {
        int error = 0;
        for (const Entry& entry : entries_of(opened.get(), error))
            if (S_ISREG(entry.about.st_mode))
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
