// Sampled centroids, as other fuzzy tools compute them. Only for comparison with the exact one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/fuzzy/compiled_model.h"

namespace tactus::analysis {

struct Sampling {
  enum class Rule {
    kMidpoint,  ///< centers of `count` equal cells (fuzzylite)
    kLinspace,  ///< `count` points from end to end (MATLAB, Octave)
  };
  Rule rule = Rule::kMidpoint;
  std::size_t count = 1000;
};

/// The force with sampled instead of exact centroids. Averaging and abstaining as in CompiledModel. `expert`: this
/// expert alone. NaN if a rule fires but its output set lies between the samples.
fuzzy::Evaluation evaluateSampled(const fuzzy::CompiledModel& model, std::span<const double> inputs,
                                  const Sampling& sampling, std::optional<std::size_t> expert = std::nullopt);

}  // namespace tactus::analysis
