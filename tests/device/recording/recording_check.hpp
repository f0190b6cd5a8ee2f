// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold for any bytes read as a recording; empty where all is well: what is read can be written
/// and reads the same again.
std::string complaint_about_recording(std::string_view bytes);

} // namespace tp::test
