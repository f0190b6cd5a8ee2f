// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/sidecar_edit.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace tp {

/// Changes a sidecar's packet. Called again, on what somebody else wrote meanwhile, where that happens. A
/// sentence: it will not, and nothing is written.
using SidecarEditor = std::function<std::string(XmpPacket& sidecar, const Behind& behind)>;

/// Reads, changes and writes `IMG_1.jpg.xmp` so that neither a power cut nor a second program loses anything.
/// Empty when done, else a sentence.
std::string change_sidecar(const std::filesystem::path& photo, const SidecarEditor& change);

} // namespace tp
