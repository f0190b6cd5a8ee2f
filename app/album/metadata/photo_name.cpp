// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/photo_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace tp {

bool has_photo_name(const std::filesystem::path& file) {
    constexpr std::array<std::string_view, 9> known{".jpg", ".jpeg", ".jpe",  ".png", ".webp",
                                                    ".tif", ".tiff", ".heic", ".heif"};
    if (file.filename().string().starts_with('.'))
        return false;
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(known.begin(), known.end(), extension) != known.end();
}

} // namespace tp
