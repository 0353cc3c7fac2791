// Puts the CSV tables of a study into a study file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/records.h"

namespace tactus::session {

struct StudyImport {
  std::size_t persons = 0;         ///< new ones
  std::size_t sessions = 0;        ///< new ones: one for each participant whose rows are new
  std::size_t records = 0;         ///< in them
  std::vector<std::string> notes;  ///< one sentence each: whose rows were there already
};

/// Where tables come from, for the study's memory (store/import_log.h).
struct ImportSource {
  std::string name;         ///< of the folder
  std::string sha256;       ///< over what was read
  std::int64_t utc_ms = 0;  ///< when; all records get it
};

/// Adds the tables of `study` to `file`, all or nothing. Each participant gets a session of the kind `import`. All its
/// ids follow from the study's id, the participant's code and rows, and the time of the import; the same rows in
/// another study are another person's: after a merge both are there, and one needs another code (store/recoding.h).
/// Rows that are those of the latest import of a participant are not added again; older ones are, so that what was
/// imported last counts (counted_session.h), also instead of a session that was recorded before. Records have the time
/// of the import, and the study remembers where they came from (store/import_log.h). A participant is known by the
/// code. Refused: a participant who withdrew, a code that two persons of the study have, a participant who is simulated
/// in one place and real in the other.
base::Result<StudyImport> importTables(const study::Study& study, store::StudyFile& file,
                                       const ImportSource& source = {});

}  // namespace tactus::session
