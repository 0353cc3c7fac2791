// Kendall's coefficient of concordance W: how alike several raters order the same units.
#pragma once

#include "elicitation/agreement/ratings.h"

namespace tactus::elicitation {

struct KendallW {
  double w = 0;  ///< 1 where all order alike, 0 where the orders have nothing in common
  double chi_square = 0;
  int degrees = 0;
  double p = 1;  ///< from the chi-square distribution, good from about eight units
  std::size_t raters = 0;
  std::size_t units = 0;          ///< those that every rater rated; the others do not count
  std::size_t dropped_units = 0;  ///< the others
};

/// Kendall and Smith 1939 with the correction for ties, over the units that every rater rated; a rater without any
/// rating does not count. No result with fewer than two such raters or units, or where no rater tells two of these
/// units apart.
OrReason<KendallW> kendallW(const Ratings& ratings);

}  // namespace tactus::elicitation
