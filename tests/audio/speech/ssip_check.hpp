// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as what a speech-dispatcher sends: the same replies in whatever pieces they come, each with
/// a code of three digits and at least one line without its end, none larger than is allowed. Empty where all of that
/// holds, else what does not.
std::string complaint_about_ssip(std::string_view bytes);

} // namespace tp::test
