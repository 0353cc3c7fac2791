#include "core/base/rounded_number.h"

#include <cmath>

#include "core/base/text.h"

namespace tactus::base {

std::string roundedNumber(double value) {
  const double size = std::abs(value);
  if (!(size >= 1e-3 && size < 1e6)) return formatNumber(value);
  std::string text = formatFixed(value, 4);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace tactus::base
