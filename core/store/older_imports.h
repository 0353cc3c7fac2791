// Persons imported from tables by older versions, which derived the ids from the code alone. Private to core/store.
#pragma once

#include "core/store/connection.h"

namespace tactus::store {

/// Refuses a merge if both files imported different tables for one such person: they may be two persons with one code,
/// and their data would be mixed. If one file continues a copy of the other, or both imported the same rows, they share
/// a session, and the merge is allowed. Throws as Query does.
void requireNoMixedImports(Connection& ours, Connection& theirs);

}  // namespace tactus::store
