#include "core/store/merged_withdrawals.h"

#include <algorithm>
#include <set>

#include "core/base/clock.h"
#include "core/store/query.h"
#include "core/store/recoding.h"
#include "core/store/removal.h"

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

}  // namespace tactus::store
