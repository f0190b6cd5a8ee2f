// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

inline constexpr int answered_side = 10; ///< px; of the picture for which there is memory

/// What does not hold where a decoder answers these bytes, with memory for `answered_side` squared pixels; empty where all is
/// well.
std::string complaint_about_picture_answer(std::string_view bytes);
/// Whether they are taken for a picture.
bool is_picture_answer(std::string_view bytes);

} // namespace tp::test
