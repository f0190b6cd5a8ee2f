// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a FLAC file: it is refused with words, or what it is written with other
/// notes says those notes, and its sound is the same. And as a block of comments: what was read is read again
/// after it was written, and so are the notes in it. Empty where all of that holds, else what does not.
std::string complaint_about_flac(std::string_view bytes);

} // namespace tp::test
