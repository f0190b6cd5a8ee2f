// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold for these bytes as a report descriptor and, where they describe a stick, for its
/// reports; empty where all is well.
std::string complaint_about_descriptor(std::string_view bytes);

} // namespace tp::test
