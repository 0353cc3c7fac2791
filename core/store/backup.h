// Copies of a study while it is open.
#pragma once

#include <string>

#include "core/base/error.h"

namespace tactus::store {

class Connection;
class StudyFile;

/// Copies the study to the new file `target` through SQLite's backup interface: what was committed until now, checked,
/// synced, and there whole or not at all. Refused: a name that is taken, so the study itself too.
/// (An open study must never be copied with other means: its journal would be missing.)
base::Result<void> backUp(const StudyFile& file, const std::string& target);

/// The same for a connection. For core/store only.
base::Result<void> copyDatabase(Connection& connection, const std::string& target);

}  // namespace tactus::store
