// Checks that the schema of a file is exactly that of its version. Private to core/store.
#pragma once

#include "core/store/connection.h"

namespace tactus::store {

/// Call before any SQL of the file runs, because a foreign schema can contain an endless view, a trigger that changes
/// data, or a false table. Refuses, and names missing, added and different parts. If the program does not know the
/// version, each table of the newest known version must be an ordinary table.
void requireSchema(Connection& connection, int version);

}  // namespace tactus::store
