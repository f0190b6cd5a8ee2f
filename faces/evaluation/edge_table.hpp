// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/edges/edge_look.hpp"

#include <string>

namespace tp {

/// `look` as a row of faces/edges/edge_look_weights.inc, to two decimals, with a comment of one line.
std::string edge_table_row(const EdgeLook& look, const std::string& comment);

} // namespace tp
