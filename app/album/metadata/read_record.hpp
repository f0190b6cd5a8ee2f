// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "core/base/result.hpp"

#include <filesystem>

namespace tp {

/// What is known of a photograph. Field by field: what its own sidecar (`IMG_1.jpg.xmp`) says, else a
/// Lightroom sidecar (`IMG_1.xmp`), else the photograph itself; orientation and size are the photograph's own.
/// An error only where there is no such file; what cannot be read of it or makes no sense is left out, with a
/// sentence in `problems`. Nothing is written. Any thread.
Result<PhotoRecord> read_record(const std::filesystem::path& photo);

} // namespace tp
