#include "core/base/tables/decimal_comma.h"

#include <algorithm>
#include <string>

#include "core/base/ascii.h"
#include "core/base/text.h"

namespace tactus::base {
namespace {

/// Groups of three digits behind the first comma, two or more or with a decimal point behind them: `1,234,567.8`.
bool hasThousands(std::string_view number) {
  const std::size_t point = number.find('.');
  std::string_view groups = number.substr(0, point);
  const auto commas = std::count(groups.begin(), groups.end(), ',');
  if (commas == 0 || (commas == 1 && point == std::string_view::npos)) return false;
  const std::size_t first = groups.find(',');
  if (first == 0 || first > 3 || groups.size() - first != 4 * static_cast<std::size_t>(commas)) return false;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const bool comma_here = i >= first && (i - first) % 4 == 0;
    if (comma_here ? groups[i] != ',' : !isDigit(groups[i])) return false;
  }
  return true;
}

}  // namespace

DecimalCommas::Cell DecimalCommas::kindOf(std::string_view cell) {
  std::string_view number = trimmed(cell);
  if (number.find(',') == std::string_view::npos) {
    const bool point = number.find('.') != std::string_view::npos;
    return point && parseNumber(number) ? Cell::kPoint : Cell::kOther;
  }
  if (number.starts_with('-')) number.remove_prefix(1);
  if (number.size() > 40) return Cell::kOther;
  if (hasThousands(number)) return Cell::kThousands;
  std::string plain(number);
  const std::size_t comma = plain.find(',');
  plain[comma] = '.';
  const bool digits = comma > 0 && comma + 1 < plain.size() && isDigit(plain[comma - 1]) && isDigit(plain[comma + 1]);
  if (!digits || !parseNumber(plain)) return Cell::kOther;
  const std::string_view after = number.substr(comma + 1);
  const bool group = after.size() == 3 && std::all_of(after.begin(), after.end(), isDigit);
  const bool can_be_thousands = group && comma <= 3 && number.front() != '0';
  return can_be_thousands ? Cell::kEither : Cell::kDecimal;
}

void DecimalCommas::add(std::string_view cell) {
  switch (kindOf(cell)) {
    case Cell::kDecimal:
      ++decimal_;
      break;
    case Cell::kThousands:
      ++thousands_;
      break;
    case Cell::kPoint:
      ++points_;
      break;
    case Cell::kEither:
    case Cell::kOther:
      break;
  }
}

}  // namespace tactus::base
