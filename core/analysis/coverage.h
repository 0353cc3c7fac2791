// Coverage: the regions of the input space where no rule fires, with exact boundaries.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// A range of one input. An end that is not included is still outside the hole.
struct InputRange {
  std::string input;
  double low = 0;
  double high = 0;
  bool low_included = true;
  bool high_included = true;
  bool whole_universe = false;

  bool operator==(const InputRange&) const = default;
};

/// A box of the input space in which no rule of the experts in question fires. One range per input, in the model's
/// order.
struct Hole {
  std::vector<InputRange> ranges;

  bool operator==(const Hole&) const = default;
};

struct Coverage {
  std::vector<Hole> holes;  ///< disjoint boxes; together they are all of the uncovered space
  bool complete = true;     ///< false where the search was cut off because the model is too finely divided
};

/// Memberships that a search may look at: enough for thousands of boxes. A model that needs more is reported as
/// incomplete instead of keeping people waiting; a larger number makes them wait longer.
inline constexpr std::size_t kCoverageAllowance = 20'000'000;

/// Holes of the experts at the given indices taken together: a point is covered where one of them has a rule of
/// strength > 0. With one index: where that expert abstains; with all of weight > 0: where the averaged force has no
/// value. The boundaries are ends of supports, nothing is sampled. A Gaussian ends where its membership underflows to
/// 0, about 38.6 sigma from its mean: beyond, the evaluation finds that no rule fires. `model` must be valid
/// (fuzzy::validate).
Coverage coverage(const fuzzy::ForceModel& model, std::span<const std::size_t> experts,
                  std::size_t allowance = kCoverageAllowance);

/// The name of a hole: `depth 125 to 138 mm`, the ranges that are not whole universes; `everywhere` where all are.
/// Where a Gaussian ends the number is rounded to six digits, or to more where another term ends there too. Two holes
/// of one model never have the same name, whatever the ids of its inputs.
std::string describe(const Hole& hole, const fuzzy::ForceModel& model);
/// The same with another name for each input, `Insertion depth 125 to 138 mm`.
std::string describe(const Hole& hole, const fuzzy::ForceModel& model,
                     const std::function<std::string(const fuzzy::Variable&)>& name_of);

}  // namespace tactus::analysis
