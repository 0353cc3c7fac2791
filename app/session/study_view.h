// What elicitation needs of a study file: of everything that was recorded, what holds now.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/records.h"
#include "core/study/session_records.h"

namespace tactus::session {

struct StudyView {
  study::Study study;
  std::vector<std::string> notes;  ///< one sentence each: what was left out, and why
};

/// The study in `file`. Corrected records, practice, strokes that were not accepted, judgements that are not scored,
/// catch trials and usability sessions are left out. Where a participant did a block in several sessions (a speed
/// level, a series, a form, rules), the latest one in which it is complete counts, otherwise the one with most of it
/// (counted_session.h), with a note that names all of them. Speeds come from the recorded positions
/// (experiments/speed_from_positions.h); a recording that has a channel `speed`, as imported tables do, is taken as it
/// is. Refused: two persons with one code, which a merge may bring together.
base::Result<StudyView> studyForElicitation(const store::StudyFile& file);

/// The samples of one accepted stroke, as experiments::strokeMotion gives them. Errors name the participant too.
base::Result<std::vector<study::SpeedSample>> speedSamples(const study::StrokeRecord& stroke,
                                                           const std::string& participant);

}  // namespace tactus::session
