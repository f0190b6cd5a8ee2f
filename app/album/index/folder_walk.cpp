// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/folder_walk.hpp"

#include "core/files/file_words.hpp"

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// The first byte string after all that begin with `folder`/.
std::string below_begin(const fs::path& folder) {
    return folder.native().ends_with('/') ? folder.native() : folder.native() + '/';
}
std::string below_end(const fs::path& folder) {
    std::string end = below_begin(folder);
    end.back() = '/' + 1;
    return end;
}

bool lies_below(const fs::path& path, const fs::path& folder) {
    return path.native().starts_with(below_begin(folder));
}

} // namespace

FolderWalk::FolderWalk(SqlConnection& connection, std::stop_token stop)
    : connection_(connection), stop_(std::move(stop)) {}

void FolderWalk::walk(const fs::path& top) {
    std::error_code error;
    const fs::path real = fs::canonical(top, error);
    if (error) {
        const int reason = error.value();
        cannot_read(fs::weakly_canonical(top, error), reason);
        return;
    }
    if (!real.has_relative_path() && top.lexically_normal().has_relative_path()) {
        changes_.problems.push_back("The folder " + quoted(top) +
                                    " leads to the whole computer; it is left alone.");
        return;
    }
    held_.emplace_back(real);
    std::vector<fs::path> to_do{real};
    while (!to_do.empty() && !stop_.stop_requested()) {
        const fs::path folder = std::move(to_do.back());
        to_do.pop_back();
        if (!seen_.insert(folder.native()).second)
            continue;
        FolderListing listing = list_folder(folder);
        if (listing.error == ENOENT && folder != real) { // it has just gone
            seen_.erase(folder.native());
            continue;
        }
        if (listing.error != 0) {
            cannot_read(folder, listing.error);
            continue;
        }
        compare(folder, listing);
        tell_links(listing);
        for (ListedFolder& below : listing.folders)
            to_do.push_back(std::move(below.path));
    }
}

void FolderWalk::look_into(const fs::path& top) {
    std::error_code error;
    fs::path folder = fs::canonical(top, error);
    if (error.value() == ENOENT || error.value() == ENOTDIR) {
        lose_folders(top);
        return;
    }
    if (error) {
        cannot_read(top, error.value());
        return;
    }
    if (folder != top && stamp_of(top)) { // somebody put a link in its place, or in that of a folder above it
        lose_folders(top);
        changes_.problems.push_back(left_alone(top));
        return;
    }
    if (!seen_.insert(folder.native()).second)
        return;
    if (!foreign_place(folder / "name"))
        held_.emplace_back(folder);
    FolderListing listing = list_folder(folder);
    if (listing.error != 0) {
        cannot_read(folder, listing.error);
        return;
    }
    compare(folder, listing);
    tell_links(listing);
    for (const auto& [id, path] : present_folders(below_begin(folder), below_end(folder))) {
        const fs::path first = folder / *std::next(path.begin(), std::distance(folder.begin(), folder.end()));
        if (std::none_of(listing.folders.begin(), listing.folders.end(),
                         [&](const ListedFolder& below) { return below.path == first; }))
            lose_folder(id, path);
    }
    for (const ListedFolder& below : listing.folders) {
        const std::optional<std::string> stamp = stamp_of(below.path);
        if (!stamp)
            walk(below.path);
        else if (below.stamp.empty() || *stamp != below.stamp)
            look_into(below.path);
    }
}

void FolderWalk::tell_links(const FolderListing& listing) {
    for (const fs::path& link : listing.linked)
        changes_.problems.push_back(left_alone(link));
}

/// Finds what is new, changed or gone in one folder.
void FolderWalk::compare(const fs::path& folder, FolderListing& listing) {
    changes_.folders.emplace_back(folder, listing.stamp);
    std::map<std::string, StoredPhoto> stored = stored_in(folder);
    changes_.found += listing.photos.size();
    for (ListedPhoto& listed : listing.photos) {
        const auto known = stored.find(listed.name);
        if (known == stored.end()) {
            changes_.jobs.push_back({folder, std::move(listed), {}});
            continue;
        }
        StoredPhoto& photo = known->second;
        const bool same = !listed.stamp.empty() && photo.stamp == listed.stamp;
        const bool same_beside = !listed.beside.empty() && photo.beside == listed.beside;
        if (!same || !same_beside || photo.missing)
            changes_.jobs.push_back(
                {folder, std::move(listed), same ? std::move(photo.hash) : std::string()});
        stored.erase(known);
    }
    for (const auto& [name, photo] : stored)
        if (!photo.missing)
            changes_.gone.emplace_back(photo.id, folder / name);
}

std::map<std::string, FolderWalk::StoredPhoto> FolderWalk::stored_in(const fs::path& folder) {
    std::map<std::string, StoredPhoto> stored;
    SqlRun run = connection_.run("SELECT p.name, p.id, p.stamp, p.beside, p.hash, p.missing "
                                 "FROM photos p JOIN folders f ON f.id = p.folder WHERE f.path = ?",
                                 SqlBytes{folder.native()});
    while (run.next())
        stored[run.bytes(0)] = {run.integer(1), run.bytes(2), run.bytes(3), run.bytes(4),
                                run.integer(5) != 0};
    return stored;
}

void FolderWalk::cannot_read(const fs::path& folder, int error) {
    unreadable_.push_back(folder);
    const bool gone = error == ENOENT || error == ENOTDIR;
    changes_.problems.push_back("The folder " + quoted(folder) +
                                (gone              ? " is missing."
                                 : error == EACCES ? " cannot be opened: you are not allowed to."
                                                   : " cannot be read: " + reason_of(error)));
}

std::vector<std::pair<std::int64_t, fs::path>> FolderWalk::present_folders(const std::string& from,
                                                                           const std::string& to) {
    std::vector<std::pair<std::int64_t, fs::path>> folders;
    SqlRun run = connection_.run("SELECT id, path FROM folders WHERE present = 1 AND path >= ? AND path < ?",
                                 SqlBytes{from}, SqlBytes{to});
    while (run.next())
        folders.emplace_back(run.integer(0), run.bytes(1));
    return folders;
}

/// How a folder looked when it was walked; none: it is not in the index.
std::optional<std::string> FolderWalk::stamp_of(const fs::path& folder) {
    SqlRun run = connection_.run("SELECT stamp FROM folders WHERE present = 1 AND path = ?",
                                 SqlBytes{folder.native()});
    return run.next() ? std::optional(run.bytes(0)) : std::nullopt;
}

void FolderWalk::lose_folder(std::int64_t id, const fs::path& folder) {
    changes_.lost_folders.push_back(id);
    for (const auto& [name, photo] : stored_in(folder))
        if (!photo.missing)
            changes_.gone.emplace_back(photo.id, folder / name);
}

void FolderWalk::lose_folders(const fs::path& top) {
    for (const auto& [id, path] : present_folders(below_begin(top), below_end(top)))
        lose_folder(id, path);
    for (const auto& [id, path] : present_folders(top.native(), top.native() + '\0'))
        lose_folder(id, path);
}

void FolderWalk::miss_unseen_folders() {
    for (const auto& [id, path] : present_folders("", "0")) // absolute paths begin with '/'
        if (!seen_.contains(path.native()) &&
            std::none_of(unreadable_.begin(), unreadable_.end(), [&path = path](const fs::path& folder) {
                return path == folder || lies_below(path, folder);
            }))
            lose_folder(id, path);
}

} // namespace tp
