// Force terms by frequency: the trapezoids closest to the shares of answers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

// Least-squares fit of ordered ramps: the terms that sum to 1 and lie closest to shares of answers.

/// The shares of the terms (lowest first, sum 1) among the answers at one force.
struct FrequencyPoint {
  double force_n = 0;
  double weight = 1;  ///< > 0, the number of answers
  std::vector<double> shares;
};

/// The transition from one term to the next. The lower term has membership 1 up to `begin_n`, the higher one from
/// `end_n` on; between them the two sum to 1.
struct TermRamp {
  double begin_n = 0;
  double end_n = 0;
};

/// The ramps between neighboring terms with the least weighted sum of squares of (membership - share) over points and
/// terms. Begin <= end <= next begin, inside [min_n, max_n] with min_n < max_n.
/// `points`: in strictly ascending force inside the universe, at least one, all with the same number of terms (at least
/// one). Returns one ramp fewer than terms.
/// If the points leave a ramp open, it is as wide as possible, and ramps in one gap are equally wide. Answers cannot
/// resolve ramps steeper than their own spacing. So a ramp that contains a point is at least as wide as the smallest
/// distance between two points. A ramp between two points is at least half as wide, divided by the number of ramps, so
/// that all fit into one gap. Only outside the points may a ramp have no width.
///
/// Deterministic. Dynamic programming over a grid of end positions finds the valley; it searches the whole grid, so
/// there are no start values. The same over ever finer positions finds the bottom, to a micronewton.
std::vector<TermRamp> fitRamps(std::span<const FrequencyPoint> points, double min_n, double max_n);

/// The answers at one force.
struct FrequencyStep {
  double force_n = 0;
  int votes = 0;
  std::vector<double> shares;  ///< shares of the terms, lowest first; empty without votes
};

struct FrequencyTerms : ForceTerms {
  std::vector<FrequencyStep> steps;  ///< all steps, including those that do not count
  double rms_error = 0;              ///< root mean square of membership - share, over counting answers and terms
};

/// The frequency curve of `output`'s terms (ids and labels from there, lowest first; universe from 0): trapezoids that
/// sum to 1 everywhere, fitted by least squares to the shares. Each answer has the same weight (after Chameau and
/// Santamarina 1987; the paper's vote keeps only the winner of each force).
/// Counting steps, end of the universe and terms above all chosen ones: as in `forceTerms`. Returns an error for no
/// votes, or votes at 0 N only. `steps`: from `vote`, with as many terms as `output`.
base::Result<FrequencyTerms> frequencyTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                            std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
