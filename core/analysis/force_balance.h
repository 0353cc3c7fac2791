// Why the force is what it is: words, rules and experts as weights on a beam that balances at the force.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/expert_spread.h"
#include "core/analysis/explain.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::analysis {

// What would change the force at a point: one input moved, the others kept. The view of the model, not of a patient.

struct Counterfactual {
  enum class Kind {
    kTerm,         ///< the input in the middle of the core of another of its terms
    kNoticeable,   ///< the smallest move that changes the force by one just-noticeable difference
    kLargestWord,  ///< the smallest move after which another word has the largest share (ForceBalance)
  };
  Kind kind = Kind::kTerm;
  std::size_t input = 0;
  double value = 0;  ///< of the input
  double delta = 0;  ///< value - value now; 0 for a largest share that two words have together
  double force_n = 0;
  std::string term;     ///< kTerm: the term of the input; kLargestWord: the word that is largest now
  std::string instead;  ///< kLargestWord: the word that becomes the largest
};

/// The counterfactuals at `inputs` (in the order and units of the model), for the mean or the expert number `expert`
/// alone: per input first the other terms in their order (those whose membership is below 1 now; terms without a force
/// there are left out), then the two smallest moves, where there are any before a hole. A hole of one point is passed.
/// However narrow a change is, it is found if it reaches its limit by 1e-8 of the range of the force or of the area.
/// Without a force at the point there are none. Returns the error of `explain`. Thread: any.
base::Result<std::vector<Counterfactual>> counterfactuals(const fuzzy::ForceModel& model,
                                                          const fuzzy::CompiledModel& compiled,
                                                          std::span<const double> inputs,
                                                          const NoticeableDifference& noticeable,
                                                          std::optional<std::size_t> expert = std::nullopt);

/// An output term. Each slice of an expert's aggregated set belongs to the term that is largest there, the first of
/// equals. With several experts the numbers are the weighted means of theirs.
struct WordPull {
  std::string term;
  double strength = 0;
  double share = 0;       ///< of the area; all shares sum to 1
  double centroid_n = 0;  ///< of its slices; the force itself for a word that is nowhere the largest
  double pull_n = 0;      ///< share * (centroid - force): below 0 it lowers the force; all pulls sum to 0
};

/// A rule that fires. The rules of one word share its pull by the max game: a rule counts as far as it lifts the
/// strength above the rules below it, and equal rules count alike (Littlechild and Owen 1973, "airport game").
struct RulePull {
  std::size_t expert = 0;  ///< index in the model
  std::size_t rule = 0;    ///< index in Expert::rules
  double pull_n = 0;       ///< over all rules they sum to 0
};

/// An expert who does not abstain and has a weight > 0.
struct ExpertPull {
  std::size_t expert = 0;
  double force_n = 0;
  double pull_n = 0;                      ///< weight share * (own force - force); they sum to 0
  std::optional<double> leave_one_out_n;  ///< force - force without the expert; nothing for the only one
};

struct ForceBalance {
  double force_n = 0;
  std::vector<WordPull> words;  ///< those with a strength > 0, in the order of the output's terms, then of own terms
  std::vector<RulePull> rules;  ///< strongest pull first
  std::vector<ExpertPull> experts;
};

/// The balance of `explanation`, which is of `model`, for its mean or for the expert number `expert` alone. Without a
/// force (all abstain) everything is empty. Exact to rounding, with Gaussians to 1e-12 of the universe. Thread: any.
ForceBalance forceBalance(const fuzzy::ForceModel& model, const Explanation& explanation,
                          std::optional<std::size_t> expert = std::nullopt);

}  // namespace tactus::analysis
