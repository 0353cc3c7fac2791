#include "core/store/migrations.h"

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/check.h"
#include "core/store/connection.h"
#include "core/store/copies.h"

namespace tactus::store {

// Embedded from core/store/schema.
std::string_view studyTables();
std::string_view studyGuards();
std::string_view studyViews();

std::span<const Migration> schemaSteps() {
  static const std::vector<Migration> steps = {
      {1, std::string(studyTables()) + std::string(studyGuards()) + std::string(studyViews())},
  };
  return steps;
}

std::string viewsForReading() {
  std::string sql(studyViews());
  constexpr std::string_view kCreate = "CREATE VIEW ";
  for (std::size_t at = 0; (at = sql.find(kCreate, at)) != std::string::npos; at += kCreate.size()) {
    sql.insert(at + 7, "TEMP ");
  }
  return sql;
}

namespace {

using base::ErrorCode;
using base::Result;

std::string freeName(const std::string& wanted) {
  std::error_code ignored;
  std::string name = wanted;
  for (int number = 2; std::filesystem::exists(name, ignored); ++number) name = wanted + "-" + std::to_string(number);
  return name;
}

void requireIntact(Connection& connection, int version) {
  for (const char* check : {"foreign_key_check", "integrity_check"}) {
    const std::string finding = connection.firstFinding(check);
    if (finding.empty()) continue;
    refuse(ErrorCode::kMismatch, "step to version " + std::to_string(version), finding,
           "an intact study; the file was left as it was");
  }
}

/// One step. Nothing of it stays where it fails.
Result<void> run(Connection& connection, const Migration& step) {
  auto switched = guarded(connection, [&] { connection.database().exec("PRAGMA foreign_keys = OFF"); });
  if (!switched) return switched;
  auto done = inTransaction(connection, [&] {
    connection.database().exec(step.sql);
    connection.database().exec("PRAGMA user_version = " + std::to_string(step.version));
    requireIntact(connection, step.version);
  });
  switched = guarded(connection, [&] { connection.database().exec("PRAGMA foreign_keys = ON"); });
  return done ? switched : done;
}

}  // namespace

Result<void> migrate(Connection& connection, std::span<const Migration> steps) {
  auto version = guarded(connection, [&] { return connection.version(); });
  if (!version) return tl::unexpected(version.error());
  for (std::size_t i = 0; i < steps.size(); ++i) TACTUS_CHECK(steps[i].version == static_cast<int>(i) + 1);
  if (*version >= static_cast<int>(steps.size())) return {};

  if (*version > 0) {
    const std::string copy = freeName(connection.path() + ".before-v" + std::to_string(steps.size()));
    if (auto copied = copyDatabase(connection, copy); !copied) return copied;
  }
  for (const Migration& step : steps.subspan(static_cast<std::size_t>(*version))) {
    if (auto done = run(connection, step); !done) return done;
  }
  return {};
}

Result<void> migrateFile(const std::string& path, std::span<const Migration> steps) {
  try {
    Connection connection(path, Connection::Mode::kReadWrite, {});
    auto started = guarded(connection, [&] {
      connection.requireStudyFile();
      connection.startJournal();
    });
    return started ? migrate(connection, steps) : started;
  } catch (const Refusal& refusal) {
    return base::inFile(refusal.error, path);
  } catch (const SQLite::Exception& exception) {
    return tl::unexpected(describeFailure(path, failureOf(exception)));
  }
}

}  // namespace tactus::store
