// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace tp {

std::string number_text(double number) {
    std::array<char, 400> text{}; // the longest without an exponent, which some readers do not know
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    return {text.data(), end};
}

std::optional<double> number_from(std::string_view text) {
    while (text.starts_with(' '))
        text.remove_prefix(1);
    while (text.ends_with(' '))
        text.remove_suffix(1);
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

} // namespace tp
