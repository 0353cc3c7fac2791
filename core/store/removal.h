// Deletes the rows of a person who withdrew. Private to core/store.
#pragma once

#include "core/store/connection.h"
#include "core/study/record_id.h"

namespace tactus::store {

/// Deletes everything of the person within the open transaction, in which their tombstone was set before; returns how
/// many records that were. Throws as Query does.
long long removePerson(Connection& connection, const study::RecordId& person);

}  // namespace tactus::store
