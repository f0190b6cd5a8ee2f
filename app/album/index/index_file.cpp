// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/index_file.hpp"

#include "app/album/index/schema.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/open_file.hpp"

#include <cerrno>
#include <optional>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr const char* file_name = "album.sqlite";
constexpr const char* aside_name = "album.sqlite.aside";
constexpr const char* damage_name = "album.sqlite.damaged";
constexpr const char* lock_name = "album.lock";

/// Held by one process at a time; a killed one lets go of it. Not `ok`, and `errno`, where it cannot be made.
OpenFile index_lock(const fs::path& cache) {
    OpenFile file(cache / lock_name,
                  {.write = true, .make = true, .follow_link = false, .readers = Readers::owner_only});
    if (file.ok())
        file.wait_for_lock();
    return file;
}

/// SQLite's own files beside the database, first those without which it is whole.
constexpr const char* parts[] = {"-shm", "-wal", ""};

void set_aside(const fs::path& cache) {
    IndexFile::remove_set_aside(cache);
    for (const char* part : parts) {
        std::error_code none;
        fs::rename(cache / (std::string(file_name) + part), cache / (std::string(aside_name) + part), none);
    }
    std::error_code none;
    fs::remove(cache / damage_name, none);
}

std::string sql_reason(const SqlFault& fault) {
    constexpr int sqlite_read_only = 8, sqlite_cannot_open = 14;
    if (fault.full())
        return "the disk is full.";
    return fault.code == sqlite_read_only || fault.code == sqlite_cannot_open
               ? "you are not allowed to write there."
               : fault.text + ".";
}

/// None: it was written by a newer program.
std::optional<SqlConnection> opened(const fs::path& file) {
    SqlConnection connection = SqlConnection::to_file(file);
    std::error_code none; // where they cannot be taken away, the index is still worth having
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, none);
    if (version_of(connection) > schema_version())
        return std::nullopt;
    migrate(connection);
    touch_tables(connection);
    return connection;
}

} // namespace

Result<IndexFile> IndexFile::open(const fs::path& cache, std::vector<std::string>& notices) {
    if (std::string reason = make_folder(cache, Readers::owner_only); !reason.empty())
        return Error{reason};
    const OpenFile lock = index_lock(cache);
    if (!lock.ok())
        return Error{reason_of(errno)};
    const fs::path file = cache / file_name;
    const auto told = [&](const char* why) {
        set_aside(cache);
        notices.push_back("The album's index " + std::string(why) + "; it was set aside as " +
                          quoted(cache / aside_name) + " and is rebuilt. The photographs are not affected.");
    };
    std::error_code none;
    if (fs::exists(cache / damage_name, none))
        told("is damaged");
    for (int attempt = 0;; ++attempt) {
        try {
            if (std::optional<SqlConnection> connection = opened(file))
                return IndexFile{file, std::move(*connection)};
            if (attempt > 0)
                return Error{"it cannot be set aside."};
            told("was written by a newer version of this program");
        } catch (const SqlFault& fault) {
            constexpr int sqlite_error = 1; // a table is not there, or another one
            if (attempt > 0 || !(fault.damaged() || fault.code == sqlite_error))
                return Error{sql_reason(fault)};
            told("is damaged");
        }
    }
}

void IndexFile::remove_set_aside(const fs::path& cache) {
    std::error_code none;
    for (const char* part : parts)
        fs::remove(cache / (std::string(aside_name) + part), none);
}

std::string IndexFile::remove(const fs::path& cache) {
    std::error_code error;
    if (!fs::exists(cache, error))
        return {};
    const OpenFile lock = index_lock(cache);
    if (!lock.ok())
        return reason_of(errno);
    for (const char* part : parts)
        if (!fs::remove(cache / (std::string(file_name) + part), error) && error)
            return reason_of(error.value());
    fs::remove(cache / damage_name, error);
    remove_set_aside(cache);
    return {};
}

void IndexFile::note_damage(const fs::path& cache) {
    const OpenFile noted(
        cache / damage_name,
        {.read = false, .write = true, .make = true, .follow_link = false, .readers = Readers::owner_only});
}

} // namespace tp
