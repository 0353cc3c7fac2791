// Rewrites a study file, so that no removed data remains in unused pages. Private to core/store.
#pragma once

#include "core/store/connection.h"

namespace tactus::store {

/// Puts the rows that are there into new pages, which take the place of the old ones in the same file, and empties the
/// journal. Needs room on the disk for two more copies of the study, one of them with a name beside it for a moment
/// (base/files/unfinished.h, readable by the owner alone), and a few megabytes of memory, however large the study is.
/// The new pages go through the journal in one transaction: after a crash the old or the new ones are there, and doing
/// it again is all that is needed. Only at rest, without a transaction. Throws as Query does.
void rewriteWithoutTraces(Connection& connection);

/// Moves the journal into the file and truncates it to zero. Throws as Query does.
void emptyJournal(Connection& connection);

}  // namespace tactus::store
