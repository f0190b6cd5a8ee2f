// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_scan.hpp"

#include "app/album/index/folder_listing.hpp"
#include "app/album/index/photo_content.hpp"
#include "app/album/index/photo_store.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cerrno>
#include <map>
#include <set>
#include <sys/stat.h>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// A photograph to read: a new one, or one that changed.
struct Job {
    fs::path folder;
    ListedPhoto listed;
    std::string known_hash; ///< its content did not change
};

struct StoredPhoto {
    PhotoId id = 0;
    std::string stamp, beside, hash;
    bool missing = false;
};

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

class Scan {
public:
    Scan(AlbumIndex& index, const ScanTools& tools)
        : index_(index), connection_(index.connection()), tools_(tools) {}

    ScanReport album(const std::vector<fs::path>& folders) {
        for (const fs::path& folder : folders)
            walk(folder);
        read_jobs();
        if (!stopped())
            miss_unseen_folders();
        return finish();
    }

    ScanReport some(const std::vector<fs::path>& folders) {
        for (const fs::path& folder : folders)
            look_into(is_recordings_folder(folder) ? folder.parent_path() : folder);
        read_jobs();
        return finish();
    }

private:
    bool stopped() const { return tools_.stop.stop_requested(); }

    // ---- what is there

    /// Takes a folder and all below it.
    void walk(const fs::path& top) {
        std::error_code error;
        const fs::path real = fs::canonical(top, error);
        if (error) {
            cannot_read(fs::weakly_canonical(top, ignored_), error.value());
            return;
        }
        std::vector<fs::path> to_do{real};
        while (!to_do.empty() && !stopped()) {
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
            for (ListedFolder& below : listing.folders)
                to_do.push_back(std::move(below.path));
        }
    }

