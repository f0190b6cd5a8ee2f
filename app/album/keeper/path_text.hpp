// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <QString>

#include <filesystem>
#include <string_view>

namespace tp {

/// A path as text in a JSON file and back to the same bytes, whatever they are: as it is where it is UTF-8
/// without
/// "%", else percent-encoded (RFC 3986, 2.1) behind "%:".
QString path_text(const std::filesystem::path& path);
/// An error where the text is not one that `path_text` makes.
Result<std::filesystem::path> path_of(const QString& text);

// "%:" and the percent-encoded path, whatever the path is.
QString percent_encoded(const std::filesystem::path& path);
bool is_percent_encoded(const QString& text);
/// Of text that is.
std::filesystem::path percent_decoded(const QString& text);

/// Whether `path` leads to a place below the folder that it is relative to: not empty, not absolute, without
/// "..", ".", NUL or anything that is no name.
bool stays_below(const std::filesystem::path& path);

} // namespace tp
