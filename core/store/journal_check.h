// Whether the journal beside a study belongs to it, and whether it lost anything. Private to core/store.
#pragma once

#include <optional>
#include <string>

#include "core/store/journal_file.h"
#include "core/store/opening_row.h"

namespace tactus::store {

/// Something that lost records or may have; a row of the table `incident`.
struct Incident {
  std::string kind;    ///< journal_missing, journal_cut, journal_damaged
  std::string detail;  ///< a sentence for people
};

struct JournalFindings {
  /// The journal is of another file, or of another state of this one: nothing of it may be taken.
  bool is_foreign = false;
  /// The study file holds more than what can be read of the journal, so the journal is left out.
  bool is_behind = false;
  std::optional<Incident> incident;
};

/// Compares what the study file says without its journal, `file`, with what it says together with the journal, `both`
/// (nothing where that could not be read), and with the journal itself. Every commit counts in the row of `opening`,
/// so: a journal belongs to the file only if it continues its counting under the same token, or if it holds nothing but
/// the drawing of the next one; and the mark in the journal's last bytes tells how many commits were acknowledged. A
/// file of version 1 has no row: then nothing can be told.
JournalFindings examineJournal(const std::optional<OpeningRow>& file, const std::optional<OpeningRow>& both,
                               const JournalFile& journal);

}  // namespace tactus::store
