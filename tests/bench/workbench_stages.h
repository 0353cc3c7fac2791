// What an edit has the workbench compute, stage by stage, without a window.
#pragma once

#include <string>
#include <vector>

namespace tactus::bench {

/// Rows of texts with a heading: median times of each stage for a model of 1, 4, 32 and 256 experts.
std::vector<std::vector<std::string>> stageTimes(int rounds);

/// Rows of texts with a heading: largest differences of what is drawn from the evaluation of single points.
std::vector<std::vector<std::string>> stageDifferences();

}  // namespace tactus::bench
