// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace tp {

/// Whether a file of this name may be a photograph: by its name (`has_photo_name`), or one without an
/// extension. Its first bytes decide.
bool may_be_photo(std::string_view name);

/// Whether a file that begins with these bytes (12 are enough) is a picture of one of these formats.
bool begins_like_photo(std::string_view bytes);

/// What a file that may be a photograph is.
struct PhotoContent {
    bool photo = false;
    std::string sha256; ///< 32 bytes; empty where it is no photograph
};

/// Reads the whole file where it is a photograph, block by block. None: stopped. An error is the system's
/// number.
std::optional<PhotoContent> read_photo_content(const std::filesystem::path& file, const std::stop_token& stop,
                                               int& error);

} // namespace tp
