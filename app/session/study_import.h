// Imports the CSV tables of a study into a study file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/records.h"

namespace tactus::session {

struct StudyImport {
  std::size_t persons = 0;         ///< new persons
  std::size_t sessions = 0;        ///< new sessions: one for each participant with new rows
  std::size_t records = 0;         ///< records in them
  std::vector<std::string> notes;  ///< one sentence each, for rows that existed already
};

/// The origin of the tables, for the study's import log (store/import_log.h).
struct ImportSource {
  std::string name;         ///< name of the folder
  std::string sha256;       ///< of the bytes that were read
  std::int64_t utc_ms = 0;  ///< time of the import; all records get it
};

/// Adds the tables of `study` to `file`, all or nothing. Each participant gets a session of the kind `import`. All its
/// ids follow from the study's id, the participant's code and rows, and the time of the import. The same rows in
/// another study belong to another person: after a merge both exist, and one needs another code (store/recoding.h).
/// Rows equal to a participant's latest import are not added again. Rows equal to an older import are added, so that
/// the last import counts (study_view.cpp), also instead of an earlier recorded session. Records have the time of
/// the import, and the study logs their origin (store/import_log.h). The code identifies the participant. Refused: a
/// participant who withdrew, a code of two persons of the study, a participant who is simulated in one place and real
/// in the other.
base::Result<StudyImport> importTables(const study::Study& study, store::StudyFile& file,
                                       const ImportSource& source = {});

/// The origin of the tables in `folder`, read at `utc_ms` as the study `name`.
base::Result<ImportSource> tablesSource(const std::string& folder, const std::string& name, std::int64_t utc_ms);

/// importTables into the new study file `path`, which must not exist and appears completely or not at all. `program`:
/// name and version of the program that makes it. Errors name `path`.
base::Result<StudyImport> importAsNewStudy(const study::Study& study, const std::string& path,
                                           const ImportSource& source, const std::string& program);

}  // namespace tactus::session
