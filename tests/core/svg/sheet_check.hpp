// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any text at all: it is read or refused in a sentence; what is read is finite, joined
/// and uniquely named, and comes back the same, bit for bit, when it is written and read again. Empty where
/// all of that holds, else what does not. Both units are tried. The fuzzer's and the hostile test's one
/// entry.
std::string complaint_about(std::string_view text);

} // namespace tp::test
