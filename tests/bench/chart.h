// The chart of run time against error.
#pragma once

#include <string>

#include "tests/bench/results.h"

namespace tactus::bench {

/// An SVG drawing, both axes logarithmic: time of one evaluation to the right, largest error against exact rationals
/// upwards. Down and to the left is better. Contenders with the implication `scale` are left to the table.
std::string chartSvg(const Results& results);

}  // namespace tactus::bench
