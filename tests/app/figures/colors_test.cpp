#include "app/figures/colors.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/procedure/procedure.h"

namespace tactus::figures {
namespace {

constexpr Rgb kLightCard = {0xFF, 0xFF, 0xFF};
constexpr Rgb kDarkCard = {0x1E, 0x24, 0x2B};
constexpr Rgb kInk = {0x1F, 0x29, 0x33};

fuzzy::Variable depth(const std::vector<std::string>& ids) {
  fuzzy::Variable out{"depth", "Depth", "mm", 0, 600, {}};
  double at = 0;
  for (const std::string& id : ids) {
    out.terms.push_back({id, id, fuzzy::Shape::kTrapezoid, {at, at, at + 10, at + 10}});
    at += 10;
  }
  return out;
}

// WCAG's own examples.
TEST(Colors, ContrastIsThatOfTheStandard) {
  EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21, 1e-12);
  EXPECT_NEAR(contrast({0x76, 0x76, 0x76}, {255, 255, 255}), 4.54, 0.005);
  EXPECT_NEAR(contrast({255, 0, 0}, {255, 255, 255}), 4.00, 0.005);
}

TEST(Colors, ExpertsRegionsAndGraysStandOutOnBothCards) {
  const fuzzy::Variable regions = depth({"nasal_cavity", "nasopharynx", "oropharynx", "oropharynx_2", "oropharynx_3",
                                         "laryngopharynx", "esophagus", "stomach"});
  const fuzzy::Variable speed{"speed", "Speed", "mm/s", 0, 400, regions.terms};
  std::vector<Rgb> all;
  for (std::size_t i = 0; i < regions.terms.size(); ++i) {
    all.push_back(termColor(regions, regions.terms, i));
    all.push_back(termColor(speed, speed.terms, i));
  }
  for (std::size_t i = 0; i < 6; ++i) all.push_back(expertColor(i));
  for (const Rgb& color : all) {
    EXPECT_GE(contrast(color, kLightCard), 3) << hex(color);
    EXPECT_GE(contrast(color, kDarkCard), 3) << hex(color);
  }
}

TEST(Colors, ARegionKeepsItsColorInEveryList) {
  const fuzzy::Variable six =
      depth({"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus", "stomach"});
  const fuzzy::Variable few = depth({"oropharynx", "stomach"});
  EXPECT_EQ(termColor(few, few.terms, 0), termColor(six, six.terms, 2));
  EXPECT_EQ(termColor(few, few.terms, 1), termColor(six, six.terms, 5));
  const fuzzy::Variable other = depth({"near", "far"});
  EXPECT_NE(termColor(other, other.terms, 0), termColor(other, other.terms, 1));
}

TEST(Colors, TheRegionsOfOneProcedureDiffer) {
  for (const std::string& id : procedure::builtInIds()) {
    const auto& terms = procedure::builtIn(id)->wayInput().terms;
    for (std::size_t i = 1; i < terms.size(); ++i)
      EXPECT_NE(regionColor(terms, i - 1), regionColor(terms, i)) << id << ' ' << terms[i].id;
  }
}

TEST(Colors, PartsOfASplitAreTintsOfTheWhole) {
  const fuzzy::Variable split = depth({"oropharynx", "oropharynx_2", "oropharynx_3"});
  const Rgb whole = termColor(split, split.terms, 0);
  const Rgb second = termColor(split, split.terms, 1);
  EXPECT_EQ(second, mixed(whole, {255, 255, 255}, 0.09));
  EXPECT_EQ(termColor(split, split.terms, 2), mixed(whole, {255, 255, 255}, 0.18));
  // A longer name that only begins alike is another region.
  const fuzzy::Variable alike = depth({"oropharynx", "oropharynxes"});
  EXPECT_NE(termColor(alike, alike.terms, 1), mixed(whole, {255, 255, 255}, 0.09));
}

TEST(Colors, OnlyTheForceHasTheRamp) {
  const fuzzy::Variable regions = depth({"nasal_cavity", "nasopharynx", "oropharynx"});
  const fuzzy::Variable force{"force", "Force", "N", 0, 1, regions.terms};
  const fuzzy::Variable speed{"speed", "Speed", "mm/s", 0, 400, regions.terms};
  EXPECT_EQ(hex(termColor(force, force.terms, 0)), "#2C3E8C");
  EXPECT_EQ(hex(termColor(force, force.terms, 2)), "#E9A820");
  for (std::size_t i = 0; i < 3; ++i) {
    const Rgb gray = termColor(speed, speed.terms, i);
    EXPECT_LE(gray.blue - gray.red, 0x20) << hex(gray);
  }
}

TEST(Colors, AnExpertHasOneColorAloneAndInTheAverage) {
  const auto numbers = [](const std::vector<std::string>& ids) {
    std::vector<fuzzy::Expert> experts;
    for (const std::string& id : ids) {
      experts.emplace_back();
      experts.back().id = id;
    }
    return expertNumbers(experts);
  };
  using Numbers = std::vector<std::size_t>;
  EXPECT_EQ(numbers({"E1", "E2", "E3", "S4"}), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(numbers({"S4"}), Numbers{3});
  EXPECT_EQ(numbers({"nurse-012"}), Numbers{11});
  EXPECT_EQ(numbers({"E4", "S4"}), (Numbers{0, 1})) << "two with the same number";
  EXPECT_EQ(numbers({"amber-fox", "S4"}), (Numbers{0, 1})) << "no number";
  EXPECT_EQ(numbers({"P0", "P99999"}), (Numbers{0, 1})) << "no place in a list of people";
  EXPECT_EQ(numbers({}), Numbers{});
}

TEST(Colors, ReadableGoesOnlyAsFarAsNeeded) {
  const Rgb amber = forceRamp(1);
  EXPECT_LT(contrast(amber, kLightCard), 3);
  const Rgb line = readable(amber, kLightCard, kInk, 3);
  EXPECT_GE(contrast(line, kLightCard), 3);
  EXPECT_LT(contrast(line, kLightCard), 3.6);
  const Rgb blue = forceRamp(0);
  EXPECT_EQ(readable(blue, kLightCard, kInk, 3), blue);
  EXPECT_GE(contrast(readable(blue, kDarkCard, {0xE4, 0xE9, 0xEE}, 3), kDarkCard), 3);
}

}  // namespace
}  // namespace tactus::figures
