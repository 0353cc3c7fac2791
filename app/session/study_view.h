// The data of a study file for elicitation: of all records, those that count now.
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
  /// The records behind the strokes, judgements, answers and rules of `study`, in their order.
  std::vector<study::RecordId> stroke_ids;
  std::vector<study::RecordId> judgement_ids;
  std::vector<study::RecordId> answer_ids;
  std::vector<study::RecordId> rule_ids;
  std::vector<std::string> notes;  ///< one sentence each: which data are left out, and why
};

/// The study in `file`. Left out: corrected records, practice, strokes that were not accepted, judgements that are not
/// scored, catch trials and usability sessions; of real persons on a device that gives no force, judgements and (unless
/// the session's settings accept them) strokes. If a participant did a block in several sessions (a speed level, a
/// series, a form, rules), the latest complete one counts; without a complete one, the one with the most records
/// (study_view.cpp). A note then names all of them. Speeds come from the recorded positions
/// (experiments/speed_from_positions.h); a recording with a channel `speed`, as in imported tables, is used unchanged.
/// Refused: two persons with one code, for example after a merge.
base::Result<StudyView> studyForElicitation(const store::StudyFile& file);

/// The samples of one accepted stroke, as experiments::strokeMotion gives them. Errors also name the participant.
base::Result<std::vector<study::SpeedSample>> speedSamples(const study::StrokeRecord& stroke,
                                                           const std::string& participant);

}  // namespace tactus::session
