// Round numbers for the axes of a plot.
#pragma once

#include <string>
#include <vector>

namespace tactus::report {

/// Ticks inside [min, max] at multiples of 1, 2 or 5 times a power of ten, about `count` of them (at least 2, so that
/// the scale can be read). min < max, both finite.
std::vector<double> niceTicks(double min, double max, int count);

/// Texts of `ticks` with the same number of decimals, as few as tell them apart.
std::vector<std::string> tickTexts(const std::vector<double>& ticks);

}  // namespace tactus::report
