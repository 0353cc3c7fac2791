// The place of a finding in a model, as indices, ids and numbers. The text for the user is made from it and never
// parsed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/rule_table.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The points where conditions hold; without conditions: everywhere.
struct ConditionPlace {
  std::vector<fuzzy::Condition> conditions;

  bool operator==(const ConditionPlace&) const = default;
};

/// A term of an expert's list.
struct TermPlace {
  std::size_t variable = 0;  ///< index of the input; the number of inputs means the output
  std::string term;          ///< id

  bool operator==(const TermPlace&) const = default;
};

/// A step between two rules of an expert.
struct StepPlace {
  std::size_t expert = 0;  ///< index
  NeighborStep step;

  bool operator==(const StepPlace&) const = default;
};

/// The whole of one input.
struct InputPlace {
  std::size_t input = 0;  ///< index

  bool operator==(const InputPlace&) const = default;
};

/// A step of the force along one input, between two positions; they are equal if they differ by rounding only.
struct CliffPlace {
  std::size_t input = 0;  ///< index
  double low = 0;
  double high = 0;

  bool operator==(const CliffPlace&) const = default;
};

/// Indices refer to the linted model.
using FindingPlace = std::variant<ConditionPlace, Hole, TermPlace, StepPlace, InputPlace, CliffPlace>;

/// The place in words for the user, e.g. `depth 125 to 138 mm`, `depth oropharynx`, `depth is oropharynx and speed is
/// slow`. Not unique: if ids contain spaces or quotes, two places may have the same text. `model`: the linted model.
std::string describe(const FindingPlace& place, const fuzzy::ForceModel& model);

/// The index of the input of the place; if there are several, the one that `describe` names first. Nothing if the place
/// is everywhere or on the output.
std::optional<std::size_t> inputOf(const FindingPlace& place, const fuzzy::ForceModel& model);

/// The term of the place in the list of `expert`. Null if the place is not a term, or not a term of this expert.
const fuzzy::Term* termAt(const FindingPlace& place, const fuzzy::ForceModel& model, const fuzzy::Expert& expert);

/// The variable for the index of a TermPlace.
const fuzzy::Variable& variableAt(const fuzzy::ForceModel& model, std::size_t variable);

}  // namespace tactus::analysis
