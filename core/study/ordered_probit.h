// The boundaries between the terms of the force: thresholds on the force axis, estimated from judgements of one
// participant or of several together.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tactus::study {

/// Equal judgements: a force, the index of its term, from the smallest force, and how many there are, above 0.
struct TermAtForce {
  double force_n = 0;
  std::size_t term = 0;
  double count = 1;
};

struct TermThresholds {
  enum class Method {
    kOrderedProbit,  ///< maximum likelihood
    kMidpoints,      ///< terms do not overlap, or fall while the force rises: the likelihood has no maximum
  };
  /// Threshold `i` lies between terms i and i + 1. Empty if one of its sides has no judgement.
  std::vector<std::optional<double>> threshold_n;
  std::optional<double> sigma_n;  ///< spread of the percept; ordered probit only
  Method method = Method::kMidpoints;
};

/// `ordered_probit`, `midpoints`.
std::string_view name(TermThresholds::Method method) noexcept;

/// The thresholds for `term_count` >= 2 terms.
///
/// Ordered probit (McKelvey and Zavoina 1975): a force F is felt as F + N(0, sigma²), and the term is the interval
/// between two thresholds that contains the percept. The likelihood is concave in (threshold / sigma, 1 / sigma) (Pratt
/// 1981), so Newton's method with step halving finds its only maximum. An unused term has an interval of width 0.
/// Midpoints: used if the terms never overlap, or if the maximum has sigma below 1 mN or no positive sigma. Each
/// threshold is then the force with the fewest judgements on the wrong side: the middle between two neighboring forces.
/// If several are equal, it is the middle of the lowest and the highest.
TermThresholds termThresholds(std::span<const TermAtForce> judgements, std::size_t term_count);

}  // namespace tactus::study
