// What the paper says of its nurses holds for the simulated ones, whatever the seed.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <tuple>

#include "app/session/simulated_study.h"
#include "questionnaires/form_file.h"
#include "questionnaires/published_rules.h"

#include "tests/support/default_procedure.h"

namespace tactus::session {
namespace {

/// Level (0 very small to 4 very large) by participant, condition (input and term) and region.
using Levels = std::map<std::tuple<std::string, std::string, std::string>, int>;

const std::vector<std::string> kNurses = {"S1", "S2", "S3"};
const std::vector<std::string> kRegions = {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"};
const std::vector<std::string> kConditions = {"lubrication poor",   "lubrication medium",  "lubrication well",
                                              "neck_flexion small", "neck_flexion medium", "neck_flexion large",
                                              "speed slow",         "speed medium",        "speed fast"};

int levelOf(const std::string& term) {
  const std::vector<std::string> terms = {"very_small", "small", "medium", "large", "very_large"};
  return static_cast<int>(std::find(terms.begin(), terms.end(), term) - terms.begin());
}

void add(Levels& levels, const std::string& participant, const std::vector<study::ItemCondition>& conditions,
         const std::string& term) {
  std::string region;
  std::string condition;
  for (const auto& part : conditions) {
    if (part.input == "depth") {
      region = part.term;
    } else {
      condition = part.input + " " + part.term;
    }
  }
  levels[{participant, condition, region}] = levelOf(term);
}

Levels simulatedLevels(std::uint64_t seed) {
  const auto form = support::ngtForceForm();
  Levels levels;
  for (const auto& answer : simulatedAnswers(form, seed)) {
    add(levels, answer.participant, form.items.at(static_cast<std::size_t>(answer.item) - 1).conditions, answer.term);
  }
  return levels;
}

class SimulatedAnswers : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  int at(const std::string& nurse, const std::string& condition, const std::string& region) const {
    return levels_.at({nurse, condition, region});
  }
  int sum(const std::string& nurse, const std::string& region) const {
    int total = 0;
    for (const auto& condition : kConditions) total += at(nurse, condition, region);
    return total;
  }
  const Levels levels_ = simulatedLevels(GetParam());
};

TEST_P(SimulatedAnswers, FollowTheConditions) {
  for (const auto& nurse : kNurses) {
    int slow = 0;
    int fast = 0;
    for (const auto& region : kRegions) {
      EXPECT_GE(at(nurse, "lubrication poor", region), at(nurse, "lubrication medium", region));
      EXPECT_GE(at(nurse, "lubrication medium", region), at(nurse, "lubrication well", region));
      EXPECT_GE(at(nurse, "neck_flexion small", region), at(nurse, "neck_flexion medium", region));
      EXPECT_GE(at(nurse, "neck_flexion medium", region), at(nurse, "neck_flexion large", region));
      EXPECT_LE(at(nurse, "speed slow", region), at(nurse, "speed medium", region));
      EXPECT_LE(at(nurse, "speed medium", region), at(nurse, "speed fast", region));
      // Lubrication and flexion make a difference in every region.
      EXPECT_GT(at(nurse, "lubrication poor", region), at(nurse, "lubrication well", region));
      EXPECT_GT(at(nurse, "neck_flexion small", region), at(nurse, "neck_flexion large", region));
      slow += at(nurse, "speed slow", region);
      fast += at(nurse, "speed fast", region);
    }
    EXPECT_GT(fast, slow);
  }
}

TEST_P(SimulatedAnswers, DipAfterTheNasalCavityAndPeakInTheOropharynx) {
  for (const auto& nurse : kNurses) {
    for (const auto& condition : kConditions) {
      EXPECT_GE(at(nurse, condition, "nasal_cavity"), at(nurse, condition, "nasopharynx"));
      for (const auto& region : kRegions) EXPECT_GE(at(nurse, condition, "oropharynx"), at(nurse, condition, region));
    }
    EXPECT_GT(sum(nurse, "nasal_cavity"), sum(nurse, "nasopharynx"));
    for (const auto& region : kRegions) {
      if (region != "oropharynx") {
        EXPECT_GT(sum(nurse, "oropharynx"), sum(nurse, region));
      }
    }
  }
}

TEST_P(SimulatedAnswers, PeakOfS2IsTheHighest) {
  for (const auto* other : {"S1", "S3"}) {
    for (const auto& condition : kConditions)
      EXPECT_GE(at("S2", condition, "oropharynx"), at(other, condition, "oropharynx"));
    // Fig. 11 is drawn for a neck at 60 degrees, mostly medium flexion.
    EXPECT_GT(at("S2", "neck_flexion medium", "oropharynx"), at(other, "neck_flexion medium", "oropharynx"));
  }
}

// Table A2's esophagus follows the paper's text except where the neck is flexed: there S4 says very large.
TEST_P(SimulatedAnswers, AreCloseInTheEsophagus) {
  Levels s4;
  const auto rules = questionnaires::s4Rules().value();
  for (const auto& rule : rules) add(s4, "S4", rule.conditions, rule.then);
  for (const auto& condition : kConditions) {
    for (const auto& nurse : kNurses) {
      const int level = at(nurse, condition, "esophagus");
      for (const auto& other : kNurses) EXPECT_LE(std::abs(level - at(other, condition, "esophagus")), 1);
      if (condition != "neck_flexion large") {
        EXPECT_LE(std::abs(level - s4.at({"S4", condition, "esophagus"})), 1) << condition;
      }
    }
  }
}

TEST_P(SimulatedAnswers, AreCompleteAndDifferBetweenNurses) {
  EXPECT_EQ(levels_.size(), 3U * 45U);
  for (std::size_t i = 0; i < kNurses.size(); ++i) {
    const auto& one = kNurses[i];
    const auto& other = kNurses[(i + 1) % kNurses.size()];
    int differences = 0;
    for (const auto& condition : kConditions) {
      for (const auto& region : kRegions) differences += at(one, condition, region) != at(other, condition, region);
    }
    EXPECT_GT(differences, 0) << one << " and " << other;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SimulatedAnswers, ::testing::Range<std::uint64_t>(0, 40));

}  // namespace
}  // namespace tactus::session
