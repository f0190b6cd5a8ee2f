// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_scan.hpp"

#include "app/album/index/folder_listing.hpp"
#include "app/album/index/folder_walk.hpp"
#include "app/album/index/photo_content.hpp"
#include "app/album/index/photo_store.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "audio/recordings/wav_part.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"

#include <cerrno>
#include <set>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

class Scan {
public:
    Scan(AlbumIndex& index, const ScanTools& tools)
        : index_(index), connection_(index.connection()), tools_(tools), walk_(connection_, tools.stop),
          changes_(walk_.changes()) {}

    ScanReport album(const std::vector<fs::path>& folders) {
        for (const fs::path& folder : folders)
            walk_.walk(folder);
        read_jobs();
        if (!stopped())
            walk_.miss_unseen_folders();
        return finish();
    }

    ScanReport some(const std::vector<fs::path>& folders) {
        for (const fs::path& folder : folders)
            walk_.look_into(is_recordings_folder(folder) ? folder.parent_path() : folder);
        read_jobs();
        return finish();
    }

private:
    bool stopped() const { return tools_.stop.stop_requested(); }

    // ---- reading

    void read_jobs() {
        report_.found = changes_.found;
        report_.problems = changes_.problems;
        constexpr std::size_t most_photos = 200;
        constexpr std::int64_t most_bytes = 64 << 20; // what a kill makes the next scan read again
        const auto begin = std::chrono::steady_clock::now();
        const auto cost = [](const FolderChanges::Job& job) {
            return 100'000.0 + static_cast<double>(job.listed.size);
        };
        double cost_left = 0.0, cost_done = 0.0;
        for (const FolderChanges::Job& job : changes_.jobs)
            cost_left += cost(job);
        std::vector<PhotoFacts> batch;
        std::int64_t batch_bytes = 0;
        for (std::size_t i = 0; i < changes_.jobs.size(); ++i) {
            FolderChanges::Job& job = changes_.jobs[i];
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
                tools_.progress({i + 1, changes_.jobs.size(), photo,
                                 std::chrono::milliseconds(
                                     static_cast<std::int64_t>(spent.count() * cost_left / cost_done))});
        }
        put(batch);
    }

    /// None: it is no photograph, it is gone, or the scan is stopped.
    std::optional<PhotoFacts> read(FolderChanges::Job& job, const fs::path& photo) {
        PhotoFacts facts{job.folder, std::move(job.listed), std::move(job.known_hash), {}};
        if (facts.sha256.empty()) {
            int error = 0;
            const std::optional<PhotoContent> content = read_photo_content(photo, tools_.stop, error);
            if (error == ENOENT || error == ENOTDIR || (!content && error == 0))
                return std::nullopt;
            if (content && !content->photo) {
                if (has_photo_name(facts.listed.name))
                    report_.problems.push_back("The file " + quoted(photo) +
                                               " is named like a photograph, but is not one.");
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
            const bool is_made_now = recording.native().ends_with(wav_part_end); // and may hold nothing yet
            if (Result<Tag> tag = tools_.read_recording(recording))
                facts.record.tags.push_back(std::move(*tag));
            else if (!is_made_now)
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
        // What lies in a folder that was walked, another process saw after this one did not.
        for (const auto& [id, path] : changes_.gone)
            if (const auto facts = facts_of_photo(path);
                !facts || facts->kind != FileFacts::Kind::file || !walk_.was_walked(path.parent_path())) {
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
        if (report_.missing > 0) // after all that came, for it may have moved
            forget_faces_of_missing(connection_);
        for (const std::int64_t id : changes_.lost_folders)
            connection_.run("UPDATE folders SET present = 0 WHERE id = ?", id);
        connection_.run("DELETE FROM folders WHERE present = 0 AND NOT EXISTS "
                        "(SELECT 1 FROM photos WHERE photos.folder = folders.id)");
        all.commit();
    }

    void put_folders() {
        SqlTransaction all(connection_);
        for (const auto& [folder, stamp] : changes_.folders)
            put_folder(connection_, folder, stamp);
        all.commit();
    }

    AlbumIndex& index_;
    SqlConnection& connection_;
    const ScanTools& tools_;
    FolderWalk walk_;
    FolderChanges& changes_;
    ScanReport report_;
    std::vector<fs::path> no_photos_;
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
