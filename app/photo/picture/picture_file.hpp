// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <QImage>

#include <filesystem>

namespace tp {

/// Writes a PNG or JPEG, by the file's ending, through a temporary file, so that a reader never sees half a
/// picture.
Result<std::filesystem::path> write_image(const std::filesystem::path& file, const QImage& image);

} // namespace tp
