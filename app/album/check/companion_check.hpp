// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/findings.hpp"
#include "app/album/check/inventory.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace tp {

using PhotosByContent = std::map<std::string, std::filesystem::path>; ///< by their SHA-256

/// Finds sidecars, contours and recordings whose photograph is not beside them. Where `known` does not hold
/// the photograph that they speak of, every photograph of the album is read once for it.
void check_companions(const Inventory& there, PhotosByContent known, Findings& findings);

} // namespace tp
