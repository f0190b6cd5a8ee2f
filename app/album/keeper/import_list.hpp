// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// What an import was to bring, in .touchphoto/import of the album until it is finished.
struct ImportList {
    std::filesystem::path into;                 ///< relative to the album's folder; empty: the folder itself
    std::vector<std::filesystem::path> sources; ///< absolute

    /// Whether everything is where an import may read and write.
    bool makes_sense() const;
    /// On the disk when it returns; the import's id.
    Result<std::string> save(const std::filesystem::path& album) const;
    static Result<ImportList> read(const std::filesystem::path& album, const std::string& id);
    /// Oldest first.
    static std::vector<std::string> all(const std::filesystem::path& album);
    static std::string remove(const std::filesystem::path& album, const std::string& id);
};

} // namespace tp
