// Whether the schema of a file is that of its version, to the letter. Private to core/store.
#pragma once

#include "core/store/connection.h"

namespace tactus::store {

/// Looks before anything of the file's own SQL runs: a view without an end, a trigger that rewrites or a table of
/// somebody else would be believed otherwise. Refuses, naming what is missing, added or different. Of a version that
/// this program does not know, each table of the newest one that it knows must be an ordinary table.
void requireSchema(Connection& connection, int version);

}  // namespace tactus::store
