// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What is wrong with how `text` comes into the person's language; empty: nothing. English stays as it is; where each of our
/// sentences is put in brackets, the text without the brackets is the same.
std::string complaint_about_sentence(std::string_view text);

} // namespace tp::test
