// Brings a study file from one version of its schema to the next.
#pragma once

#include <span>
#include <string>

#include "core/base/error.h"

namespace tactus::store {

class Connection;

/// One numbered step: SQL that makes version `version` of the schema out of the one before it.
struct Migration {
  int version = 0;
  std::string sql;
};

/// Runs the steps that the file still lacks, each in one transaction that also sets the version and that is committed
/// only after foreign keys and the integrity of the whole file were checked. Foreign keys are off while a step runs, so
/// it may rebuild tables. Before the first step of an existing study a copy `<path>.before-v<version>` is made beside
/// it, `-2`, `-3` … added where that is there already. After a failure the file is at the last version that succeeded.
/// `steps` are numbered 1, 2, 3, …
base::Result<void> migrate(Connection& connection, std::span<const Migration> steps);

/// The same for the study file at `path`, opened and closed by this function. StudyFile::open does it with the steps of
/// the program; others are for tests.
base::Result<void> migrateFile(const std::string& path, std::span<const Migration> steps);

}  // namespace tactus::store
