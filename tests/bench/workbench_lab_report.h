// The measurements of the labs as text.
#pragma once

#include <string>

#include "tests/bench/workbench_drag.h"

namespace tactus::bench {

/// Alpha, m and trimming with 4 x 24,000 samples, `moves` moves each, as tables.
std::string labReport(TimedApplication& application, int moves);

/// All labs of the study file `path`, as a table.
std::string visitReport(const std::string& path);

}  // namespace tactus::bench