    /// Takes one folder, and of those in it the ones that are new, gone, or look otherwise than they did.
    void look_into(const fs::path& top) {
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
        if (!seen_.insert(folder.native()).second)
            return;
        FolderListing listing = list_folder(folder);
        if (listing.error != 0) {
            cannot_read(folder, listing.error);
            return;
        }
        compare(folder, listing);
        for (const auto& [id, path] : present_folders(below_begin(folder), below_end(folder))) {
            const fs::path first =
                folder / *std::next(path.begin(), std::distance(folder.begin(), folder.end()));
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

    /// Finds what is new, changed or gone in one folder.
    void compare(const fs::path& folder, FolderListing& listing) {
        folders_.emplace_back(folder, listing.stamp);
        std::map<std::string, StoredPhoto> stored = stored_in(folder);
        report_.found += listing.photos.size();
        for (ListedPhoto& listed : listing.photos) {
            const auto known = stored.find(listed.name);
            if (known == stored.end()) {
                jobs_.push_back({folder, std::move(listed), {}});
                continue;
            }
            StoredPhoto& photo = known->second;
            const bool same = !listed.stamp.empty() && photo.stamp == listed.stamp;
            const bool same_beside = !listed.beside.empty() && photo.beside == listed.beside;
            if (!same || !same_beside || photo.missing)
                jobs_.push_back({folder, std::move(listed), same ? std::move(photo.hash) : std::string()});
            stored.erase(known);
        }
        for (const auto& [name, photo] : stored)
            if (!photo.missing)
                gone_.emplace_back(photo.id, folder / name);
    }

    std::map<std::string, StoredPhoto> stored_in(const fs::path& folder) {
        std::map<std::string, StoredPhoto> stored;
        SqlRun run = connection_.run("SELECT p.name, p.id, p.stamp, p.beside, p.hash, p.missing "
                                     "FROM photos p JOIN folders f ON f.id = p.folder WHERE f.path = ?",
                                     SqlBytes{folder.native()});
        while (run.next())
            stored[run.bytes(0)] = {run.integer(1), run.bytes(2), run.bytes(3), run.bytes(4),
                                    run.integer(5) != 0};
        return stored;
    }

    void cannot_read(const fs::path& folder, int error) {
        unreadable_.push_back(folder);
        const bool gone = error == ENOENT || error == ENOTDIR;
        report_.problems.push_back("The folder " + quoted(folder) +
                                   (gone              ? " is not there."
                                    : error == EACCES ? " may not be opened by you."
                                                      : " cannot be read: " + reason_of(error)));
    }

    // ---- folders

    std::vector<std::pair<std::int64_t, fs::path>> present_folders(const std::string& from,
                                                                   const std::string& to) {
        std::vector<std::pair<std::int64_t, fs::path>> folders;
        SqlRun run =
            connection_.run("SELECT id, path FROM folders WHERE present = 1 AND path >= ? AND path < ?",
                            SqlBytes{from}, SqlBytes{to});
        while (run.next())
            folders.emplace_back(run.integer(0), run.bytes(1));
        return folders;
    }

    /// How a folder looked when it was walked; none: it is not in the index.
    std::optional<std::string> stamp_of(const fs::path& folder) {
        SqlRun run = connection_.run("SELECT stamp FROM folders WHERE present = 1 AND path = ?",
                                     SqlBytes{folder.native()});
        return run.next() ? std::optional(run.bytes(0)) : std::nullopt;
    }

    void put_folders() {
        SqlTransaction all(connection_);
        for (const auto& [folder, stamp] : folders_)
            put_folder(connection_, folder, stamp);
        all.commit();
    }

    void lose_folder(std::int64_t id, const fs::path& folder) {
        lost_folders_.push_back(id);
        for (const auto& [name, photo] : stored_in(folder))
            if (!photo.missing)
                gone_.emplace_back(photo.id, folder / name);
    }

    void lose_folders(const fs::path& top) {
        for (const auto& [id, path] : present_folders(below_begin(top), below_end(top)))
            lose_folder(id, path);
        for (const auto& [id, path] : present_folders(top.native(), top.native() + '\0'))
            lose_folder(id, path);
    }

    /// Of folders that cannot be read nobody knows what is in them: they stay as they were.
    void miss_unseen_folders() {
        for (const auto& [id, path] : present_folders("", "0")) // absolute paths begin with '/'
            if (!seen_.contains(path.native()) &&
                std::none_of(unreadable_.begin(), unreadable_.end(), [&path = path](const fs::path& folder) {
                    return path == folder || lies_below(path, folder);
                }))
                lose_folder(id, path);
    }

    // ---- reading

    void read_jobs() {
        constexpr std::size_t most_photos = 200;
        constexpr std::int64_t most_bytes = 64 << 20; // what a kill makes the next scan read again
        const auto begin = std::chrono::steady_clock::now();
        const auto cost = [](const Job& job) { return 100'000.0 + static_cast<double>(job.listed.size); };
        double cost_left = 0.0, cost_done = 0.0;
        for (const Job& job : jobs_)
            cost_left += cost(job);
        std::vector<PhotoFacts> batch;
        std::int64_t batch_bytes = 0;
        for (std::size_t i = 0; i < jobs_.size(); ++i) {
            Job& job = jobs_[i];
            if (stopped())
                break;
            cost_left -= cost(job);
            cost_done += cost(job);
            batch_bytes += job.listed.size;
            const fs::path photo = job.folder / job.listed.name;
            if (std::optional<PhotoFacts> facts = read(job, photo))
                batch.push_back(std::move(*facts));
            if (batch.size() >= most_photos || batch_bytes > most_bytes) {
                put(batch);
                batch_bytes = 0;
            }
            const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
            if (tools_.progress)
                tools_.progress({i + 1, jobs_.size(), photo,
                                 std::chrono::milliseconds(
                                     static_cast<std::int64_t>(spent.count() * cost_left / cost_done))});
        }
        put(batch);
    }

    /// None: it is no photograph, it is gone, or the scan is stopped.
    std::optional<PhotoFacts> read(Job& job, const fs::path& photo) {
        PhotoFacts facts{job.folder, std::move(job.listed), std::move(job.known_hash), {}};
        if (facts.sha256.empty()) {
            int error = 0;
            const std::optional<PhotoContent> content = read_photo_content(photo, tools_.stop, error);
            if (error == ENOENT || error == ENOTDIR || (!content && error == 0))
                return std::nullopt;
            if (content && !content->photo) {
                if (has_photo_name(facts.listed.name))
                    report_.problems.push_back("The file " + quoted(photo) +
                                               " is called a photograph, but is none.");
                no_photos_.push_back(photo);
                return std::nullopt;
            }
            if (content) {
                facts.sha256 = content->sha256;
                ++report_.hashed;
            } else {
                facts.record.problems.push_back(
                    "The photograph " + quoted(photo) + " cannot be read" +
                    (error == EACCES ? std::string(": you are not allowed to.") : ": " + reason_of(error)));
            }
        }
        if (!facts.sha256.empty())
            read_record(facts, photo);
        ++report_.read;
        for (const std::string& problem : facts.record.problems)
            report_.problems.push_back(problem);
        return facts;
    }

    void read_record(PhotoFacts& facts, const fs::path& photo) {
        if (Result<PhotoRecord> record = tools_.read_record(photo))
            facts.record = std::move(*record);
        else
            facts.record.problems.push_back(record.error());
        if (!tools_.read_recording)
            return;
        std::set<std::string> listed;
        for (const Tag& tag : facts.record.tags)
            listed.insert(tag.file);
        for (const fs::path& recording : recordings_of(photo)) {
            if (listed.contains(recording.filename().native()))
                continue;
            if (Result<Tag> tag = tools_.read_recording(recording))
                facts.record.tags.push_back(std::move(*tag));
            else
                facts.record.problems.push_back(tag.error());
        }
    }

    void put(std::vector<PhotoFacts>& batch) {
        if (batch.empty())
            return;
        SqlTransaction all(connection_);
        for (const PhotoFacts& facts : batch)
            put_photo(connection_, facts);
        all.commit();
        batch.clear();
    }

    // ---- the end

    ScanReport finish() {
        report_.stopped = stopped();
        if (!report_.stopped) {
            put_folders();
            miss();
        }
        if (report_.hashed > 0 || report_.missing > 0) {
            if (auto moves = index_.moves())
                report_.moves = std::move(*moves);
            if (auto duplicates = index_.duplicates())
                report_.duplicates = std::move(*duplicates);
        }
        return std::move(report_);
    }

    void miss() {
        SqlTransaction all(connection_);
        for (const auto& [id, path] : gone_)
            if (struct stat about{};
                ::stat(path.c_str(), &about) != 0 || !S_ISREG(about.st_mode) || !is_in_album(path)) {
                miss_photo(connection_, id);
                ++report_.missing;
            }
        for (const fs::path& path : no_photos_) { // what was a photograph before it was written over
            SqlRun run =
                connection_.run("SELECT p.id FROM photos p JOIN folders f ON f.id = p.folder "
                                "WHERE f.path = ? AND p.name = ? AND p.missing = 0",
                                SqlBytes{path.parent_path().native()}, SqlBytes{path.filename().native()});
            if (run.next()) {
                miss_photo(connection_, run.integer(0));
                ++report_.missing;
            }
        }
        for (const std::int64_t id : lost_folders_)
            connection_.run("UPDATE folders SET present = 0 WHERE id = ?", id);
        connection_.run("DELETE FROM folders WHERE present = 0 AND NOT EXISTS "
                        "(SELECT 1 FROM photos WHERE photos.folder = folders.id)");
        all.commit();
    }

    /// Whether its folder was walked: then another process saw the photograph after this one did not.
    bool is_in_album(const fs::path& photo) const { return seen_.contains(photo.parent_path().native()); }

    AlbumIndex& index_;
    SqlConnection& connection_;
    const ScanTools& tools_;
    ScanReport report_;
    std::error_code ignored_;
    std::set<std::string> seen_;                            ///< folders that were walked
    std::vector<std::pair<fs::path, std::string>> folders_; ///< those that could be read, with their stamps
    std::vector<fs::path> unreadable_;
    std::vector<Job> jobs_;
    std::vector<std::pair<PhotoId, fs::path>> gone_;
    std::vector<fs::path> no_photos_;
    std::vector<std::int64_t> lost_folders_;
};

} // namespace

Result<ScanReport> scan_album(AlbumIndex& index, const std::vector<fs::path>& folders,
                              const ScanTools& tools) {
    return index.guarded([&] { return Scan(index, tools).album(folders); });
}

Result<ScanReport> rescan_folders(AlbumIndex& index, const std::vector<fs::path>& folders,
                                  const ScanTools& tools) {
    return index.guarded([&] { return Scan(index, tools).some(folders); });
}

} // namespace tp
