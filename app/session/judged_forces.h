// Every judgement of the force experiments with what was measured beside it, for looking at the data.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/session/study_view.h"
#include "core/base/error.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"
#include "experiments/force_protocol.h"

namespace tactus::session {

// What a device can hold: the forces of the force experiment against its limits, and the pause before each.

/// Whether a hand can feel the forces of this device (SessionRecord::device): not those of the virtual one, of a replay
/// or a dummy. True for an empty name, where nothing is known.
bool givesForce(std::string_view device);

/// Refuses settings with a force that the device never gives in full: above its force cap, or held for longer than even
/// cold motors can. Such a step could never be scored. Ignores series that are off.
base::Result<void> requireHolds(const experiments::ForceSettings& settings, const haptics::LimitSettings& limits);

/// The time without force before the step of `plan`, s: the pause of the settings, or longer where the motors need it
/// to hold the force in full. Each time that the participant feels the force again needs its own. `budget`: of the
/// device now (ThermalFollower). A force without a time limit is taken to be held for 10 s.
double pauseBeforeS(const experiments::ForcePlan& plan, const haptics::ThermalBudget& budget,
                    const haptics::LimitSettings& limits);

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
