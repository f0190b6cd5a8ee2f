// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/sql_connection.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// The index's file in a cache folder. Several processes may come at once: a lock lets one at a time make,
/// migrate or set it aside.
struct IndexFile {
    std::filesystem::path path;
    SqlConnection connection;

    /// Opens it with the schema of this program. `notices` gets a sentence where it had to be set aside. An
    /// error is the end of a sentence: nothing can be kept there.
    static Result<IndexFile> open(const std::filesystem::path& cache, std::vector<std::string>& notices);
    /// The reason why not, else empty.
    static std::string remove(const std::filesystem::path& cache);
    /// One that was set aside goes too.
    static void remove_set_aside(const std::filesystem::path& cache);
    /// The next one to open it sets it aside.
    static void note_damage(const std::filesystem::path& cache);
};

} // namespace tp
