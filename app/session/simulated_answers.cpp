#include "app/session/simulated_answers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/check.h"
#include "core/base/random.h"

namespace tactus::session {
namespace {

// Levels count the form's terms: 0 is very small, 1 small, 2 medium, 3 large, 4 very large.

struct Region {
  std::string_view term;
  double level;  // before a condition has its effect
};
// The force rises in the nasal cavity, drops, peaks in the oropharynx, and settles in the esophagus near S4's answers.
constexpr std::array<Region, 5> kRegions = {
    {{"nasal_cavity", 2.4}, {"nasopharynx", 1.5}, {"oropharynx", 3.5}, {"laryngopharynx", 2.5}, {"esophagus", 2.7}}};

struct Effect {
  std::string_view input;
  std::string_view term;
  double level;
};
constexpr std::array<Effect, 9> kEffects = {{{"lubrication", "poor", 0.9},
                                             {"lubrication", "medium", 0},
                                             {"lubrication", "well", -0.9},
                                             {"neck_flexion", "small", 0.4},
                                             {"neck_flexion", "medium", -0.4},
                                             {"neck_flexion", "large", -1.2},
                                             {"speed", "slow", -0.8},
                                             {"speed", "medium", 0},
                                             {"speed", "fast", 0.9}}};

struct Nurse {
  std::string_view code;
  std::string_view sensitive_to;  // an input whose effects the nurse feels more
  double sensitivity;
  double oropharynx;  // extra level there
};
constexpr std::array<Nurse, 3> kNurses = {{{"S1", "neck_flexion", 1.15, 0},
                                           {"S2", "lubrication", 1.15, 0.8},  // Fig. 11: "relatively higher"
                                           {"S3", "speed", 1.15, 0}}};

// Deviations are uniform in ± this. Of two answers, regions differ by at most 0.2 and effects by at most 0.2 through
// them: less than the differences above that the statements of the header rest on.
constexpr double kDeviation = 0.1;

/// One nurse's levels.
struct Beliefs {
  std::array<double, kRegions.size()> region;
  std::array<double, kEffects.size()> effect;
};

Beliefs beliefsOf(const Nurse& nurse, base::Random& random) {
  Beliefs beliefs{};
  for (std::size_t i = 0; i < kRegions.size(); ++i) {
    const double extra = kRegions[i].term == "oropharynx" ? nurse.oropharynx : 0;
    beliefs.region[i] = kRegions[i].level + extra + random.uniform(-kDeviation, kDeviation);
  }
  for (std::size_t i = 0; i < kEffects.size(); ++i) {
    const double sensitivity = kEffects[i].input == nurse.sensitive_to ? nurse.sensitivity : 1;
    beliefs.effect[i] = sensitivity * kEffects[i].level + random.uniform(-kDeviation, kDeviation);
  }
  return beliefs;
}

double effectOf(const study::ItemCondition& condition, const Beliefs& beliefs) {
  const auto effect = std::find_if(kEffects.begin(), kEffects.end(), [&condition](const Effect& candidate) {
    return candidate.input == condition.input && candidate.term == condition.term;
  });
  if (effect != kEffects.end()) return beliefs.effect[static_cast<std::size_t>(effect - kEffects.begin())];
  const auto region = std::find_if(kRegions.begin(), kRegions.end(), [&condition](const Region& candidate) {
    return condition.input == "depth" && candidate.term == condition.term;
  });
  TACTUS_CHECK(region != kRegions.end());
  return beliefs.region[static_cast<std::size_t>(region - kRegions.begin())];
}

const std::string& termAt(double level, const std::vector<study::AnswerWord>& answers) {
  TACTUS_CHECK(!answers.empty());
  const double highest = static_cast<double>(answers.size() - 1);
  return answers[static_cast<std::size_t>(std::clamp(std::round(level), 0.0, highest))].term;
}

}  // namespace

std::vector<study::Answer> simulatedAnswers(const study::Form& form, std::uint64_t seed) {
  std::vector<study::Answer> answers;
  base::Random random(seed);
  for (const auto& nurse : kNurses) {
    const Beliefs beliefs = beliefsOf(nurse, random);
    for (const auto& item : form.items) {
      double level = 0;
      for (const auto& condition : item.conditions) level += effectOf(condition, beliefs);
      answers.push_back({std::string(nurse.code), form.id, item.number, termAt(level, form.answers),
                         study::Answer::Status::kAnswered});
    }
  }
  return answers;
}

}  // namespace tactus::session
