// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace tp {

/// A line of resources/places/towns.tsv.
struct Town {
    double latitude = 0.0, longitude = 0.0; ///< degrees, WGS 84, north and east positive
    int thousands = 0;                      ///< of people
    std::string_view name, german, korean;  ///< UTF-8; the last two may be empty
};

/// The towns in such a text, which must outlive them; lines that are none are left out.
std::vector<Town> towns_in(std::string_view text);

/// Those inside the program, by latitude; read at the first call, a few milliseconds.
const std::vector<Town>& all_towns();

} // namespace tp
