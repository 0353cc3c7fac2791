// Whether a rehearsed session is in the study file: what the nurse remembers against the records.
#pragma once

#include "app/workbench/rehearsal/screen_nurse.h"
#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::workbench {

/// Refuses, with one sentence: a person or a session that is missing or not marked as simulated, a block that is not
/// closed, and every word, insertion, comparison and mark that the nurse gave and the file lacks, or the other way
/// round. Thread: that of `file`.
base::Result<void> checkRehearsal(const store::StudyFile& file, const NurseMemory& memory);

}  // namespace tactus::workbench
