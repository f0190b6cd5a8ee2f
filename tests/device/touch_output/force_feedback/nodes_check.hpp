// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold where a kernel shows an input device by these bytes; empty where all is well. They are its files
/// capabilities/ff, capabilities/key, name, uniq and id/bustype, one behind the other with a zero between.
std::string complaint_about_input_device(std::string_view bytes);

} // namespace tp::test
