// Puts the records of another study file into this one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/store/study_info.h"

namespace tactus::store {

struct Merge {
  std::vector<TableCount> added;       ///< rows that are new, of each table that has some
  long long withdrawn = 0;             ///< persons of this file who withdrew in the other one: removed here too
  std::vector<std::string> conflicts;  ///< one sentence each; nothing was overwritten
};

/// Adds what the study at `other` has and this one has not, record by record by its id, in one transaction. The other
/// file is only read. Nothing is overwritten, and merging again adds nothing. A person who withdrew in either file
/// stays out or is removed, with all traces; rules and codes of theirs come in with no model and no text. The result is
/// the same in whatever order files are merged, but for import_log, for the time that a cleaned model notes, and where
/// two files hold different records under one id, which only a change by hand can cause: then this file's is kept.
/// Listed as conflicts, with both sides kept: a code of two persons (with the command that gives one another code), a
/// session that went on in both files, a record that both files correct (the later correction counts); and who stays
/// out. `log_id`, `utc_ms` and `sha256` (empty: of the other file) are for the line in import_log, which is written
/// where anything is new. Refused: what cannot be opened, a study of another version of the schema (open it once for
/// writing), a person with the code of somebody else who withdrew from the other file.
base::Result<Merge> mergeStudy(StudyFile& file, const std::string& other, const study::RecordId& log_id,
                               std::int64_t utc_ms, const std::string& sha256 = {});

}  // namespace tactus::store
