#include "tests/bench/text_table.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactus::bench {
namespace {

std::size_t shownWidth(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string threeDigits(double value) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return base::formatNumber(value);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (magnitude >= -3 && magnitude < 7) return base::formatFixed(value, std::clamp(2 - magnitude, 0, 5));
  const std::string mantissa = base::formatFixed(value / std::pow(10.0, magnitude), 1);
  // 9.96 rounds to 10.0.
  return mantissa == "10.0" ? "1.0e" + std::to_string(magnitude + 1) : mantissa + 'e' + std::to_string(magnitude);
}

std::string alignedTable(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], shownWidth(row[c]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string gap(widths[c] - shownWidth(row[c]), ' ');
      line += c < left ? row[c] + gap : gap + row[c];
      if (c + 1 < row.size()) line += "  ";
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace tactus::bench
