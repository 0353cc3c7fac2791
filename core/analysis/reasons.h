// Why a force is what it is, in words: what `tactus why` and the window say of a point.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/force_balance.h"

namespace tactus::analysis {

struct Reasons {
  bool fired = false;
  ForceBalance balance;
  std::vector<Counterfactual> counterfactuals;
};

/// Of `explanation`, which is of `model`, for its mean or for the expert number `expert` alone. Returns the error of
/// `counterfactuals`. Thread: any.
base::Result<Reasons> reasonsOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                const Explanation& explanation, const NoticeableDifference& noticeable,
                                std::optional<std::size_t> expert = std::nullopt);

/// `0.589 N because Small (-0.087 N) and Medium (-0.010 N) hold it down and Very large (+0.086 N) pulls it up. It would
/// be 0.081 N less with Neck flexion at 56.662 deg, which is 3.338 less.` Words that pull less than a tenth of the
/// strongest are left out. For one expert the strongest word on each side has the conditions of its strongest rule.
std::string sentenceOf(const fuzzy::ForceModel& model, const Reasons& reasons);

/// `one just-noticeable difference`, `largest share: VL instead of S`: ids, not labels.
std::string whatOf(const Counterfactual& one);

// The names and numbers of a model in these texts.

/// `+0.086 N`, `-0.010 N`.
std::string signedNewtons(double newtons);

/// `60.000 deg`; without a unit for a share. Three digits after the point.
std::string withUnit(double number, const fuzzy::Variable& variable);

/// The label of a term, `id` without one; escaped. `term` may be null.
std::string labelOf(const fuzzy::Term* term, const std::string& id);

/// The label of the output term `id` in the shared list.
std::string wordLabel(const fuzzy::ForceModel& model, const std::string& id);

std::string variableLabel(const fuzzy::Variable& variable);

/// `Lubrication Well, Insertion depth Laryngopharynx`: the conditions of rule number `rule` of expert number `expert`.
std::string conditionsOf(const fuzzy::ForceModel& model, std::size_t expert, std::size_t rule);

}  // namespace tactus::analysis
