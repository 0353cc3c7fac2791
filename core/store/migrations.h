// Upgrades a study file from one version of its schema to the next.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::store {

class Connection;

/// One numbered step: SQL that upgrades the schema from the previous version to `version`.
struct Migration {
  int version = 0;
  std::string sql;
};

/// Runs the missing steps. Each runs in one transaction that also sets the version. It is committed only after a check
/// of the foreign keys and the integrity of the whole file. Foreign keys are off during a step, so that it may rebuild
/// tables.
/// Before the first step of an existing study, a copy `<path>.before-v<version>` is made beside it, with `-2`, `-3` …
/// added if that name exists. After a failure the file has the last version that succeeded.
/// `steps`: numbered 1, 2, 3, …
base::Result<void> migrate(Connection& connection, std::span<const Migration> steps);

/// The same for the study file at `path`, opened and closed by this function. StudyFile::open uses it with the
/// program's steps; other steps are for tests.
base::Result<void> migrateFile(const std::string& path, std::span<const Migration> steps);

// The schema of study files, version by version: core/store/schema.

/// The steps to the newest version known to this program.
std::span<const Migration> schemaSteps();

/// SQL that makes the views of the newest version for one connection only, so that it reads a file of a newer program.
/// It does not change the file.
std::string viewsForReading();

}  // namespace tactus::store
