#include <cmath>
#include <gtest/gtest.h>

#include "core/fuzzy/membership.h"
#include "core/procedure/procedure.h"

#include "tests/support/default_procedure.h"

namespace tactus::procedure {
namespace {

double sumOfMemberships(const std::vector<fuzzy::Term>& terms, double x) {
  double sum = 0;
  for (const auto& term : terms) sum += fuzzy::MembershipFunction::of(term)(x);
  return sum;
}

TEST(NasogastricTube, InputsHaveTheirUnitsAndUniverses) {
  const auto inputs = support::ngtInputs();
  ASSERT_EQ(inputs.size(), 4U);
  const char* ids[] = {"lubrication", "neck_flexion", "depth", "speed"};
  const char* units[] = {"1", "deg", "mm", "mm/s"};
  const double ends[] = {1, 90, 600, 400};
  const std::size_t terms[] = {3, 3, 6, 3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(inputs[i].id, ids[i]);
    EXPECT_EQ(inputs[i].unit, units[i]);
    EXPECT_EQ(inputs[i].min, 0);
    EXPECT_EQ(inputs[i].max, ends[i]);
    EXPECT_EQ(inputs[i].terms.size(), terms[i]);
    EXPECT_EQ(inputs[i].role, fuzzy::Role::kUnsaid) << "the id says it, so model files stay as they were";
    // Every default input is a partition: its terms sum to 1 everywhere.
    for (int step = 0; step <= 200; ++step) {
      EXPECT_NEAR(sumOfMemberships(inputs[i].terms, ends[i] * step / 200), 1, 1e-13);
    }
  }
  EXPECT_EQ(inputs[3].terms[1].points, (std::vector<double>{64, 100, 120, 163}));
  EXPECT_EQ(support::ngtOutput().unit, "N");
  EXPECT_EQ(support::ngtOutput().max, 1.1);
  EXPECT_EQ(support::ngtOutput().terms[3].points, (std::vector<double>{0.6, 0.7, 0.7, 0.8}));
  EXPECT_EQ(support::defaultProcedure().way(), 2U);
  EXPECT_EQ(support::defaultProcedure().rate(), 3U);
}

TEST(NasogastricTube, EverySetOfRegionsCoversTheDepth) {
  const auto& sets = support::defaultProcedure().way_terms;
  ASSERT_EQ(sets.size(), 3U);
  for (const auto& set : sets) {
    for (int depth_mm = 0; depth_mm <= 600; ++depth_mm) EXPECT_NEAR(sumOfMemberships(set.terms, depth_mm), 1, 1e-13);
  }
  EXPECT_EQ(support::findDepthTerms("six_regions")->terms, support::ngtInputs()[2].terms);
  const auto a1 = support::findDepthTerms("form_a1")->terms;
  EXPECT_EQ(a1.back().points, (std::vector<double>{185, 215, 600, 600}));
  EXPECT_EQ(fuzzy::findTerm(a1, "stomach"), nullptr);
  const auto a2 = support::findDepthTerms("form_a2")->terms;
  EXPECT_EQ(fuzzy::findTerm(a2, "oropharynx"), nullptr);
  EXPECT_EQ(fuzzy::findTerm(a2, "laryngopharynx")->points, (std::vector<double>{105, 125, 185, 215}));
  EXPECT_FALSE(support::findDepthTerms("seven_regions"));
}

struct Landmark {
  double depth_mm, x, y;
};

double lengthTo(const Picture& picture, double depth_mm) {
  double length = 0;
  Point before = picture.way.front();
  for (double mm = 0.25; mm <= depth_mm; mm += 0.25) {
    const Point at = placeAt(picture, mm);
    length += std::hypot(at.x - before.x, at.y - before.y);
    before = at;
  }
  return length;
}

// Measured along the tube of the drawing by another program, given to 0.1 mm; coordinates are mm.
TEST(NasogastricTube, TheDepthIsTheLengthOfTheDrawnWay) {
  const Picture& upright = support::defaultProcedure().pictures.front();
  ASSERT_EQ(upright.pose, (study::ItemCondition{"neck_flexion", "small"}));
  for (const Landmark& mark :
       {Landmark{0, 0, 0}, Landmark{20, 16.3, -7.8}, Landmark{64, 60, -2.3}, Landmark{70, 65.9, -1.5},
        Landmark{94, 85.6, 10}, Landmark{115, 90.1, 30.4}, Landmark{120, 90.1, 35.4}, Landmark{150, 90.5, 65.4},
        Landmark{175, 94.6, 90}, Landmark{200, 102, 113.9}, Landmark{290, 127.5, 200}, Landmark{365, 132.4, 274.6},
        Landmark{415, 116, 321.5}, Landmark{440, 105.4, 343.9}, Landmark{470, 96.7, 372.5}}) {
    const Point at = placeAt(upright, mark.depth_mm);
    EXPECT_LT(std::hypot(at.x - mark.x, at.y - mark.y), 0.25) << mark.depth_mm;
    EXPECT_NEAR(lengthTo(upright, mark.depth_mm), mark.depth_mm, 0.2) << mark.depth_mm;
  }
  EXPECT_NEAR(upright.way_mm.back(), 514, 0.5);
  EXPECT_EQ(upright.approach.front().x, -70);  // the hand
}

// Soft palate, tip of the epiglottis, cardia: drawn lengths with the neck flexed by 33 and 66 degrees, to 1 mm.
TEST(NasogastricTube, ALandmarkKeepsItsDepthAndTheDrawnWayToItGetsShorter) {
  const auto& pictures = support::defaultProcedure().pictures;
  ASSERT_EQ(pictures.size(), 3U);
  const struct { double depth_mm, half_mm, chest_mm; } table[] = {{118, 117, 115}, {141, 138, 135}, {436, 427, 419}};
  for (const auto& mark : table) {
    EXPECT_NEAR(lengthTo(pictures[1], mark.depth_mm), mark.half_mm, 1.5) << mark.depth_mm;
    EXPECT_NEAR(lengthTo(pictures[2], mark.depth_mm), mark.chest_mm, 1.5) << mark.depth_mm;
  }
}

// Settings of the paper, Sec. 3.4 and the captions of Fig. 9 to 11. It does not give the values of what varies in
// Fig. 10.
TEST(NasogastricTube, FiguresOfThePaper) {
  using Setting = std::map<std::string, double>;
  const struct {
    const char* name;
    Setting at;
    const char* varied;
  } wanted[] = {{"Fig. 9", {{"lubrication", 1}, {"neck_flexion", 45}}, ""},
                {"Fig. 10a", {{"neck_flexion", 90}, {"speed", 30}}, "lubrication"},
                {"Fig. 10b", {{"lubrication", 1}, {"speed", 30}}, "neck_flexion"},
                {"Fig. 10c", {{"lubrication", 1}, {"neck_flexion", 90}}, "speed"},
                {"Fig. 11", {{"lubrication", 1}, {"neck_flexion", 60}, {"speed", 50}}, ""}};
  const auto& figures = support::defaultProcedure().figures;
  ASSERT_EQ(figures.size(), std::size(wanted));
  for (std::size_t i = 0; i < figures.size(); ++i) {
    EXPECT_EQ(textIn(figures[i].name, "en"), wanted[i].name);
    EXPECT_EQ(figures[i].at, wanted[i].at) << wanted[i].name;
    EXPECT_EQ(figures[i].varied, wanted[i].varied) << wanted[i].name;
  }
  EXPECT_EQ(figures[0].map, (std::vector<std::string>{"depth", "speed"}));
}

// Fig. 10 of the paper, as its text reads: (a) faster more, (b) the neck not flexed more, (c) less lubrication more.
TEST(NasogastricTube, TheDirectionsThatTheStudyDeclares) {
  const Direction wanted[] = {Direction::kFalls, Direction::kFalls, Direction::kNone, Direction::kRises};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(support::defaultProcedure().input_notes[i].direction, wanted[i]) << i;
}

}  // namespace
}  // namespace tactus::procedure
