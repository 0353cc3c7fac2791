#include "core/store/withdrawal.h"

#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <cerrno>
#include <iterator>
#include <set>
#include <sqlite3.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

#include "core/base/clock.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/store/connection.h"
#include "core/store/copies.h"
#include "core/store/entries.h"
#include "core/store/feel_records.h"
#include "core/store/felt_events.h"
#include "core/store/opening.h"
#include "core/store/person_codes.h"
#include "core/store/query.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using study::RecordId;

std::vector<std::pair<RecordId, std::string>> currentCodes(Connection& connection) {
  Query query(connection, "SELECT id, code FROM person_current ORDER BY id");
  std::vector<std::pair<RecordId, std::string>> codes;
  while (query.next()) {
    const RecordId id = query.id();
    codes.emplace_back(id, query.text());
  }
  return codes;
}

std::vector<RecordId> unfinished(Connection& connection) {
  Query query(connection, "SELECT person_id FROM erasure");
  std::vector<RecordId> persons;
  while (query.next()) persons.push_back(query.id());
  return persons;
}

std::string timeText(std::int64_t utc_ms) {
  return base::formatUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(utc_ms)));
}

}  // namespace

MergedWithdrawals::MergedWithdrawals(Connection& ours, Connection& theirs)
    : ours_(ours),
      theirs_(theirs),
      our_rows_(readTombstones(ours)),
      their_rows_(readTombstones(theirs)),
      all_(our_rows_),
      unfinished_before_(unfinished(ours)) {
  for (const TombstoneRow& row : their_rows_) {
    const auto there =
        std::find_if(all_.begin(), all_.end(), [&](const auto& one) { return one.person == row.person; });
    if (there == all_.end()) {
      all_.push_back(row);
    } else {
      *there = joined(*there, row);
    }
  }
  requireOtherCodes(theirs, ours, our_rows_);
  requireOtherCodes(ours, theirs, their_rows_);
  findNames();
}

bool MergedWithdrawals::hasWithdrawn(const RecordId& person) const {
  return std::any_of(all_.begin(), all_.end(), [&](const TombstoneRow& row) { return row.person == person; });
}

void MergedWithdrawals::requireOtherCodes(Connection& living, Connection& withdrawn,
                                          const std::vector<TombstoneRow>& rows) const {
  for (const auto& [person, code] : currentCodes(living)) {
    const TombstoneRow* const row = withdrawnWith(rows, code);
    if (row == nullptr || hasWithdrawn(person)) continue;
    const std::string file = shellWord(living.path()) + ' ';
    throw Refusal{{ErrorCode::kData,
                   living.path(),
                   {},
                   describeWithdrawn(code, *row) + " from " + withdrawn.path(),
                   "for another person another code (tactus study recode " + file + study::toText(person) +
                       " NEWCODE), for the same person the withdrawal here too (tactus study withdraw " + file +
                       study::toText(person) + " --yes)"}};
  }
}

void MergedWithdrawals::findNames() {
  if (all_.empty()) return;
  const auto our_experts = expertsOfModels(ours_);
  const auto their_experts = expertsOfModels(theirs_);
  for (const TombstoneRow& row : all_) {
    std::set<std::string> names;
    for (Connection* side : {&ours_, &theirs_}) {
      for (auto& code : codesOf(*side, row.person)) names.insert(std::move(code));
    }
    for (const auto* experts : {&our_experts, &their_experts}) {
      std::copy_if(experts->begin(), experts->end(), std::inserter(names, names.end()),
                   [&](const std::string& expert) { return withdrawnWith({row}, expert) != nullptr; });
    }
    std::vector<std::string> own(names.begin(), names.end());
    for (Connection* side : {&ours_, &theirs_}) own = codesOfNobodyElse(*side, row.person, own);
    if (!own.empty()) cleanings_.push_back({NameCleaning(std::move(own)), row.utc_ms});
  }
}

void MergedWithdrawals::tellWhoStaysOut(Merge& merge) const {
  for (const auto& [person, code] : currentCodes(theirs_)) {
    const auto row = std::find_if(our_rows_.begin(), our_rows_.end(),
                                  [id = person](const TombstoneRow& one) { return one.person == id; });
    if (row == our_rows_.end()) continue;
    merge.conflicts.push_back("person " + base::quoted(code) + ": withdrew on " + timeText(row->utc_ms) +
                              ", so nothing of theirs comes in; withdraw them there too: tactus study withdraw " +
                              shellWord(theirs_.path()) + ' ' + study::toText(person) + " --yes");
  }
}

