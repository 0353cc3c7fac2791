// Why a force is what it is, in words and as JSON.
#pragma once

#include <string>
#include <vector>

#include "core/analysis/counterfactuals.h"
#include "core/analysis/force_balance.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

struct Reasons {
  const fuzzy::ForceModel& model;
  bool fired = false;
  analysis::ForceBalance balance;
  std::vector<analysis::Counterfactual> counterfactuals;
};

/// `0.589 N because Small (-0.087 N) and Medium (-0.010 N) hold it down and Very large (+0.086 N) pulls it up. It would
/// be 0.081 N less with Neck flexion at 56.662 deg, which is 3.338 less.` Words that pull less than a tenth of the
/// strongest are left out. For one expert the strongest word on each side has the conditions of its strongest rule.
std::string sentenceOf(const Reasons& reasons);

/// The sentence, and tables of words, experts, rules and counterfactuals.
std::string asText(const Reasons& reasons);

std::string asJson(const Reasons& reasons);

}  // namespace tactus::cli
