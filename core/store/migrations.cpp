#include "core/store/migrations.h"

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/check.h"
#include "core/store/connection.h"
#include "core/store/copies.h"

namespace tactus::store {

// Embedded from core/store/schema.
std::string_view tablesOfVersion1();
std::string_view guardsOfVersion1();
std::string_view viewsOfVersion1();
std::string_view tablesOfVersion2();
std::string_view guardsOfVersion2();
std::string_view viewsOfVersion2();
std::string_view tablesOfVersion3();
std::string_view guardsOfVersion3();
std::string_view tablesOfVersion4();
std::string_view guardsOfVersion4();
std::string_view tablesOfVersion5();
std::string_view guardsOfVersion5();

std::span<const Migration> schemaSteps() {
  static const std::vector<Migration> steps = {
      {1, std::string(tablesOfVersion1()) + std::string(guardsOfVersion1()) + std::string(viewsOfVersion1())},
      {2, std::string(tablesOfVersion2()) + std::string(guardsOfVersion2()) + std::string(viewsOfVersion2())},
      {3, std::string(tablesOfVersion3()) + std::string(guardsOfVersion3())},
      {4, std::string(tablesOfVersion4()) + std::string(guardsOfVersion4())},
      {5, std::string(tablesOfVersion5()) + std::string(guardsOfVersion5())},
  };
  return steps;
}

std::string viewsForReading() {
  std::string sql;
  for (const std::string_view views : {viewsOfVersion1(), viewsOfVersion2()}) {
    std::string text(views);
    // Of version 1 only what version 2 did not replace.
    if (views == viewsOfVersion1()) text.erase(0, text.find("CREATE VIEW session_record"));
    sql += text;
  }
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
      if (connection.applicationId() != kApplicationId) {
        refuse(ErrorCode::kSyntax, {}, "a file of another kind", "a Tactus study file");
      }
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
