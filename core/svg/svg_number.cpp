// SPDX-License-Identifier: Apache-2.0
#include "core/svg/svg_number.hpp"

#include <2geom/coord.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

namespace tp::svg {

namespace {

constexpr std::string_view white_space = " \t\r\n\f";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_white(char c) { return white_space.find(c) != std::string_view::npos; }

void skip_white(std::string_view& text) {
    while (!text.empty() && is_white(text.front()))
        text.remove_prefix(1);
}

/// A digit, or a point and a digit: keeps the words "inf" and "nan" out.
bool starts_unsigned_number(std::string_view text) {
    if (text.empty())
        return false;
    if (text.front() == '.')
        return text.size() > 1 && is_digit(text[1]);
    return is_digit(text.front());
}

constexpr double mm_per_inch = 25.4;
constexpr std::array<std::pair<std::string_view, double>, 6> millimetres_of = {{
    {"mm", 1.0},
    {"cm", 10.0},
    {"q", 0.25},
    {"in", mm_per_inch},
    {"pt", mm_per_inch / 72.0},
    {"pc", mm_per_inch / 6.0},
}};

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return result;
}

} // namespace

std::string_view trimmed(std::string_view text) {
    skip_white(text);
    while (!text.empty() && is_white(text.back()))
        text.remove_suffix(1);
    return text;
}

std::optional<double> take_number(std::string_view& text) {
    std::string_view number = text;
    if (!number.empty() && number.front() == '+')
        number.remove_prefix(1); // std::from_chars knows no plus sign
    const std::string_view digits =
        !number.empty() && number.front() == '-' && number.data() == text.data() ? number.substr(1) : number;
    if (!starts_unsigned_number(digits))
        return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error == std::errc::result_out_of_range)
        value = Geom::parse_coord(std::string(number.data(), end));
    else if (error != std::errc{})
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<std::vector<double>> number_list(std::string_view text) {
    std::vector<double> numbers;
    skip_white(text);
    while (!text.empty()) {
        const std::optional<double> number = take_number(text);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        skip_white(text);
        if (text.empty() || text.front() != ',')
            continue;
        text.remove_prefix(1);
        skip_white(text);
        if (text.empty())
            return std::nullopt; // a comma promises another number
    }
    return numbers;
}

double LengthScale::diagonal() const { return std::hypot(width, height) / std::sqrt(2.0); }

std::optional<double> length_in_units(std::string_view text, double units_per_mm, double whole) {
    text = trimmed(text);
    const std::optional<double> number = take_number(text);
    if (!number)
        return std::nullopt;
    const std::string unit = lower(text);
    if (unit.empty() || unit == "px")
        return number;
    if (unit == "%")
        return *number / 100.0 * whole;
    for (const auto& [name, millimetres] : millimetres_of)
        if (unit == name)
            return *number * millimetres * units_per_mm;
    return std::nullopt;
}

} // namespace tp::svg
