// What would change the force at a point: one input moved, the others kept. The view of the model, not of a patient.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/expert_spread.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::analysis {

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

}  // namespace tactus::analysis
