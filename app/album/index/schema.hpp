// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/sql_connection.hpp"

namespace tp {

/// The version of the schema that this program writes; kept in the database as `PRAGMA user_version`.
int schema_version();

/// The version of the schema that is there; 0: none yet.
int version_of(SqlConnection& connection);

/// Brings the database from whatever older version it has to `version`, with what it holds. Throws SqlFault,
/// and then it is as it was.
void migrate(SqlConnection& connection, int version = schema_version());

/// Reads a little of every table; throws SqlFault where the database is plainly spoilt.
void touch_tables(SqlConnection& connection);

} // namespace tp
