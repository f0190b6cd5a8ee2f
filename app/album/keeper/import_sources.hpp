// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

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
std::vector<PhotoToImport> photographs_in(const std::vector<std::filesystem::path>& files_and_folders);

/// Told while a bundle is unpacked: how much of it is, 0 to 1.
using Unpacking = std::function<void(const std::filesystem::path& bundle, double share)>;

/// The photographs that files, folders and bundles hold; a bundle is unpacked into a folder that goes with
/// this object.
class ImportSources {
public:
    /// `unpack_in` is a folder on the album's disk. A bundle that cannot be unpacked is a sentence in
    /// `problems`.
    ImportSources(const std::vector<std::filesystem::path>& sources, std::filesystem::path unpack_in,
                  std::stop_token stop, const Unpacking& unpacking = {});
    ~ImportSources();
    ImportSources(const ImportSources&) = delete;
    ImportSources& operator=(const ImportSources&) = delete;

    /// In the order of the sources, by name within a folder.
    const std::vector<PhotoToImport>& photos() const { return photos_; }
    /// Bundles that could not be unpacked, with why.
    const std::vector<std::pair<std::filesystem::path, std::string>>& problems() const { return problems_; }

private:
    void add(const std::vector<std::filesystem::path>& files_and_folders);

    std::filesystem::path unpack_in_;
    std::vector<PhotoToImport> photos_;
    std::vector<std::pair<std::filesystem::path, std::string>> problems_;
};

} // namespace tp
