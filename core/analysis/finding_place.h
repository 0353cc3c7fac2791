// Where in a model a finding is: by indices, ids and numbers. The words for it are made from this and never read back.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/rule_steps.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Where conditions hold; without conditions: everywhere.
struct ConditionPlace {
  std::vector<fuzzy::Condition> conditions;

  bool operator==(const ConditionPlace&) const = default;
};

/// A term of an expert's list.
struct TermPlace {
  std::size_t variable = 0;  ///< index of the input; the number of inputs stands for the output
  std::string term;          ///< id

  bool operator==(const TermPlace&) const = default;
};

/// A step between two rules of an expert.
struct StepPlace {
  std::size_t expert = 0;  ///< index
  NeighbourStep step;

  bool operator==(const StepPlace&) const = default;
};

/// The whole of one input.
struct InputPlace {
  std::size_t input = 0;  ///< index

  bool operator==(const InputPlace&) const = default;
};

/// A step of the force along one input, between two places of it; one place where they are a rounding apart.
struct CliffPlace {
  std::size_t input = 0;  ///< index
  double low = 0;
  double high = 0;

  bool operator==(const CliffPlace&) const = default;
};

/// All indices are those of the model that was linted.
using FindingPlace = std::variant<ConditionPlace, Hole, TermPlace, StepPlace, InputPlace, CliffPlace>;

/// The place in words, `depth 125 to 138 mm`, `depth oropharynx`, `depth is oropharynx and speed is slow`. For people:
/// where ids hold spaces or quotes, two places of one model may read the same. `model` is the one that was linted.
std::string describe(const FindingPlace& place, const fuzzy::ForceModel& model);

/// Index of the input that the place is about: of several the one that `describe` names first. Nothing where it is
/// everywhere or about the output.
std::optional<std::size_t> inputOf(const FindingPlace& place, const fuzzy::ForceModel& model);

/// The term that the place names, in the list that `expert` reads; null where it is no term, or not a term of hers.
const fuzzy::Term* termAt(const FindingPlace& place, const fuzzy::ForceModel& model, const fuzzy::Expert& expert);

/// The variable with the index of a TermPlace.
const fuzzy::Variable& variableAt(const fuzzy::ForceModel& model, std::size_t variable);

}  // namespace tactus::analysis
