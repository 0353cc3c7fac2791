#include "core/store/merge.h"

#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sqlite3.h>

#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/store/connection.h"
#include "core/store/entries.h"
#include "core/store/felt_events.h"
#include "core/store/person_codes.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/withdrawal.h"

namespace tactus::store {
namespace {

using Findings = std::vector<std::string>;

void checkOrder(Connection& connection, Findings& findings) {
  Query query(connection,
              "SELECT session_id, count(*), count(DISTINCT sequence), max(sequence) FROM session_record"
              " GROUP BY session_id HAVING count(*) <> max(sequence) OR count(DISTINCT sequence) <> count(*)");
  while (query.next()) {
    const std::string session = "session " + study::toText(query.id());
    const auto records = query.integer();
    const auto numbers = query.integer();
    const auto highest = query.integer();
    if (numbers < highest) {
      findings.push_back(session + ": " + std::to_string(highest - numbers) + " records are missing");
    }
    if (records > numbers) {
      findings.push_back(session + ": " + std::to_string(records - numbers) +
                         " records have the number of another, so it went on in two copies of the study");
    }
  }
}

void checkPersons(Connection& connection, Findings& findings) {
  for (const DoubledCode& doubled : doubledCodes(connection)) {
    findings.push_back("person: " + describe(doubled, "have") +
                       "; give one of them another: " + recodeCommand(connection, doubled));
  }
}

void checkCorrections(Connection& connection, Findings& findings) {
  for (const std::string_view table : kEntryTables) {
    Query query(connection, "SELECT supersedes, count(*) FROM " + std::string(table) +
                                " WHERE supersedes IS NOT NULL GROUP BY supersedes HAVING count(*) > 1");
    while (query.next()) {
      const std::string id = study::toText(query.id());
      findings.push_back(std::string(table) + " " + id + ": has " + std::to_string(query.integer()) +
                         " corrections, the latest counts");
    }
  }
}

/// Within one file a version that participants follow is not changed, so this is the work of two stations.
void checkProtocols(Connection& connection, Findings& findings) {
  Query query(connection,
              "SELECT p.version, count(DISTINCT p.id) FROM protocol AS p JOIN session AS s ON s.protocol_id = p.id"
              " JOIN person ON person.id = s.person_id WHERE person.simulated = 0"
              " GROUP BY p.version HAVING count(DISTINCT p.id) > 1 ORDER BY p.version");
  while (query.next()) {
    const std::string version = std::to_string(query.integer());
    findings.push_back("protocol: participants followed " + std::to_string(query.integer()) +
                       " protocols that are all version " + version + "; the latest counts from now on");
  }
}

}  // namespace

std::vector<std::string> circles(Connection& connection) {
  Findings findings;
  for (const std::string_view table : kEntryTables) {
    const std::string name(table);
    Query query(connection, "WITH RECURSIVE d(id) AS (SELECT id FROM " + name +
                                " WHERE supersedes IS NULL UNION SELECT c.id FROM d JOIN " + name +
                                " AS c ON c.supersedes = d.id) SELECT id FROM " + name +
                                " WHERE supersedes IS NOT NULL AND id NOT IN (SELECT id FROM d) ORDER BY id");
    while (query.next()) {
      findings.push_back(name + " " + study::toText(query.id()) +
                         ": its corrections go in a circle, so none of them counts");
    }
  }
  return findings;
}

std::vector<std::string> conflicts(Connection& connection) {
  Findings findings;
  checkOrder(connection, findings);
  checkPersons(connection, findings);
  checkCorrections(connection, findings);
  checkProtocols(connection, findings);
  for (auto& circle : circles(connection)) findings.push_back(std::move(circle));
  return findings;
}

namespace {

// Persons imported from tables by older versions, which derived the ids from the code alone. Private to core/store.

using study::RecordId;

std::set<RecordId> importsOf(Connection& connection, const RecordId& person) {
  Query query(connection, "SELECT id FROM session WHERE person_id = ? AND kind = 'import'");
  query.put(person);
  std::set<RecordId> sessions;
  while (query.next()) sessions.insert(query.id());
  return sessions;
}

bool isOfCodeAlone(const RecordId& person, const std::string& code) {
  return study::toText(person) == base::sha256("person " + code).substr(0, 32);
}

/// Refuses a merge if both files imported different tables for one such person: they may be two persons with one code,
/// and their data would be mixed. If one file continues a copy of the other, or both imported the same rows, they share
/// a session, and the merge is allowed. Throws as Query does.
void requireNoMixedImports(Connection& ours, Connection& theirs) {
  Query query(theirs, "SELECT id, code FROM person ORDER BY id");
  while (query.next()) {
    const RecordId person = query.id();
    const std::string code = query.text();
    if (!isOfCodeAlone(person, code)) continue;
    const auto here = importsOf(ours, person);
    const auto there = importsOf(theirs, person);
    std::set<RecordId> shared;
    std::set_intersection(here.begin(), here.end(), there.begin(), there.end(), std::inserter(shared, shared.end()));
    if (here.empty() || there.empty() || !shared.empty()) continue;
    throw Refusal{{base::ErrorCode::kData,
                   theirs.path(),
                   {},
                   "other tables for " + base::quoted(code) +
                       " than this study has; an older version imported both and "
                       "cannot tell two persons of one code apart",
                   "a study made by importing the tables again, into a new file"}};
  }
}

using base::ErrorCode;
using base::Result;

/// A table to merge: which column tells rows apart, and the order in which rows may be added.
struct MergedTable {
  std::string name;
  std::string key;
  std::string order;
  bool has_place = false;  ///< the first column only counts the rows of its file
  std::string with = {};   ///< what `order` needs before and in the selection
  std::string join = {};
};

/// Rows that others refer to come first.
std::vector<MergedTable> mergedTables() {
  std::vector<MergedTable> tables = {{"person", "id", "id"},
                                     {"person_code", "id", "id"},
                                     {"protocol", "id", "version, utc_ms, id"},
                                     {"depth_measurement", "id", "image_id IS NOT NULL, utc_ms, id"},
                                     {"session", "id", "id"}};
  for (const std::string_view entry : kEntryTables) {
    const std::string name(entry);
    // A correction comes after what it corrects, however long the chain is; a ring of them is left out.
    tables.push_back({name, "id", "d.depth, session_id, sequence, t.id", false,
                      "WITH RECURSIVE d(id, depth) AS (SELECT id, 0 FROM " + name +
                          " WHERE supersedes IS NULL UNION ALL SELECT c.id, d.depth + 1 FROM d JOIN " + name +
                          " AS c ON c.supersedes = d.id) ",
                      " JOIN d ON d.id = t.id"});
  }
  tables.push_back({"recording", "stroke_id", "stroke_id", true});
  tables.push_back({"model_version", "id", "sequence, utc_ms, id", true});
  tables.push_back({"import_log", "id", "id"});
  tables.push_back({"incident", "id", "id"});
  return tables;
}

/// The columns that travel: a place belongs to its file, and the checksum covers the place.
std::vector<std::string> mergedColumns(Connection& connection, const MergedTable& table) {
  std::vector<std::string> columns = columnsOf(connection, table.name);
  if (table.has_place) columns.erase(columns.begin());
  // The key first, wherever it stands in the table.
  std::rotate(columns.begin(), std::find(columns.begin(), columns.end(), table.key),
              std::find(columns.begin(), columns.end(), table.key) + 1);
  return columns;
}

/// Copies the rows of one table that are new; the statements of both files work side by side.
class TableMerge {
 public:
  TableMerge(Connection& ours, Connection& theirs, const MergedTable& table,
             const std::vector<TimedCleaning>& cleanings)
      : table_(table),
        cleanings_(cleanings),
        columns_(mergedColumns(ours, table)),
        rows_(theirs.database(), table.with + "SELECT " + list() + ", " + fitsChecksum(theirs, table.name, "t") +
                                     " FROM " + table.name + " AS t" + table.join + " ORDER BY " + table.order),
        same_(ours.database(), "SELECT 1 FROM " + table.name + " WHERE " + equalities()),
        there_(ours.database(), "SELECT 1 FROM " + table.name + " WHERE " + table.key + " = ?1"),
        belongs_(ours.database(), owner()),
        insert_(ours.database(), addition(ours)) {}

