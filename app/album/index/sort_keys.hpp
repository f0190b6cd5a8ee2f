// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// In small letters without accents, as search compares: "Müller" → "muller". UTF-8 in and out.
std::string folded(std::string_view text);

/// Compared byte by byte it puts names in the order that a person expects: letter case and accents do not
/// count, IMG_2 comes before IMG_10.
std::string sort_key(std::string_view name);

/// Each start of a word in a folded text, to its end: "anna maria" → "anna maria", "maria". At most eight.
std::vector<std::string> word_starts(std::string_view folded_text);

/// A time of taking as far as it is known.
struct Moment {
    std::int64_t ms = 0; ///< since 1970; without an offset the local time counts as UTC
    int year = 0;        ///< as the camera's clock showed it
};

/// Of an ISO 8601 date, from "2026" to "2026-05-01T10:15:00.25+02:00"; none where it is none.
std::optional<Moment> moment_of(std::string_view iso);

} // namespace tp