void MergedWithdrawals::apply(Merge& merge) {
  if (all_.empty()) return;
  tellWhoStaysOut(merge);
  long long added = 0;
  for (const TombstoneRow& row : their_rows_) {
    const bool is_new =
        std::none_of(our_rows_.begin(), our_rows_.end(), [&](const auto& one) { return one.person == row.person; });
    const auto codes = codesOf(ours_, row.person);
    leaveTombstone(ours_, row);
    if (!is_new) continue;
    ++added;
    if (removePerson(ours_, row.person) == 0) continue;
    ++merge.withdrawn;
    must_erase_ = true;
    merge.conflicts.push_back("person " + base::quoted(codes.back()) + ": withdrew on " + timeText(row.utc_ms) +
                              ", as the other file says, and was removed here too");
  }
  if (added > 0) merge.added.push_back({"tombstone", added});
  // The guards let texts be changed only while an erasure is noted.
  noteErasure(ours_, all_.front().person, all_.front().utc_ms);
  const long long before = ours_.database().getTotalChanges();
  for (const TimedCleaning& one : cleanings_) cleanRecords(ours_, one.cleaning, one.utc_ms);
  if (ours_.database().getTotalChanges() != before) must_erase_ = true;
}

bool MergedWithdrawals::finish() {
  if (must_erase_ || all_.empty()) return must_erase_;
  for (const RecordId& person : unfinished(ours_)) {
    if (std::find(unfinished_before_.begin(), unfinished_before_.end(), person) != unfinished_before_.end()) continue;
    Query done(ours_, "DELETE FROM erasure WHERE person_id = ?");
    done.put(person).run();
  }
  return false;
}

using study::RecordId;

namespace {

/// Deletes and counts. The triggers allow it because the tombstone stands.
long long removeRows(Connection& connection, const std::string& table, const std::string& condition,
                     const RecordId& person) {
  Query remove(connection, "DELETE FROM " + table + " WHERE " + condition);
  remove.put(person).run();
  return connection.database().getChanges();
}

}  // namespace

long long removePerson(Connection& connection, const RecordId& person) {
  const std::string in_sessions = "session_id IN (SELECT id FROM session WHERE person_id = ?1)";
  long long records = 0;
  removeRows(connection, "recording", in_sessions, person);  // part of a stroke, not counted
  for (const std::string_view table : kEntryTables) {
    records += removeRows(connection, std::string(table), in_sessions, person);
  }
  removeRows(connection, "person_code", "person_id = ?1", person);  // part of the person, not counted
  records += removeRows(connection, "session", "person_id = ?1", person);
  return records + removeRows(connection, "person", "id = ?1", person);
}

namespace {

using study::RecordId;

long long count(Connection& connection, const std::string& table, const RecordId& person,
                const std::string& condition = "1") {
  Query query(connection, "SELECT count(*) FROM " + table +
                              " AS r JOIN session AS s ON s.id = r.session_id WHERE s.person_id = ? AND " + condition);
  query.put(person).next();
  return query.integer();
}

std::string is(std::string_view column, std::string_view word) {
  return "r." + std::string(column) + " = '" + std::string(word) + "'";
}

/// No participant is behind the code of a seal (sealed_references.h), and all that happened to it stays.
void requireNoSeal(Connection& connection, const RecordId& person) {
  Query query(connection, std::string("SELECT 1 FROM event JOIN session ON session.id = session_id WHERE person_id = ? "
                                      "AND event.") +
                              kIsOfSeal + " LIMIT 1");
  if (!query.put(person).next()) return;
  refuse(base::ErrorCode::kValue, {}, "the code that keeps the sealed reference of the study",
         "a participant; a seal and its openings stay in the study");
}

/// Reads each model once, as the withdrawal does.
void countModels(Connection& connection, const NameCleaning& cleaning, WithdrawalPreview& preview) {
  Query query(connection, "SELECT author, label, text FROM model_version ORDER BY place");
  while (query.next()) {
    ModelTexts version;
    version.author = query.text();
    version.label = query.text();
    version.text = query.text();
    ++(cleaning.clean(version) ? preview.models_cleaned : preview.models_kept);
  }
}

}  // namespace

