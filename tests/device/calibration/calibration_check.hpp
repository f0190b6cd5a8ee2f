// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold of these bytes taken as a file of calibrations: each one that is accepted is plausible and fits, and
/// all are the same when they are written and read again. Empty: all holds.
std::string complaint_about_calibrations(std::string_view bytes);

} // namespace tp::test
