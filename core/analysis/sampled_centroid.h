// Sampled centroids, as other fuzzy tools compute them: for comparison with the exact one, never for the product.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/fuzzy/compiled_model.h"

namespace tactus::analysis {

struct Sampling {
  enum class Rule {
    kMidpoint,  ///< the middles of `count` equal cells (fuzzylite)
    kLinspace,  ///< `count` points from end to end (MATLAB, Octave)
  };
  Rule rule = Rule::kMidpoint;
  std::size_t count = 1000;
};

/// The force with every expert's centroid sampled instead of exact. Averaging and abstaining as in CompiledModel; one
/// expert alone where `expert` is given. NaN where a rule fires but its output set falls between the samples.
fuzzy::Evaluation evaluateSampled(const fuzzy::CompiledModel& model, std::span<const double> inputs,
                                  const Sampling& sampling, std::optional<std::size_t> expert = std::nullopt);

}  // namespace tactus::analysis
