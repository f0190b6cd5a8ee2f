// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

/// Not to be shown: controls, line ends, and what turns the direction of the rest of a sentence (Unicode UAX 9).
bool is_unwelcome(char32_t code);

/// The text as valid UTF-8 on one line: what is not UTF-8 becomes U+FFFD, control characters and the marks
/// that turn the direction of writing become blanks.
std::string readable(std::string_view text);

/// Text of another's making in quotation marks and readable, for naming it in a sentence.
std::string quoted_readable(std::string_view text);

/// The same for a path. Nothing else turns into a path on its way here, so that text is quoted as text.
template <std::same_as<std::filesystem::path> Path>
std::string quoted(const Path& path) {
    return quoted_readable(path.string());
}

/// Whether the system's number is about the disk, or the way to it, and not about the file: a card that dies, a share that is
/// gone. Then nothing is known of what is there.
bool is_disks_fault(int error);

/// Why the system would not, from its `errno`: the end of a sentence, such as "the disk is full."
std::string reason_of(int error);

} // namespace tp
