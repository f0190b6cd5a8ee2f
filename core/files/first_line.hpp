// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace tp {

inline constexpr std::size_t longest_first_line = 1024; ///< bytes

/// The first line of a file in which the kernel shows one thing of a device, without its end and cut at the longest. Empty where
/// there is none, or no file.
std::string first_line(const std::filesystem::path& file);

} // namespace tp
