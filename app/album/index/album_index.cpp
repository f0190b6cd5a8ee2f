// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_index.hpp"

#include "app/album/index/folder_listing.hpp"
#include "app/album/index/index_dump.hpp"
#include "app/album/index/index_file.hpp"
#include "app/album/index/photo_store.hpp"
#include "app/album/index/schema.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"

#include <QSqlDatabase>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr const char* no_driver = "Qt's driver for SQLite is not installed; without it there is no album. On "
                                  "Debian it is the package libqt6sql6-sqlite.";

/// The path of a photograph in a row whose columns begin with its folder's path and its name.
fs::path path_in(const SqlRun& row) { return fs::path(row.bytes(0)) / row.bytes(1); }

std::vector<fs::path> paths_in(SqlRun run) {
    std::vector<fs::path> paths;
    while (run.next())
        paths.push_back(path_in(run));
    return paths;
}

/// One of each file: a link, or a second name, is the same file.
std::vector<fs::path> different_files(const std::vector<fs::path>& paths) {
    std::vector<fs::path> different;
    std::set<std::pair<std::uint64_t, std::uint64_t>> files;
    for (const fs::path& path : paths) {
        const auto facts = facts_of_photo(path);
        if (facts && files.insert(facts->identity).second)
            different.push_back(path);
    }
    return different;
}

} // namespace

Result<AlbumIndex> AlbumIndex::open(const fs::path& cache) {
    if (!QSqlDatabase::isDriverAvailable(QStringLiteral("QSQLITE")))
        return Error{no_driver};
    std::vector<std::string> notices;
    Result<IndexFile> file = IndexFile::open(cache, notices);
    if (file) {
        AlbumIndex index(std::move(file->connection), file->path);
        index.notices_ = std::move(notices);
        return index;
    }
    Result<AlbumIndex> index = in_memory();
    if (index)
        index->notices_ = {"The album's index cannot be kept in " + quoted(cache) +
                           "; it is held in memory and rebuilt at every start: " + file.error()};
    return index;
}

Result<AlbumIndex> AlbumIndex::in_memory() {
    if (!QSqlDatabase::isDriverAvailable(QStringLiteral("QSQLITE")))
        return Error{no_driver};
    static std::atomic<int> count = 0;
    const std::string name =
        "touchphoto-" + std::to_string(this_process()) + "-" + std::to_string(count.fetch_add(1));
    try {
        const MemoryTurn turn = std::make_shared<std::shared_mutex>();
        AlbumIndex index(SqlConnection::to_memory(name, turn), {}, name, turn);
        migrate(index.connection());
        return index;
    } catch (const SqlFault& fault) {
        return Error{"The album's index cannot be created: " + fault.text + "."};
    }
}

std::string AlbumIndex::discard(const fs::path& cache) { return IndexFile::remove(cache); }

Result<AlbumIndex> AlbumIndex::another() const {
    try {
        return AlbumIndex(is_in_memory() ? SqlConnection::to_memory(memory_name_, turn_)
                                         : SqlConnection::to_file(file_),
                          file_, memory_name_, turn_);
    } catch (const SqlFault& fault) {
        return Error{sentence_of(fault)};
    }
}

std::string AlbumIndex::sentence_of(const SqlFault& fault) const {
    if (fault.damaged()) {
        if (!is_in_memory())
            IndexFile::note_damage(file_.parent_path());
        return "The album's index is damaged; it is rebuilt when the album is next opened. The photographs "
               "are not affected.";
    }
    if (fault.full())
        return "The album's index cannot grow: the disk is full.";
    return "The album's index cannot be used: " + fault.text + ".";
}

Result<AlbumIndex::Totals> AlbumIndex::totals() {
    return guarded([&] {
        SqlRun run = connection().run("SELECT photos, missing FROM totals");
        run.next();
        return Totals{static_cast<std::size_t>(run.integer(0)), static_cast<std::size_t>(run.integer(1))};
    });
}

