// Coverage: the regions of the input space where no rule fires, with exact boundaries.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// A range of one input. An excluded end does not belong to the hole.
struct InputRange {
  std::string input;
  double low = 0;
  double high = 0;
  bool low_included = true;
  bool high_included = true;
  bool whole_universe = false;

  bool operator==(const InputRange&) const = default;
};

/// A box of the input space in which no rule of the given experts fires. One range per input, in the order of the
/// model.
struct Hole {
  std::vector<InputRange> ranges;

  bool operator==(const Hole&) const = default;
};

struct Coverage {
  std::vector<Hole> holes;  ///< disjoint boxes that together cover the uncovered space
  bool complete = true;     ///< false if the search stopped early because the model has too many boxes
};

/// Limit of the memberships that a search evaluates: enough for thousands of boxes. A model that needs more gives an
/// incomplete result instead of a long wait; a larger limit means a longer wait.
inline constexpr std::size_t kCoverageAllowance = 20'000'000;

/// The common holes of the experts with the given indices. A point is covered if one of them has a rule of strength >
/// 0. For one index: the points where that expert abstains. For all experts of weight > 0: the points where the
/// averaged force has no value.
/// The boundaries are ends of supports; nothing is sampled. A Gaussian ends where its membership underflows to 0, about
/// 38.6 sigma from its mean, because the evaluation finds no firing rule beyond.
/// `model` must be valid (fuzzy::validate).
Coverage coverage(const fuzzy::ForceModel& model, std::span<const std::size_t> experts,
                  std::size_t allowance = kCoverageAllowance);

/// The name of a hole: `depth 125 to 138 mm`, the ranges that are not whole universes; `everywhere` where all are.
/// Where a Gaussian ends the number is rounded to six digits, or to more where another term ends there too. Two holes
/// of one model never have the same name, whatever the ids of its inputs.
std::string describe(const Hole& hole, const fuzzy::ForceModel& model);
/// The same with `name_of` each input instead of its id, e.g. `Insertion depth 125 to 138 mm`.
std::string describe(const Hole& hole, const fuzzy::ForceModel& model,
                     const std::function<std::string(const fuzzy::Variable&)>& name_of);

}  // namespace tactus::analysis
