// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/paper.hpp"

#include <algorithm>

namespace tp {

std::optional<Paper> paper_named(std::string_view name) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    for (const Paper& paper : papers)
        if (std::ranges::equal(name, std::string_view(paper.name), {}, lower))
            return paper;
    return std::nullopt;
}

} // namespace tp
