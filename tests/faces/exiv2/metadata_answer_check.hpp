// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/exiv2/stated_metadata.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tp::test {

/// What is read of an answer with these bytes in it, or with these bytes in memory that comes with it.
std::optional<StatedMetadata> stated_in_message(std::string_view bytes);
std::optional<StatedMetadata> stated_in_memory(std::string_view bytes);

/// Empty where both read what can be, or nothing.
std::string complaint_about_metadata_answer(std::string_view bytes);

} // namespace tp::test
