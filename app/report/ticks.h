// Round numbers for the axes of a plot.
#pragma once

#include <string>
#include <vector>

namespace tactus::report {

/// Ticks inside [min, max] at multiples of 1, 2 or 5 times a power of ten: about `count` of them, at least 2, because
/// one tick gives no scale. min < max, both finite.
std::vector<double> niceTicks(double min, double max, int count);

/// The texts of `ticks`, all with the same number of decimals: the fewest that make them distinct.
std::vector<std::string> tickTexts(const std::vector<double>& ticks);

}  // namespace tactus::report
