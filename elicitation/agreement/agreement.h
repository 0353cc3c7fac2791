// Agreement of raters: all measures on one set of ratings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elicitation/agreement/agreement_data.h"
#include "elicitation/agreement/krippendorff_alpha.h"

namespace tactus::elicitation {

// Kendall's coefficient of concordance W: how similarly several raters order the same units.

// Upper tail of the chi-square distribution.

/// The probability of a value of at least `chi_square` (>= 0) with `degrees` (>= 1) degrees of freedom. For integer
/// degrees it is a finite sum of positive terms, so no digits cancel (Abramowitz and Stegun 1964, 26.4.4 and 26.4.5).
double chiSquareUpperTail(double chi_square, int degrees);

struct KendallW {
  double w = 0;  ///< 1 if all orders are equal, 0 if the orders have nothing in common
  double chi_square = 0;
  int degrees = 0;
  double p = 1;  ///< from the chi-square distribution; accurate for about eight units or more
  std::size_t raters = 0;
  std::size_t units = 0;          ///< units rated by every rater; only these count
  std::size_t dropped_units = 0;  ///< all other units
};

/// Kendall and Smith 1939 with the correction for ties, over the units rated by every rater. A rater without ratings
/// does not count. No result for fewer than two such raters or units, or if no rater distinguishes two of these units.
OrReason<KendallW> kendallW(const Ratings& ratings);

/// Fleiss' kappa: agreement of several raters on unordered categories.
struct FleissKappa {
  double kappa = 0;           ///< 1 for full agreement, 0 for agreement by chance
  double standard_error = 0;  ///< of kappa, if the ratings are random
  double z = 0;               ///< kappa / standard_error
  double p = 1;               ///< two-sided, from the normal distribution
  long long ratings_per_unit = 0;
};

/// Fleiss 1971; standard error under chance by Fleiss, Nee and Landis 1979. No result if units have different numbers
/// of ratings or fewer than two, if there are no units, or if all ratings are equal.
OrReason<FleissKappa> fleissKappa(const RatingCounts& counts);

/// Agreement of the raters of one unit.
struct ItemConsensus {
  double entropy_bits = 0;  ///< of the shares of the categories: 0 if all ratings are equal
  double consensus = 1;     ///< 1 if all ratings are equal, 0 if half are at each end of the scale
  int spread_terms = 0;     ///< highest category minus lowest
};

/// Consensus by Tastle and Wierman 2007. For categories X with shares p, mean mu and scale width d: 1 + sum p log2(1 -
/// |X - mu| / d). Unlike the entropy it takes into account that neighbors are closer than the ends. `counts`: ratings
/// per category, lowest first. Nothing for fewer than two ratings.
std::optional<ItemConsensus> itemConsensus(const std::vector<int>& counts);

struct Agreement {
  OrReason<FleissKappa> fleiss_kappa;
  OrReason<double> alpha_nominal;
  OrReason<double> alpha_ordinal;
  OrReason<double> alpha_interval;
  OrReason<KendallW> kendall_w;
  std::vector<std::optional<ItemConsensus>> items;  ///< one per unit of the data; empty for fewer than two ratings
  std::optional<double> mean_consensus = {};        ///< over the units that have one
  long long ratings = 0;
};

Agreement agreement(const AgreementData& data);

/// One sentence: why the measures for unordered categories are low for ordered terms.
std::string_view nominalCaution();

}  // namespace tactus::elicitation
