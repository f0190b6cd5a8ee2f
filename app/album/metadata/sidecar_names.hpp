// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace tp {

/// Where the sidecar of a photograph is written: `IMG_1.jpg.xmp`, or the file that already has that name with
/// `xmp` in other letter case.
std::filesystem::path sidecar_of(const std::filesystem::path& photo);

/// The sidecars that are there, most telling first: `IMG_1.jpg.xmp`, then `IMG_1.xmp`, which `IMG_1.nef` and
/// `IMG_1.jpg` share.
std::vector<std::filesystem::path> sidecars_of(const std::filesystem::path& photo);

} // namespace tp