base::Result<WithdrawalPreview> previewWithdrawal(const StudyFile& file, const RecordId& person) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    const auto codes = codesOf(connection, person);
    if (codes.empty()) {
      refuse(base::ErrorCode::kReference, {}, "no person " + study::toText(person), "a person of the study");
    }
    requireNoSeal(connection, person);
    WithdrawalPreview preview;
    Query sessions(connection, "SELECT count(*) FROM session WHERE person_id = ?");
    sessions.put(person).next();
    preview.sessions = sessions.integer();
    preview.profiles = count(connection, "profile", person);
    preview.strokes = count(connection, "stroke", person, "NOT " + is("level", kFeelLevel));
    preview.judgements = count(connection, "judgement", person);
    preview.answers = count(connection, "answer", person);
    preview.ratings = count(connection, "rating", person);
    preview.rules = count(connection, "rule", person);
    preview.events = count(connection, "event", person);
    preview.placements = count(connection, "event", person, is("kind", kPlacementKind));
    preview.feel_recordings = count(connection, "event", person, is("kind", kFeelStartKind));
    preview.records = 1 + preview.sessions;  // the person
    for (const std::string_view table : kEntryTables) preview.records += count(connection, std::string(table), person);
    countModels(connection, NameCleaning(codesOfNobodyElse(connection, person, codes)), preview);
    return preview;
  });
}

namespace {

// Rewrites a study file, so that no removed data remains in unused pages. Private to core/store.

/// Moves the journal into the file and truncates it to zero. Throws as Query does.
void emptyJournal(Connection& connection);

using base::ErrorCode;

/// An empty file beside the study that only its owner may read; its name goes on every way out.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& study) : file_(base::makeUnfinishedFile(study, 0600)) {
    if (file_.descriptor.isOpen()) return;
    throw Refusal{
        {ErrorCode::kIo, study, {}, base::systemReason(errno), "a folder in which the study can be written anew"}};
  }
  ~ScratchFile() { removeName(); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return file_.path; }
  void removeName() {
    for (const char* tail : {"", "-journal", "-wal"}) ::unlink((path() + tail).c_str());
  }

 private:
  base::Unfinished file_;
};

/// Writes all pages of `from` over those of the study, in one transaction.
void putInPlace(SQLite::Database& from, Connection& study) {
  sqlite3* target = study.database().getHandle();
  sqlite3_backup* backup = sqlite3_backup_init(target, "main", from.getHandle(), "main");
  if (backup == nullptr) throw SQLite::Exception(target);
  const int stepped = sqlite3_backup_step(backup, -1);
  const int finished = sqlite3_backup_finish(backup);
  if (stepped != SQLITE_DONE) throw SQLite::Exception(sqlite3_errstr(stepped), stepped);
  if (finished != SQLITE_OK) throw SQLite::Exception(sqlite3_errstr(finished), finished);
}

/// Puts the rows that are there into new pages, which take the place of the old ones in the same file, and empties the
/// journal. Needs room on the disk for two more copies of the study, one of them with a name beside it for a moment
/// (base/files/unfinished.h, readable by the owner alone), and a few megabytes of memory, however large the study is.
/// The new pages go through the journal in one transaction: after a crash the old or the new ones are there, and doing
/// it again is all that is needed. Only at rest, without a transaction. Throws as Query does.
void rewriteWithoutTraces(Connection& connection) {
  {
    ScratchFile beside(connection.path());
    // VACUUM INTO holds a few pages in memory; VACUUM alone would put the whole study into a temporary file that may
    // lie on another disk.
    Query copy(connection, "VACUUM INTO ?");
    copy.put(beside.path()).run();
    SQLite::Database anew(beside.path().c_str(), SQLite::OPEN_READONLY, 0,
                          connection.vfs().empty() ? nullptr : connection.vfs().c_str());
    anew.exec("PRAGMA locking_mode = EXCLUSIVE");
    anew.exec("PRAGMA mmap_size = 0");
    anew.execAndGet("SELECT count(*) FROM sqlite_schema");  // opens it
    // From here on a crash leaves no copy behind.
    beside.removeName();
    putInPlace(anew, connection);
  }
  emptyJournal(connection);
}

void emptyJournal(Connection& connection) {
  if (connection.opening) return connection.opening->emptyJournal();
  Query truncate(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
  if (!truncate.next() || truncate.integer() != 0) {
    refuse(ErrorCode::kIo, {}, "a journal that could not be emptied", "a study that no other program uses");
  }
}

using base::ErrorCode;
using base::Result;
using study::RecordId;

Result<void> requireRest(const StudyFile& file) {
  if (file.connection().batch == Connection::BatchState::kNone) return {};
  return base::inFile({ErrorCode::kIo, {}, {}, "a batch that is not finished", "a study at rest"}, file.path());
}

std::vector<RecordId> readErasures(Connection& connection) {
  Query query(connection, "SELECT person_id FROM erasure ORDER BY utc_ms, person_id");
  std::vector<RecordId> persons;
  while (query.next()) persons.push_back(query.id());
  return persons;
}

}  // namespace

