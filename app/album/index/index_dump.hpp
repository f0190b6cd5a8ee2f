// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/sql_connection.hpp"

#include <string>

namespace tp {

/// All that the index says of what is there, in an order that depends on nothing but that: no row numbers, no
/// stamps of files, nothing missing. Throws SqlFault.
std::string dump_of(SqlConnection& connection);

} // namespace tp
