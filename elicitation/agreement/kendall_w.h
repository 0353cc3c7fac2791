// Kendall's coefficient of concordance W: how similarly several raters order the same units.
#pragma once

#include "elicitation/agreement/ratings.h"

namespace tactus::elicitation {

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

}  // namespace tactus::elicitation
