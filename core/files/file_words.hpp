// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

/// The text as valid UTF-8 on one line: what is not UTF-8 becomes U+FFFD, control characters and the marks
/// that turn the direction of writing become blanks.
std::string readable(std::string_view text);

/// A path in quotation marks and readable, for naming it in a sentence.
std::string quoted(const std::filesystem::path& path);

/// Why the system would not, from its `errno`: the end of a sentence, such as "the disk is full."
std::string reason_of(int error);

} // namespace tp
