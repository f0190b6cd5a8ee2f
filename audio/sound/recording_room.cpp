// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/recording_room.hpp"

#include "audio/sound/sound_format.hpp"

#include <cerrno>
#include <sys/statvfs.h>

namespace tp {

namespace {
constexpr double bytes_a_frame = 2.0;
} // namespace

std::optional<std::uint64_t> free_bytes(const std::filesystem::path& folder) {
    struct statvfs disk {};
    std::filesystem::path existing = folder.empty() ? "." : folder;
    while (::statvfs(existing.c_str(), &disk) != 0) {
        if (errno != ENOENT || existing == existing.parent_path())
            return std::nullopt;
        existing = existing.has_parent_path() ? existing.parent_path() : ".";
    }
    return static_cast<std::uint64_t>(disk.f_bavail) * disk.f_frsize;
}

double seconds_of_room(std::uint64_t free, std::uint64_t recorded_frames) {
    const double finished = static_cast<double>(recorded_frames) * bytes_a_frame;
    const double bytes = static_cast<double>(free) - static_cast<double>(kept_free_bytes) - finished;
    return bytes > 0.0 ? bytes / (2.0 * bytes_a_frame * sound_rate) : 0.0;
}

} // namespace tp
