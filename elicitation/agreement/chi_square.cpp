#include "elicitation/agreement/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check.h"

namespace tactus::elicitation {

double chiSquareUpperTail(double chi_square, int degrees) {
  TACTUS_CHECK(chi_square >= 0 && degrees >= 1);
  const double half = chi_square / 2;
  if (half == 0) return 1;
  // Term k is exp(-half) half^k / Gamma(k + 1), for k = 0, 1, … or 1/2, 3/2, … below degrees / 2. In logarithms,
  // because with many degrees the factors leave the range of double although their product does not.
  const bool odd = degrees % 2 == 1;
  double sum = odd ? std::erfc(std::sqrt(half)) : 0;
  double k = odd ? 0.5 : 0;
  double log_term = -half;
  if (odd) log_term += 0.5 * std::log(half) - 0.5 * std::log(std::numbers::pi / 4);
  for (; 2 * k < degrees; k += 1, log_term += std::log(half / k)) sum += std::exp(log_term);
  return std::min(sum, 1.0);
}

}  // namespace tactus::elicitation
