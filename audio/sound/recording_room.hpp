// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace tp {

/// What a recording leaves free on the disk, so that the rest of the system and the album's own files do not
/// fail.
inline constexpr std::uint64_t kept_free_bytes = 100'000'000;

/// Bytes that this user may still write to the disk of the folder, which may be missing yet; nothing where
/// that cannot be known.
using FreeBytes = std::function<std::optional<std::uint64_t>(const std::filesystem::path& folder)>;
std::optional<std::uint64_t> free_bytes(const std::filesystem::path& folder);

/// Seconds that can still be recorded with so much free, after `recorded_frames`. Counted twice, because the
/// finished file lies beside the unfinished one for a moment, and may be as large. Never negative.
double seconds_of_room(std::uint64_t free, std::uint64_t recorded_frames);

} // namespace tp
