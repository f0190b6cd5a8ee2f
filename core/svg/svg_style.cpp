// SPDX-License-Identifier: Apache-2.0
#include "core/svg/svg_style.hpp"

#include "core/svg/svg_number.hpp"

#include <algorithm>

namespace tp::svg {

namespace {

std::string in_small_letters(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

} // namespace

std::string style_value(std::string_view style, std::string_view property) {
    std::string value;
    while (!style.empty()) {
        const std::size_t end = std::min(style.find(';'), style.size());
        const std::string_view declaration = style.substr(0, end);
        style.remove_prefix(std::min(end + 1, style.size()));
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos ||
            in_small_letters(trimmed(declaration.substr(0, colon))) != property)
            continue;
        const std::string_view set = declaration.substr(colon + 1);
        value = in_small_letters(trimmed(set.substr(0, std::min(set.find('!'), set.size()))));
    }
    return value;
}

} // namespace tp::svg
