// Deletes the rows of a person who withdrew. Private to core/store.
#pragma once

#include "core/store/connection.h"
#include "core/study/record_id.h"

namespace tactus::store {

/// Deletes all records of the person within the open transaction. The caller has set the tombstone before. Returns the
/// number of deleted records. Throws as Query does.
long long removePerson(Connection& connection, const study::RecordId& person);

}  // namespace tactus::store
