// Puts the CSV tables of a study into a study file.
#pragma once

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

/// Adds the tables of `study` to `file`, all or nothing. Each participant gets a session of the kind `import`. All its
/// ids follow from the study's id, the participant's code and rows, so the same rows are never added to a study twice,
/// and those of another study are another person's, even where code and rows are the same: after a merge both are
/// there, and one needs another code (store/recoding.h). Tables tell no time: the records have none, and `started`
/// counts the imports of the participant (1, 2, 3, … ms), so that changed rows count instead of earlier ones, and a
/// recorded session instead of both (study_view.h). A participant is known by the code. Refused: a participant who
/// withdrew, a code that two persons of the study have, a participant who is simulated in one place and real in the
/// other.
base::Result<StudyImport> importTables(const study::Study& study, store::StudyFile& file);

}  // namespace tactus::session
