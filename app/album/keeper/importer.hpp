// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

struct ImportProgress {
    std::size_t done = 0, total = 0; ///< photographs
    std::uintmax_t bytes_done = 0, bytes_total = 0;
    std::filesystem::path current;
    std::optional<double> seconds_left; ///< by the speed so far; none in the first second
};

/// What became of one photograph that was to be imported.
struct ImportedPhoto {
    enum class Fate {
        imported,
        duplicate, ///< the album holds these bytes already, in `place`; nothing was copied
        failed,    ///< `problem` says why; the rest was imported all the same
    };
    std::filesystem::path source;
    std::filesystem::path place;
    Fate fate = Fate::imported;
    std::string problem; ///< with `imported`: what came along only in part
};

struct ImportReport {
    std::string id; ///< under which an import that was stopped goes on
    std::vector<ImportedPhoto> photos;
    bool stopped = false;
    std::size_t count(ImportedPhoto::Fate fate) const;
};

/// Copies photographs with all that is theirs into a folder of an album: from folders, a camera's card or
/// single files.
///
/// What is to be imported is on the disk before the first byte is copied, so that an import that was stopped,
/// killed or cut off goes on where it was. A photograph is copied after its companions: where it is,
/// everything of it is. The sources are only read.
class Importer {
public:
    /// Where the album already has a photograph of this SHA-256, if it does.
    using Known = std::function<std::optional<std::filesystem::path>(const std::string& hash)>;
    using Report = std::function<void(const ImportProgress&)>;

    /// `into` is a folder relative to the album's; empty: the album's own.
    Importer(std::filesystem::path album, std::filesystem::path into, Known known);

    /// An error only where nothing could be begun.
    Result<ImportReport> import(const std::vector<std::filesystem::path>& sources, const Report& report = {},
                                std::stop_token stop = {});

    /// Imports into `album` that were not finished, oldest first.
    static std::vector<std::string> unfinished(const std::filesystem::path& album);
    /// Goes on with one of them.
    static Result<ImportReport> go_on(const std::filesystem::path& album, const std::string& id, Known known,
                                      const Report& report = {}, std::stop_token stop = {});
    /// Gives one up; what was imported stays.
    static std::string give_up(const std::filesystem::path& album, const std::string& id);

private:
    Result<ImportReport> run(const std::string& id, const std::vector<std::filesystem::path>& sources,
                             const Report& report, std::stop_token stop);
    ImportedPhoto import_one(const std::filesystem::path& source);

    std::filesystem::path album_;
    std::filesystem::path into_;
    Known known_;
    std::vector<std::pair<std::string, std::filesystem::path>> this_time_; ///< hash → place
};

} // namespace tp
