// The claims checklist: what the paper says of its Fig. 10 and 11 (section 3.4), computed from a model, yes or no.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/force_curves.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::report {

/// A difference in order counts only above this; equal forces come from equal rules.
inline constexpr double kTieN = 1e-6;
/// A statement about a whole curve holds when it holds at this share of the depths and on average.
inline constexpr double kEnoughDepths = 0.9;
/// A rise or drop smaller than this (1 % of the force universe) would not be seen in a figure.
inline constexpr double kVisibleN = 0.01;
/// Profiles with at least this correlation over the regions count as similar.
inline constexpr double kSimilarCorrelation = 0.7;

using elicitation::justNoticeableDifference;

/// Why a verdict can be what it is.
enum class ClaimBasis {
  kPublishedRules,  ///< rules printed in the paper
  kSimulated,       ///< answers simulated to follow the paper's text
  kByConstruction,  ///< joins published rules with answers simulated to follow the text
};

/// A statement, tried on one subject.
struct Verdict {
  std::string subject;        ///< expert's id, `mean`, `all experts`
  std::optional<bool> holds;  ///< nothing: it cannot be asked of this subject
  ClaimBasis basis = ClaimBasis::kByConstruction;
  std::string numbers;  ///< what was computed
  std::string reason;   ///< why it does not hold, where that can be told; else empty
};

struct Claim {
  std::string id;         ///< `10a` to `10c`, `11a` to `11f`
  std::string statement;  ///< what the paper says, in our words
  std::string rule;       ///< how it is decided
  std::vector<Verdict> verdicts;
};

/// Who is who in the model.
struct ClaimSubjects {
  std::string published_expert = "S4";     ///< whose rules the paper prints
  std::string highest_peak_expert = "S2";  ///< whose peak the paper calls the highest
};

/// All statements, in the order of the paper, for the published expert, the mean, and where the paper speaks of all
/// experts for each of them. Refused: a model without the four inputs of the study, or without the published expert.
base::Result<std::vector<Claim>> checkClaims(const fuzzy::ForceModel& model, const ClaimSubjects& subjects);

}  // namespace tactus::report
