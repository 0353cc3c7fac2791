// The edits that come nearest to a reference curve, in words and as JSON.
#pragma once

#include <optional>
#include <string>

#include "app/cli/pull_text.h"
#include "core/analysis/pull/pull_curve.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

/// The force at the point of the pull, beside what was found.
struct CurveQuestion {
  const fuzzy::ForceModel& model;
  std::optional<double> before_n;  ///< nothing in a hole
  std::optional<double> target_n;
  bool rules_left_out = false;  ///< the pull was of a mean
};

/// The edits and what they leave; `5 edits give the same curve` where one curve does not tell them apart.
std::string curveCandidateText(const fuzzy::ForceModel& model, const analysis::CurveCandidate& candidate);

std::string asText(const CurveQuestion& question, const analysis::CurvePull& pull, const PullNotes& notes);

std::string asJson(const CurveQuestion& question, const analysis::CurvePull& pull, const PullNotes& notes);

}  // namespace tactus::cli
