// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/recording_room.hpp"

#include "audio/sound/sound_format.hpp"

#include <system_error>

namespace tp {

namespace {
constexpr double bytes_a_frame = 2.0;
} // namespace

std::optional<std::uint64_t> free_bytes(const std::filesystem::path& folder) {
    std::filesystem::path existing = folder.empty() ? "." : folder;
    while (true) {
        std::error_code error;
        const std::filesystem::space_info disk = std::filesystem::space(existing, error);
        if (!error)
            return disk.available;
        if (error != std::errc::no_such_file_or_directory || existing == existing.parent_path())
            return std::nullopt;
        existing = existing.has_parent_path() ? existing.parent_path() : ".";
    }
}

double seconds_of_room(std::uint64_t free, std::uint64_t recorded_frames) {
    const double finished = static_cast<double>(recorded_frames) * bytes_a_frame;
    const double bytes = static_cast<double>(free) - static_cast<double>(kept_free_bytes) - finished;
    return bytes > 0.0 ? bytes / (2.0 * bytes_a_frame * sound_rate) : 0.0;
}

} // namespace tp
