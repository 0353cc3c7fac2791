#include "tests/support/invented_experts.h"

#include <array>
#include <utility>

#include "tests/support/ngt_model.h"

namespace tactus::support {

fuzzy::Expert expertOfDigits(const char* id, const char* digits) {
  constexpr std::array<const char*, 5> kWords = {"very_small", "small", "medium", "large", "very_large"};
  constexpr std::array<const char*, 5> kRegions = {"nasal_cavity", "nasopharynx", "laryngopharynx", "esophagus",
                                                   "stomach"};
  constexpr std::array<std::pair<const char*, const char*>, 9> kConditions = {{{"lubrication", "well"},
                                                                               {"lubrication", "medium"},
                                                                               {"lubrication", "poor"},
                                                                               {"neck_flexion", "small"},
                                                                               {"neck_flexion", "medium"},
                                                                               {"neck_flexion", "large"},
                                                                               {"speed", "slow"},
                                                                               {"speed", "medium"},
                                                                               {"speed", "fast"}}};
  fuzzy::Expert expert;
  expert.id = expert.label = id;
  const char* digit = digits;
  for (const auto& [input, term] : kConditions) {
    for (const char* region : kRegions) {
      while (*digit == ' ') ++digit;
      expert.rules.push_back({{{input, term}, {"depth", region}}, kWords[static_cast<std::size_t>(*digit++ - '1')]});
    }
  }
  return expert;
}

fuzzy::ForceModel inventedExperts() {
  auto model = s4FiveRegions();
  model.experts = {expertOfDigits("E1", "12221 13332 34443 23432 23332 22321 13331 23332 33443"),
                   expertOfDigits("E2", "13333 34442 45554 34443 33433 13432 23332 33443 34544"),
                   expertOfDigits("E3", "12222 33432 24543 23443 22432 22332 22332 23432 23533"),
                   model.experts.front()};
  return model;
}

}  // namespace tactus::support
