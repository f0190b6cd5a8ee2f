// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// What a person typed as terms for a full-text query: each word in quotation marks, so that none of FTS5's
/// syntax can be in it; the last one as the beginning of a word unless a blank follows it. At most twelve;
/// empty where there is no letter or digit.
std::vector<std::string> search_terms(std::string_view typed);

/// All of the terms.
std::string all_of(const std::vector<std::string>& terms);

} // namespace tp
