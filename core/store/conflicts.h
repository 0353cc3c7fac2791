// Records that contradict each other, which only two copies of a study can cause. Private to core/store.
#pragma once

#include <string>
#include <vector>

#include "core/store/connection.h"

namespace tactus::store {

/// One sentence per conflict: missing or duplicate numbers in the order of a session, codes of two persons, records
/// with two corrections, circular corrections. Throws as Query does.
std::vector<std::string> conflicts(Connection& connection);

/// The conflicts that are circular corrections.
std::vector<std::string> circles(Connection& connection);

}  // namespace tactus::store
