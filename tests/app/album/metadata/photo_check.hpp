// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a photograph: what is read of it makes sense, and what cannot be is a
/// sentence. Empty where that holds, else what does not.
std::string complaint_about_photo(std::string_view bytes);

} // namespace tp::test
