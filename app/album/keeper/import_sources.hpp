// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/files/foreign_folder.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

/// One photograph to import, and the folder it goes to, relative to where the import goes.
struct PhotoToImport {
    std::filesystem::path file;
    std::filesystem::path folder;
    std::uintmax_t bytes = 0;
};

/// The photographs that files and folders hold, in their order and by name within a folder. Hidden folders
/// are passed over.
struct PhotographsIn {
    struct Unread {
        std::filesystem::path folder;
        std::string sentence; ///< why it could not be listed whole
    };
    std::vector<PhotoToImport> photos;
    std::vector<std::filesystem::path> links; ///< in a folder; they are left alone
    std::vector<Unread> unread;
};
PhotographsIn photographs_in(const std::vector<std::filesystem::path>& files_and_folders);

/// Told while a bundle is unpacked: how much of it is, 0 to 1.
using Unpacking = std::function<void(const std::filesystem::path& bundle, double share)>;

/// The photographs that files, folders and bundles hold; a bundle, or another program's ZIP file, is unpacked
/// into a folder that goes with this object. A file beside a photograph of its name (IMG_1.MOV,
/// IMG_1.jpg.xmp) goes where that photograph goes, and is passed over.
class ImportSources {
public:
    /// What cannot be imported, with why.
    struct Problem {
        std::filesystem::path source;
        std::string sentence;
        bool may_pass = false; ///< another try may succeed
    };

    /// `unpack_in` is a folder on the album's disk.
    ImportSources(const std::vector<std::filesystem::path>& sources, std::filesystem::path unpack_in,
                  std::stop_token stop, const Unpacking& unpacking = {});
    ~ImportSources();
    ImportSources(const ImportSources&) = delete;
    ImportSources& operator=(const ImportSources&) = delete;

    /// In the order of the sources, by name within a folder.
    const std::vector<PhotoToImport>& photos() const { return photos_; }
    /// Bundles that could not be unpacked and files that are no photographs; folders where there is no
    /// photograph at all.
    const std::vector<Problem>& problems() const { return problems_; }

private:
    void add(const std::filesystem::path& file_or_folder);
    void leave(const std::filesystem::path& link);
    void unpack(const std::filesystem::path& bundle, const std::filesystem::path& folder,
                const std::stop_token& stop, const Unpacking& unpacking);

    std::filesystem::path unpack_in_;
    std::vector<ForeignFolder> held_; ///< folders that photographs come from
    std::vector<PhotoToImport> photos_;
    std::vector<Problem> problems_;
};

} // namespace tp