  /// The number of rows that were new.
  long long run(std::vector<std::string>& differences) {
    long long added = 0;
    while (rows_.executeStep()) {
      clean();
      if (answers(same_) || !answers(belongs_)) continue;
      if (answers(there_)) {
        differences.push_back(table_.name + " " + keyText() + ": differs in the other file, this file's was kept");
        continue;
      }
      if (rows_.getColumn(static_cast<int>(columns_.size())).getInt() == 0) {
        refuse(ErrorCode::kMismatch, table_.name + " " + keyText() + " of the other file",
               "a record that does not fit its CRC-32", "the record as it was written; take it from a backup");
      }
      bindAll(insert_);
      insert_.exec();
      insert_.reset();
      ++added;
    }
    return added;
  }

 private:
  std::string list() const {
    std::string text;
    for (const auto& column : columns_) text.append(text.empty() ? "t." : ", t.").append(column);
    return text;
  }
  std::string equalities() const {
    std::string text;
    for (const auto& column : columns_) {
      if (column == kCleaned) continue;  // two stations may clean a version at different times
      text.append(text.empty() ? "" : " AND ").append(column).append(" IS ?");
      text.append(std::to_string(position(column)));
    }
    return text;
  }
  /// Takes who withdrew out of the texts of the row.
  void clean() {
    texts_.clear();
    cleaned_utc_ms_.reset();
    if (cleanings_.empty()) return;
    if (table_.name == "model_version") {
      cleanModel();
      return;
    }
    for (const FreeText& place : freeTexts()) {
      if (place.table != table_.name || isOfSeal()) continue;
      const int number = position(std::string(place.column));
      const std::string before = rows_.getColumn(number - 1).getString();
      std::string after = before;
      for (const auto& one : cleanings_) after = one.cleaning.cleaned(after);
      if (after != before) texts_[number] = std::move(after);
    }
  }
  /// A change would break the seal.
  bool isOfSeal() {
    if (table_.name != "event") return false;
    const std::string kind = rows_.getColumn(position("kind") - 1).getString();
    return kind == kSealedKind || kind == kOpenedKind;
  }
  void cleanModel() {
    const auto text = [this](const char* column) { return rows_.getColumn(position(column) - 1).getString(); };
    const auto cleaned = rows_.getColumn(position(kCleaned) - 1);
    if (!cleaned.isNull()) cleaned_utc_ms_ = cleaned.getInt64();
    ModelTexts version{text("author"), text("label"), text("text")};
    bool changed = false;
    for (const auto& one : cleanings_) {
      if (!one.cleaning.clean(version)) continue;
      changed = true;
      cleaned_utc_ms_ = std::min(one.utc_ms, cleaned_utc_ms_.value_or(one.utc_ms));
    }
    if (!changed) return;
    texts_[position("sha256")] = base::sha256(version.text);
    texts_[position("author")] = std::move(version.author);
    texts_[position("label")] = std::move(version.label);
    texts_[position("text")] = std::move(version.text);
  }
  /// A row without its owner is one of a person who withdrew.
  std::string owner() const {
    const std::string parameter = "?" + std::to_string(position("session_id"));
    if (table_.name == "person") return "SELECT 1 WHERE ?1 NOT IN (SELECT person_id FROM tombstone)";
    if (table_.key == "stroke_id") return "SELECT 1 FROM stroke WHERE id = ?1";
    if (position("person_id") > 0) {
      return "SELECT 1 FROM person WHERE id = ?" + std::to_string(position("person_id"));
    }
    if (position("session_id") > 0) return "SELECT 1 FROM session WHERE id = " + parameter;
    return "SELECT 1";
  }
  /// The number of the column among the parameters, from 1, or 0.
  int position(const std::string& wanted) const {
    const auto found = std::find(columns_.begin(), columns_.end(), wanted);
    return found == columns_.end() ? 0 : static_cast<int>(found - columns_.begin()) + 1;
  }
  std::string addition(Connection& ours) const {
    std::map<std::string, std::string> given;
    for (const auto& column : columns_) given[column] = '?' + std::to_string(position(column));
    if (table_.has_place) given["place"] = "(SELECT coalesce(max(place), 0) + 1 FROM " + table_.name + ")";
    return insertion(ours, table_.name, given);
  }
  std::string keyText() const { return study::toText(key()); }
  RecordId key() const {
    RecordId id;
    const auto column = rows_.getColumn(0);
    if (column.getBytes() == static_cast<int>(id.bytes.size())) {
      const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
      std::copy_n(bytes, id.bytes.size(), id.bytes.begin());
    }
    return id;
  }
  /// The values of the current row, as many as `statement` takes.
  void bindAll(SQLite::Statement& statement) const {
    for (int i = 0; i < statement.getBindParameterCount(); ++i) {
      if (const auto text = texts_.find(i + 1); text != texts_.end()) {
        statement.bind(i + 1, text->second);
        continue;
      }
      if (cleaned_utc_ms_ && i + 1 == position(kCleaned)) {
        statement.bind(i + 1, *cleaned_utc_ms_);
        continue;
      }
      const auto column = rows_.getColumn(i);
      switch (column.getType()) {
        case SQLITE_INTEGER: statement.bind(i + 1, static_cast<std::int64_t>(column.getInt64())); break;
        case SQLITE_FLOAT: statement.bind(i + 1, column.getDouble()); break;
        case SQLITE_TEXT: statement.bind(i + 1, column.getString()); break;
        case SQLITE_BLOB: statement.bind(i + 1, column.getBlob(), column.getBytes()); break;
        default: statement.bind(i + 1);
      }
    }
  }
  bool answers(SQLite::Statement& statement) const {
    bindAll(statement);
    const bool found = statement.executeStep();
    statement.reset();
    return found;
  }

