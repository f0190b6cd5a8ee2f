// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a list that an album keeps of a deletion or an import, or as the note of a
/// deleted recording: they are refused in a sentence, or name nothing outside of the album. Empty where that
/// holds, else what does not.
std::string complaint_about_album_lists(std::string_view bytes);

} // namespace tp::test
