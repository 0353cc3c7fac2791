// Persons that older versions imported from tables: their ids followed from the code alone. Private to core/store.
#pragma once

#include "core/store/connection.h"

namespace tactus::store {

/// Refuses a merge in which both files imported different tables for one such person: they may be two persons of one
/// code, whose data would be mixed. Where one file goes on from a copy of the other, or both imported the same rows,
/// they share a session, and nothing is refused. Throws as Query does.
void requireNoMixedImports(Connection& ours, Connection& theirs);

}  // namespace tactus::store
