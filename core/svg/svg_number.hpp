// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tp::svg {

/// The text without the white space of XML around it.
std::string_view trimmed(std::string_view text);

/// Takes the number at the front of `text` away from it; nothing where there is none. A number too large for
/// a double is infinite, one too small is zero: the caller says what it makes of that. Never depends on the
/// locale.
std::optional<double> take_number(std::string_view& text);

/// Numbers separated by white space, a comma, or only by their signs, as `points` and `viewBox` hold them;
/// nothing where the text is anything else. An empty text is an empty list.
std::optional<std::vector<double>> number_list(std::string_view text);

/// What a length with a unit is worth where it stands.
struct LengthScale {
    double units_per_mm = 1.0; ///< user units a millimetre
    double width = 0.0;        ///< of the viewport, user units: what percentages are taken of
    double height = 0.0;       ///< of the viewport, user units

    double diagonal() const; ///< what percentages of a length along neither axis are taken of
};

/// A length in user units: a bare number or px as it is; mm, cm, Q, in, pt and pc by `units_per_mm`; % of
/// `whole`. Nothing where the text is no length or has another unit (em, rem, vw …). May be infinite.
std::optional<double> length_in_units(std::string_view text, double units_per_mm, double whole);

} // namespace tp::svg
