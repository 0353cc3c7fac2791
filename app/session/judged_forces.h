// Every judgement of the force experiments with what was measured beside it, for looking at the data.
#pragma once

#include <string>
#include <vector>

#include "app/session/study_view.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

/// What a judgement says.
struct JudgedWord {
  study::ForceJudgement::Kind kind = study::ForceJudgement::Kind::kTerm;
  std::string term;  ///< term id of kTerm; else empty

  bool operator==(const JudgedWord&) const = default;
};

struct JudgedForce {
  std::string participant;
  study::JudgementRecord record;   ///< as it holds now
  bool counts = false;             ///< elicitation uses it (study_view.h)
  std::vector<JudgedWord> before;  ///< what it said before corrections, the first word first
};

/// The judgements of the sessions that `view` (of `file`) counts a judgement of, participant after participant in the
/// order of the study, then in the order of the judgements. Also those that elicitation leaves out: practice, blanks,
/// attempts that were not scored. Thread: that of `file`.
base::Result<std::vector<JudgedForce>> judgedForces(const store::StudyFile& file, const StudyView& view);

}  // namespace tactus::session
