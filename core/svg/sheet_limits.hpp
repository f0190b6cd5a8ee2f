// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tp::svg {

/// What a sheet may hold, so that no file can take the machine's memory: a tactile map has 100 000 pieces.
constexpr std::size_t most_bytes = std::size_t{64} << 20;
constexpr std::size_t most_tags = 4'000'000;        ///< opening and closing ones
constexpr std::size_t most_attributes = 8'000'000;  ///< of all elements together
constexpr std::size_t most_pieces = 2'000'000;      ///< of all contours together
constexpr std::size_t most_contours = 200'000;      ///< each takes more than its piece; a face has some ten
constexpr std::size_t most_name_bytes = most_bytes; ///< of all contours together, before they are made unique

/// Ends of a closed contour that are this near are one point, in units of the sheet.
constexpr double joint_tolerance = 1e-9;

} // namespace tp::svg
