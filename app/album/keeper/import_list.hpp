// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// What an import was to bring, in the person's own state folder until it is finished: what stands in an album may be a stranger's
/// wish, who would like to have this person's photographs on that stick.
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
    /// Forgets it, and what was unpacked for it in the album.
    static std::string remove(const std::filesystem::path& album, const std::string& id);
    /// Where it is kept, be it there or not.
    static std::filesystem::path place_of(const std::filesystem::path& album, const std::string& id);
    /// Where bundles are unpacked for it: in the album, because they are as large as what comes of them.
    static std::filesystem::path unpacked_in(const std::filesystem::path& album, const std::string& id);
    /// The lists that lie in the album itself, by whomever, or the link that stands for their folder; nothing follows them.
    static std::vector<std::filesystem::path> in_album(const std::filesystem::path& album);
};

} // namespace tp
