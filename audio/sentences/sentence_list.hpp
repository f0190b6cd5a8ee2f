// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace tp {

/// Every sentence that a room without languages makes, in English, with %1, %2… where something stands that is not always
/// the same; also the words and half sentences that are put into others.
std::span<const char* const> sentence_list();

} // namespace tp
