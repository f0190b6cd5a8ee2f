// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/firmware_image.hpp"

#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"

#include <cstddef>
#include <cstdlib>
#include <string>
#include <system_error>

namespace tp::falcon {

namespace {
constexpr std::size_t smallest_image = 4096;
constexpr std::size_t largest_image = 16384;
} // namespace

std::filesystem::path firmware_file() {
    const std::filesystem::path file = "touchphoto/falcon/firmware.bin";
    if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0')
        return data / file;
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home != nullptr ? home : "") / ".local/share" / file;
}

Result<std::vector<std::uint8_t>> firmware_in(const std::filesystem::path& file) {
    std::error_code none;
    if (!std::filesystem::exists(file, none))
        return std::vector<std::uint8_t>{};
    const Result<std::string> bytes = read_whole(file, largest_image);
    if (!bytes.ok())
        return Error{bytes.error()};
    if (bytes->size() < smallest_image)
        return Error{quoted(file) +
                     " is not the firmware of a Falcon: it is too small. Copy the right file there."};
    return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

} // namespace tp::falcon
