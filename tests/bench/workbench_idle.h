// How much of a processor core the window takes without input.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::bench {

/// Share of a core in percent, all threads of the process together, each over `seconds`: both stages at rest, and Tune
/// while the virtual device is felt by a hand that does not move. A QApplication must exist.
std::vector<std::pair<std::string, double>> idleShares(const fuzzy::ForceModel& model, int seconds);

}  // namespace tactus::bench
