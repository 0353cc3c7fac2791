// Numbers and tables as text, for all benchmarks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tactus::bench {

/// Three significant digits, two where the number is very small or large.
std::string threeDigits(double value);

/// Rows of texts, the first of them a heading: the first `left` columns to the left, the others to the right.
std::string alignedTable(const std::vector<std::vector<std::string>>& rows, std::size_t left);

}  // namespace tactus::bench
