// Copies of a study made while it is open.
#pragma once

#include <string>

#include "core/base/error.h"

namespace tactus::store {

class Connection;
class StudyFile;

/// Copies the committed records of the study to the new file `target`, through SQLite's backup interface. The copy is
/// checked and synced, and appears completely or not at all. Returns an error if `target` exists, and so for the study
/// itself.
/// Never copy an open study by other means: its journal would be missing.
base::Result<void> backUp(const StudyFile& file, const std::string& target);

/// The same for a connection. For core/store only.
base::Result<void> copyDatabase(Connection& connection, const std::string& target);

}  // namespace tactus::store
