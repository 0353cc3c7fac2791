#include "core/store/journal_check.h"

#include <algorithm>

namespace tactus::store {
namespace {

std::string counted(long long count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// `3 saved records are gone`: what is committed at once, a record or a batch of them, counts as one.
std::string gone(long long count) { return counted(count, "saved record is gone", "saved records are gone"); }

bool belongs(const OpeningRow& file, const OpeningRow& both, const JournalFile& journal) {
  // Commits that are not counted, such as that of VACUUM, only loosen this.
  if (both.token == file.token) return both.commits - journal.commits <= file.commits;
  return both.previous == file.token && both.commits == file.commits + 1;
}

}  // namespace

JournalFindings examineJournal(const std::optional<OpeningRow>& file, const std::optional<OpeningRow>& both,
                               const JournalFile& journal) {
  JournalFindings findings;
  if (!file) return findings;
  const bool is_read = journal.commits > 0;
  if (is_read && (!both || !belongs(*file, *both, journal))) {
    findings.is_foreign = true;
    return findings;
  }
  const OpeningRow& last = is_read ? *both : *file;
  findings.is_behind = is_read && last.token == file->token && file->commits > last.commits;

  // What only the journal promises may have come to the disk before the journal's length did, while the token was
  // drawn.
  const bool is_promised = is_read && last.is_open && last.token == file->token;
  const long long promised = std::max(file->is_open ? file->journal_bytes : 0, is_promised ? last.journal_bytes : 0);
  if (promised == 0) return findings;
  if (journal.isEmpty()) {
    findings.incident = {
        "journal_missing",
        "the journal of a study that was not closed was missing when it was opened: what was saved last "
        "before may be gone, how many records cannot be told"};
    return findings;
  }
  const long long there = std::max(last.commits, file->commits);
  const bool is_marked = journal.mark && journal.mark->token == last.token;
  const long long acknowledged = is_marked ? journal.mark->commits : 0;
  // Of the transactions behind the last readable one the very last may have been on its way. Where none is readable,
  // their numbers are not known, and the file may hold all of them.
  const long long behind = is_read ? last.commits + journal.commits_behind - 1 - there : 0;
  const long long lost = std::max({0LL, acknowledged - there, behind});
  if (journal.bytes < promised) {
    std::string detail = "the journal was cut to " + std::to_string(journal.bytes) + " of " + std::to_string(promised) +
                         " bytes when the study was opened: ";
    if (lost > 0) {
      detail += "at least " + gone(lost);
    } else if (journal.ends_in_file) {
      detail += "no record was in the part that is missing";
    } else {
      detail += "what was saved last may be gone, how many records cannot be told";
    }
    findings.incident = {"journal_cut", std::move(detail)};
  } else if (lost > 0) {
    findings.incident = {"journal_damaged", "the journal was damaged when the study was opened: " +
                                                std::string(is_marked ? "" : "at least ") + gone(lost)};
  } else if (!is_marked && (!journal.has_header || (!is_read && journal.commits_behind > 1))) {
    findings.incident = {
        "journal_damaged",
        "the beginning of the journal was damaged when the study was opened: what was saved last may be "
        "gone, how many records cannot be told"};
  }
  return findings;
}

}  // namespace tactus::store
