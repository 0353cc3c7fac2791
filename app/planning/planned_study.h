// A plan with what it is for: a study to come, or one that runs; and what it says in sentences.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/planning/nurse_family.h"
#include "app/planning/study_plan.h"
#include "app/session/study_procedure.h"
#include "core/base/error.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::planning {

inline constexpr std::string_view kSimulatedNurses =
    "Simulated nurses, not real ones: they show what the method does with nurses like these, not what yours will say.";

/// What is planned, and its result.
struct PlannedStudy {
  Questions questions;
  NurseFamily family;
  PlanSettings settings;
  std::optional<Design> now;       ///< of the running study
  std::vector<std::string> notes;  ///< one sentence each: what is assumed
  StudyPlan plan;                  ///< empty until `simulate`
};

/// Before a study of the procedure. Without questions in `wanted`: a third, two thirds and all of the form.
PlannedStudy planBefore(const session::ProcedurePtr& about, const PlanSettings& wanted);

/// For a study that runs, from what its nurses gave so far. Without questions in `wanted`: ten fewer than now, as many
/// and ten more; the present design is always among those that are simulated. Returns the errors of familyOf.
base::Result<PlannedStudy> planDuring(const study::Study& study, const elicitation::BuiltModel& built,
                                      const elicitation::BuildSettings& build, const PlanSettings& wanted);

/// Simulates the studies (planStudy).
base::Result<void> simulate(PlannedStudy& planned, const std::function<bool(double share)>& go_on);

/// What the next step of a running study buys.
struct Gain {
  Design from, to;
  double buys_n = 0;  ///< how much smaller the error becomes
};
/// Two more nurses, ten more questions, ten fewer; those that were simulated. Empty for a study to come.
std::vector<Gain> gainsOf(const PlannedStudy& planned);

/// `2 more nurses buy 0.030 N.`
std::string sentence(const Gain& gain);
/// `4 nurses, 45 questions, 4 strokes at each speed`
std::string designText(const Questions& questions, const Design& design);
/// The cheapest design for the wanted precision, or how near the best one comes.
std::string cheapestSentence(const PlannedStudy& planned);

}  // namespace tactus::planning