Result<std::vector<fs::path>> AlbumIndex::folders() {
    return guarded([&] {
        std::vector<fs::path> folders;
        SqlRun run = connection().run("SELECT path FROM folders WHERE present = 1 ORDER BY path");
        while (run.next())
            folders.emplace_back(run.bytes(0));
        SqlRun tagged =
            connection().run("SELECT f.path, p.name FROM photos p JOIN folders f ON f.id = p.folder "
                             "WHERE p.id IN (SELECT photo FROM tags) ORDER BY f.path, p.name");
        while (tagged.next())
            folders.push_back(recordings_folder(path_in(tagged)));
        return folders;
    });
}

Result<std::vector<Move>> AlbumIndex::moves() {
    return guarded([&] {
        // the best place of each comes last
        SqlRun run =
            connection().run("SELECT old_folder.path, old.name, new_folder.path, new.name "
                             "FROM photos old JOIN photos new ON new.hash = old.hash AND new.missing = 0 "
                             "JOIN folders old_folder ON old_folder.id = old.folder "
                             "JOIN folders new_folder ON new_folder.id = new.folder "
                             "WHERE old.missing = 1 ORDER BY new.name = old.name, new.id");
        std::map<fs::path, fs::path> places;
        while (run.next())
            places[path_in(run)] = fs::path(run.bytes(2)) / run.bytes(3);
        std::vector<Move> moves;
        for (const auto& [from, to] : places)
            if (is_gone(from))
                moves.push_back({from, to});
        return moves;
    });
}

Result<std::vector<fs::path>> AlbumIndex::missing() {
    return guarded([&] {
        return paths_in(connection().run("SELECT f.path, p.name FROM photos p JOIN folders f "
                                         "ON f.id = p.folder WHERE p.missing = 1 ORDER BY f.path, p.name"));
    });
}

std::string AlbumIndex::forget(const fs::path& missing) {
    return guarded([&] {
               SqlTransaction all(connection());
               std::vector<PhotoId> ids;
               {
                   SqlRun run = connection().run(
                       "SELECT p.id FROM photos p JOIN folders f ON f.id = p.folder "
                       "WHERE f.path = ? AND p.name = ? AND p.missing = 1",
                       SqlBytes{missing.parent_path().native()}, SqlBytes{missing.filename().native()});
                   while (run.next())
                       ids.push_back(run.integer(0));
               }
               for (const PhotoId id : ids)
                   forget_photo(connection(), id);
               all.commit();
               return true;
           })
        .error();
}

void AlbumIndex::erase_traces() {
    {
        SqlTransaction all(connection());
        connection().run_once("INSERT INTO words(words) VALUES('optimize')"); // deleted words stay until then
        all.commit();
    }
    if (is_in_memory())
        return;
    connection().run_once("VACUUM");
    connection().run_once("PRAGMA wal_checkpoint(TRUNCATE)");
    IndexFile::remove_set_aside(file_.parent_path());
}

Result<std::vector<std::vector<fs::path>>> AlbumIndex::duplicates() {
    return guarded([&] {
        std::vector<std::vector<fs::path>> groups;
        std::vector<fs::path> group;
        std::string group_hash;
        const auto close_group = [&] {
            if (std::vector<fs::path> files = different_files(group); files.size() > 1)
                groups.push_back(std::move(files));
            group.clear();
        };
        SqlRun run =
            connection().run("SELECT f.path, p.name, p.hash FROM photos p JOIN folders f ON f.id = p.folder "
                             "WHERE p.missing = 0 AND p.hash IN (SELECT hash FROM photos WHERE missing = 0 "
                             "GROUP BY hash HAVING count(*) > 1) ORDER BY p.hash, f.path, p.name");
        while (run.next()) {
            if (run.bytes(2) != std::exchange(group_hash, run.bytes(2)))
                close_group();
            group.push_back(path_in(run));
        }
        close_group();
        std::sort(groups.begin(), groups.end());
        return groups;
    });
}

Result<std::string> AlbumIndex::dump() {
    return guarded([&] { return dump_of(connection()); });
}

} // namespace tp
