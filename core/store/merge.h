// Merges the records of another study file into this one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/connection.h"
#include "core/store/study_file.h"
#include "core/store/study_info.h"

namespace tactus::store {

// Records that contradict each other, which only two copies of a study can cause. Private to core/store.

/// One sentence per conflict: missing or duplicate numbers in the order of a session, codes of two persons, records
/// with two corrections, circular corrections. Throws as Query does.
std::vector<std::string> conflicts(Connection& connection);

/// The conflicts that are circular corrections.
std::vector<std::string> circles(Connection& connection);

struct Merge {
  std::vector<TableCount> added;  ///< number of new rows in each table that has some
  long long withdrawn = 0;        ///< persons of this file who withdrew in the other one; removed from this file too
  std::vector<std::string> conflicts;  ///< one sentence each; no record was overwritten
};

/// Adds the records of the study `other` that this study lacks, by id, in one transaction. The other file is only read.
/// No record is overwritten, and a second merge adds nothing.
/// A person who withdrew in either file stays out or is removed completely; their rules and codes do not enter with a
/// model or a text.
/// The result does not depend on the order of merges, except for import_log, the time noted in a cleaned model, and
/// different records with the same id. Such records can only come from a manual change; this file's record is then
/// kept.
/// Conflicts keep both sides and are listed: a code of two persons (with the command that assigns another code), a
/// session that continued in both files, a record corrected in both files (the later correction counts). Persons who
/// stay out are listed too.
/// `log_id`, `utc_ms`, `sha256` (empty: that of the other file): for the line in import_log, written if anything is
/// new.
/// Returns an error if the other file cannot be opened, has another schema version (open it once for writing), or has a
/// person with the code of another person who withdrew from this one, or the reverse.
base::Result<Merge> mergeStudy(StudyFile& file, const std::string& other, const study::RecordId& log_id,
                               std::int64_t utc_ms, const std::string& sha256 = {});

}  // namespace tactus::store
