// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold of these bytes taken as a lab's setup: one that is accepted lies within all bounds, can be felt or
/// says why not, and is the same when it is written and read again. Empty: all holds.
std::string complaint_about_setup(std::string_view bytes);

} // namespace tp::test
