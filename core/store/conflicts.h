// Records that contradict each other, which only two copies of a study can bring about. Private to core/store.
#pragma once

#include <string>
#include <vector>

#include "core/store/connection.h"

namespace tactus::store {

/// One sentence each: numbers missing in the order of a session or given twice, codes of two persons, records with two
/// corrections, corrections in a circle. Throws as Query does.
std::vector<std::string> conflicts(Connection& connection);

/// Of these, records whose corrections go in a circle.
std::vector<std::string> circles(Connection& connection);

}  // namespace tactus::store