Result<Withdrawal> withdraw(StudyFile& file, const RecordId& person, std::int64_t utc_ms) {
  if (auto rest = requireRest(file); !rest) return tl::unexpected(rest.error());
  Connection& connection = file.connection();
  Withdrawal withdrawal;
  auto removed = inTransaction(connection, [&] {
    const auto codes = codesOf(connection, person);
    if (codes.empty()) {
      refuse(ErrorCode::kReference, {}, "no person " + study::toText(person), "a person of the study");
    }
    requireNoSeal(connection, person);
    const auto own = codesOfNobodyElse(connection, person, codes);
    std::copy_if(codes.begin(), codes.end(), std::back_inserter(withdrawal.shared_codes),
                 [&](const std::string& code) { return std::find(own.begin(), own.end(), code) == own.end(); });
    leaveTombstone(connection, tombstoneFor(person, utc_ms, own));
    withdrawal.records = removePerson(connection, person);
    withdrawal.models = cleanRecords(connection, NameCleaning(own), utc_ms);
  });
  if (!removed) return tl::unexpected(removed.error());
  if (auto erased = eraseTraces(file); !erased) {
    base::Error error = erased.error();
    error.place = "the records are removed, but not yet their traces in unused pages of the file (study erase does it)";
    return tl::unexpected(error);
  }
  return withdrawal;
}

Result<void> eraseTraces(StudyFile& file) {
  if (auto rest = requireRest(file); !rest) return rest;
  Connection& connection = file.connection();
  auto rewritten = guarded(connection, [&] {
    if (!connection.isWritable()) {
      refuse(ErrorCode::kIo, {}, "a study that is open for reading only", "one that is open for writing");
    }
    rewriteWithoutTraces(connection);
  });
  if (!rewritten) return rewritten;
  // Only now, so that an erasure that was interrupted is known as such.
  auto noted = inTransaction(connection, [&] { connection.database().exec("DELETE FROM erasure"); });
  if (!noted) return noted;
  if (auto emptied = guarded(connection, [&] { emptyJournal(connection); }); !emptied) return emptied;
  return removeCopies(file.path());
}

Result<Erasure> erase(StudyFile& file) {
  if (auto rest = requireRest(file); !rest) return tl::unexpected(rest.error());
  Connection& connection = file.connection();
  Erasure erasure;
  auto cleaned = inTransaction(connection, [&] {
    erasure.unfinished = readErasures(connection);
    const auto tombstones = readTombstones(connection);
    const bool has_hashes = std::any_of(tombstones.begin(), tombstones.end(),
                                        [](const TombstoneRow& row) { return !row.code_hashes.empty(); });
    if (!has_hashes) return;
    for (const auto& expert : expertsOfModels(connection)) {
      const TombstoneRow* const row = withdrawnWith(tombstones, expert);
      if (row == nullptr || codesOfNobodyElse(connection, row->person, {expert}).empty()) continue;
      noteErasure(connection, row->person, row->utc_ms);
      erasure.models += cleanRecords(connection, NameCleaning({expert}), row->utc_ms);
    }
  });
  if (!cleaned) return tl::unexpected(cleaned.error());
  if (auto erased = eraseTraces(file); !erased) return tl::unexpected(erased.error());
  return erasure;
}

Result<std::vector<RecordId>> unfinishedErasures(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] { return readErasures(connection); });
}

Result<std::vector<Tombstone>> tombstones(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    std::vector<Tombstone> found;
    for (const auto& row : readTombstones(connection)) found.push_back({row.person, row.utc_ms});
    return found;
  });
}

Result<std::optional<Tombstone>> withdrawnWithCode(const StudyFile& file, const std::string& code) {
  Connection& connection = file.connection();
  return guarded(connection, [&]() -> std::optional<Tombstone> {
    const auto rows = readTombstones(connection);
    const TombstoneRow* const row = withdrawnWith(rows, code);
    if (row == nullptr) return std::nullopt;
    return Tombstone{row->person, row->utc_ms};
  });
}

}  // namespace tactus::store
