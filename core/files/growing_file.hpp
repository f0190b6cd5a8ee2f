// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

// For a file that grows at its end, such as a table to which a line is added at a time. One program changes it at a time
// (FolderLock). Each returns empty when done, and then a power cut does not undo it; else the reason why not, the end of a sentence.

inline constexpr const char* changed_meanwhile = "it was changed meanwhile.";

/// Puts these bytes behind the `size` bytes that the file has; changed_meanwhile where it has another size. Where that
/// fails the file is as it was, or, where the disk will not even have it so, a part of the bytes stands at its end: cut_file.
/// A process that is killed leaves such a part too.
std::string append_to_file(const std::filesystem::path& file, std::uintmax_t size, std::string_view bytes);

/// Leaves the first `size` bytes of the file; it has that many at least, or changed_meanwhile.
std::string cut_file(const std::filesystem::path& file, std::uintmax_t size);

} // namespace tp
