// Checks whether the journal beside a study belongs to it and is complete. Private to core/store.
#pragma once

#include <optional>
#include <string>

#include "core/store/journal_file.h"
#include "core/store/opening_row.h"

namespace tactus::store {

/// An event that lost or may have lost records; a row of the table `incident`.
struct Incident {
  std::string kind;    ///< journal_missing, journal_cut, journal_damaged
  std::string detail;  ///< a sentence for the user
};

struct JournalFindings {
  /// The journal belongs to another file, or to another state of this one. None of it may be used.
  bool is_foreign = false;
  /// The study file is newer than the readable part of the journal, so the journal is ignored.
  bool is_behind = false;
  std::optional<Incident> incident;
};

/// Compares three sources: `file`, the row of `opening` read without the journal; `both`, the row read together with
/// the journal (empty if unreadable); and the journal itself.
/// Every commit counts in the row of `opening`. So a journal belongs to the file only if it continues the count under
/// the same token, or if it holds only the commit with the next token. The mark in the journal's last bytes gives the
/// number of acknowledged commits. A file of version 1 has no row, so nothing can be checked.
JournalFindings examineJournal(const std::optional<OpeningRow>& file, const std::optional<OpeningRow>& both,
                               const JournalFile& journal);

}  // namespace tactus::store
