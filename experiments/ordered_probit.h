// Where one person's terms begin: thresholds on the force axis from judgements.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tactus::experiments {

/// One judgement: a force and the term it was given, by its place from the least.
struct TermAtForce {
  double force_n = 0;
  std::size_t term = 0;
};

struct TermThresholds {
  enum class Method {
    kOrderedProbit,  ///< maximum likelihood
    kMidpoints,      ///< no overlap between the terms, or terms that fall with the force: the likelihood has no maximum
  };
  /// Threshold `i` lies between terms i and i + 1. Absent where no judgement lies on one of its sides.
  std::vector<std::optional<double>> threshold_n;
  std::optional<double> sigma_n;  ///< spread of the percept, of the ordered probit only
  Method method = Method::kMidpoints;
};

/// `ordered_probit`, `midpoints`.
std::string_view name(TermThresholds::Method method) noexcept;

/// Thresholds of one person for `term_count` >= 2 terms.
///
/// Ordered probit (McKelvey and Zavoina 1975): a force F is felt as F + N(0, sigma²), and the term is the interval
/// between two thresholds that it falls into. The likelihood is concave in (threshold / sigma, 1 / sigma) (Pratt 1981),
/// so Newton's method with step halving finds its one maximum. A term that was never used has an interval of no width.
/// Where the terms do not overlap anywhere, or the maximum has sigma below 1 mN or no positive value at all, each
/// threshold is the force that puts the fewest judgements on the wrong side: the middle between the two neighbouring
/// forces, and of equally good places the middle of the lowest and the highest.
TermThresholds termThresholds(std::span<const TermAtForce> judgements, std::size_t term_count);

}  // namespace tactus::experiments
