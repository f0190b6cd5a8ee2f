// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/photo_name.hpp"

#include "core/files/photo_endings.hpp"

#include <string>

namespace tp {

bool has_photo_name(const std::filesystem::path& file) {
    return !file.filename().string().starts_with('.') && has_photo_ending(file);
}

} // namespace tp