  static constexpr const char* kCleaned = "cleaned_utc_ms";

  const MergedTable& table_;
  const std::vector<TimedCleaning>& cleanings_;
  std::map<int, std::string> texts_;  ///< of the current row, in place of those that name a person; by parameter
  std::optional<std::int64_t> cleaned_utc_ms_;
  std::vector<std::string> columns_;
  SQLite::Statement rows_;
  SQLite::Statement same_;
  SQLite::Statement there_;
  SQLite::Statement belongs_;
  SQLite::Statement insert_;
};

std::string logDetail(const Merge& merge) {
  base::JsonWriter json;
  json.beginObject(base::JsonWriter::Layout::kInline);
  for (const auto& count : merge.added) json.key(count.table).value(static_cast<long long>(count.rows));
  std::string text = json.key("conflicts").value(merge.conflicts.size()).endObject().text();
  text.pop_back();  // the newline of a whole file
  return text;
}

}  // namespace

Result<Merge> mergeStudy(StudyFile& file, const std::string& other, const RecordId& log_id, std::int64_t utc_ms,
                         const std::string& sha256) {
  if (file.connection().batch != Connection::BatchState::kNone) {
    return base::inFile({ErrorCode::kIo, {}, {}, "a batch that is not finished", "a study at rest"}, file.path());
  }
  // Before it is open: reading it later would take its locks away.
  const auto hash = sha256.empty() ? base::fileSha256(other) : Result<std::string>(sha256);
  TACTUS_TRY(auto opened, StudyFile::open(other, {Access::kReadOnly, file.connection().vfs()}));
  if (opened.version() != file.version()) {
    return tl::unexpected(base::Error{
        ErrorCode::kVersion,
        other,
        {},
        "a study of version " + std::to_string(opened.version()),
        "version " + std::to_string(file.version()) + " as the study it is merged into; open it once for writing"});
  }

  Connection& ours = file.connection();
  Merge merge;
  bool must_erase = false;
  auto merged = inTransaction(ours, [&] {
    requireNoMixedImports(ours, opened.connection());
    MergedWithdrawals withdrawals(ours, opened.connection());
    withdrawals.apply(merge);
    for (const MergedTable& table : mergedTables()) {
      const long long added =
          TableMerge(ours, opened.connection(), table, withdrawals.cleanings()).run(merge.conflicts);
      if (added > 0) merge.added.push_back({table.name, added});
    }
    for (const auto& circle : circles(opened.connection())) merge.conflicts.push_back(circle + "; left out");
    for (auto& conflict : conflicts(ours)) merge.conflicts.push_back(std::move(conflict));
    must_erase = withdrawals.finish();
    if (merge.added.empty()) return;
    Query log(ours, insertion(ours, "import_log", {{"kind", "'merge'"}}));
    log.put(log_id).put(utc_ms).put(std::filesystem::path(other).filename().string()).put(logDetail(merge));
    log.put(hash.value_or(std::string())).run();
  });
  if (!merged) return tl::unexpected(merged.error());
  if (must_erase) {
    if (auto erased = eraseTraces(file); !erased) return tl::unexpected(erased.error());
  }
  return merge;
}

}  // namespace tactus::store
