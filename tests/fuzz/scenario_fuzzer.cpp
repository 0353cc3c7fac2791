#include "tests/fuzz/scenario_fuzzer.h"

#include <algorithm>

#include "app/simulation/scenario.h"
#include "core/base/check.h"

namespace tactus::fuzz {

void fuzzScenario(std::string_view bytes) {
  const auto scenario = simulation::parseScenario(bytes);
  if (!scenario) {
    TACTUS_CHECK(!scenario.error().wanted.empty());
    return;
  }
  TACTUS_CHECK(scenario->duration_s >= 0 && scenario->duration_s <= simulation::kLongestRunS);
  const auto earlier = [](const auto& a, const auto& b) { return a.at_s < b.at_s; };
  TACTUS_CHECK(std::is_sorted(scenario->events.begin(), scenario->events.end(), earlier));
}

}  // namespace tactus::fuzz
