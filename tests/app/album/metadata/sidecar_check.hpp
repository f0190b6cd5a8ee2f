// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a sidecar: they are refused with words, or what is read of them makes
/// sense, is the same after every field was written and read again, and what nobody changed keeps its value.
/// Empty where all of that holds, else what does not. The fuzzer's and the hostile test's one entry.
std::string complaint_about_sidecar(std::string_view bytes);

/// The same for any text as the inside of a photograph's rdf:Description, whatever the photograph's shape:
/// every region lies within the picture.
std::string complaint_about_regions(std::string_view properties);

/// What must hold for all that is read of a photograph: places within it and on Earth, texts in UTF-8,
/// problems that are sentences. Empty where that holds, else what does not.
std::string complaint_about_record(const PhotoRecord& record);

} // namespace tp::test
