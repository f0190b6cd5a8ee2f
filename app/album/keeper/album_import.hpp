// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/importer.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

/// What an import is given.
struct ImportTools {
    Importer::Known known;
    Importer::Report progress;                      ///< before each photograph; may be empty
    std::function<void(const ImportedPhoto&)> done; ///< after each; may be empty
    std::stop_token stop;
};

/// Imports files, folders and bundles; a bundle is unpacked inside the album first. A sound of the same name as a
/// photograph (IMG_1.WAV) becomes its ambient recording. `into` is relative to the album's folder.
Result<ImportReport> import_into_album(const std::filesystem::path& album, const std::filesystem::path& into,
                                       const std::vector<std::filesystem::path>& sources, const ImportTools& tools);

/// Goes on with an import that was not finished.
Result<ImportReport> continue_import(const std::filesystem::path& album, const std::string& id,
                                     const ImportTools& tools);

/// Writes a bundle of photographs and of all photographs in folders.
std::string export_bundle(const std::filesystem::path& bundle, const std::filesystem::path& album,
                          const std::vector<std::filesystem::path>& photos_and_folders,
                          const BundleProgress& report = {}, std::stop_token stop = {});

} // namespace tp
