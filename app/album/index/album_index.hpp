// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/sql_connection.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tp {

using PhotoId = std::int64_t; ///< of a photograph in one index; another index numbers anew

/// A photograph that is gone from `from` and lies, byte for byte the same, at `to`.
struct Move {
    std::filesystem::path from, to;
    bool operator==(const Move&) const = default;
};

/// An index over albums, in SQLite. Photographs and what lies beside them are the truth; this only makes them
/// quick to find and can be thrown away at any time. It belongs to the thread that made it; another thread or
/// process opens it once more. Needs a QCoreApplication.
class AlbumIndex {
public:
    /// `cache`/album.sqlite, made where it is missing, for its owner only. One that is spoilt or that a newer
    /// program wrote is set aside as album.sqlite.aside; where nothing can be written the index is in memory.
    /// Either is told in `notices`.
    static Result<AlbumIndex> open(const std::filesystem::path& cache);
    static Result<AlbumIndex> in_memory();
    /// Deletes the index in `cache`; the reason why not, else empty. To be called while nobody has it open.
    static std::string discard(const std::filesystem::path& cache);

    /// The same index for another thread.
    Result<AlbumIndex> another() const;

    /// Sentences for the person who looks after the album.
    const std::vector<std::string>& notices() const { return notices_; }
    bool is_in_memory() const { return file_.empty(); }

    struct Totals {
        std::size_t photos = 0; ///< that are there
        std::size_t missing = 0;
    };
    Result<Totals> totals();

    /// The folders of the album, for watching: those that were there at the last scan, and the folders of
    /// recordings.
    Result<std::vector<std::filesystem::path>> folders();

    /// Missing photographs whose content lies elsewhere in the album, where it can be taken to have gone: of
    /// several places the one with the same name, else the one that came in last. Each is told until it is
    /// forgotten.
    Result<std::vector<Move>> moves();
    Result<std::vector<std::filesystem::path>> missing();
    /// Drops one missing photograph, such as one whose move has been dealt with.
    std::string forget(const std::filesystem::path& missing);

    /// What was deleted from the index leaves no trace in its files: neither in its log nor in one that was set aside. Takes as
    /// long as writing the index anew.
    void erase_traces();

    /// Groups of photographs with the same content, each by path. Links to one file are no duplicates.
    Result<std::vector<std::vector<std::filesystem::path>>> duplicates();

    /// All that the index says of what is there, as text; equal for equal albums, however they were scanned.
    Result<std::string> dump();

    /// For the queries and scans of this room.
    SqlConnection& connection() { return *connection_; }
    /// The sentence for a fault of the database. A spoilt one is noted and set aside when it is opened next.
    std::string sentence_of(const SqlFault& fault) const;
    /// Runs `work`; its result, or the sentence of the SqlFault that it threw.
    template <typename Work>
    auto guarded(Work work) -> Result<decltype(work())> {
        try {
            return work();
        } catch (const SqlFault& fault) {
            return Error{sentence_of(fault)};
        }
    }

private:
    AlbumIndex(SqlConnection connection, std::filesystem::path file, std::string memory_name = {},
               MemoryTurn turn = {})
        : connection_(std::make_unique<SqlConnection>(std::move(connection))), file_(std::move(file)),
          memory_name_(std::move(memory_name)), turn_(std::move(turn)) {}

    std::unique_ptr<SqlConnection> connection_;
    std::filesystem::path file_; ///< empty in memory
    std::string memory_name_;
    MemoryTurn turn_;
    std::vector<std::string> notices_;
};

} // namespace tp
