#include <algorithm>
#include <gtest/gtest.h>

#include "elicitation/depth/depth_measurement.h"

#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

fuzzy::Variable depthWithAllRegions() {
  const auto inputs = support::ngtInputs();
  return *std::find_if(inputs.begin(), inputs.end(), [](const auto& one) { return one.id == "depth"; });
}

const std::vector<double>& pointsOf(const std::vector<fuzzy::Term>& terms, const std::string& id) {
  return std::find_if(terms.begin(), terms.end(), [&](const auto& one) { return one.id == id; })->points;
}

TEST(MeasuredTerms, TheTemplatesBoundariesGiveEachSetOfTheTemplate) {
  const auto depth = depthWithAllRegions();
  for (const auto& set : support::defaultProcedure().way_terms) {
    const auto terms = measuredTerms(emptyMeasurement(depth), depth, set.terms);
    ASSERT_TRUE(terms) << terms.error().message();
    EXPECT_EQ(*terms, set.terms) << set.id;
  }
}

// A1 asks of no stomach: the esophagus reaches the end. A2 asks of no oropharynx: the laryngopharynx begins behind the
// nasopharynx (facts/domain.md 0.5.1, 0.6).
TEST(MeasuredTerms, AFormKeepsItsRegionsAtTheMeasuredDepths) {
  const auto depth = depthWithAllRegions();
  auto measured = emptyMeasurement(depth);
  measured.boundaries = {{80, 5}, {120, 5}, {160, 10}, {210, 10}, {420, 30}};
  const auto a1 = measuredTerms(measured, depth, support::findDepthTerms("form_a1")->terms).value();
  EXPECT_EQ(pointsOf(a1, "esophagus"), (std::vector<double>{200, 220, 600, 600}));
  EXPECT_EQ(pointsOf(a1, "oropharynx"), (std::vector<double>{115, 125, 150, 170}));
  const auto a2 = measuredTerms(measured, depth, support::findDepthTerms("form_a2")->terms).value();
  EXPECT_EQ(pointsOf(a2, "laryngopharynx"), (std::vector<double>{115, 125, 200, 220}));
  EXPECT_EQ(pointsOf(a2, "stomach"), (std::vector<double>{390, 450, 600, 600}));
  measured.scale = 0.5;
  EXPECT_EQ(pointsOf(measuredTerms(measured, depth, support::findDepthTerms("form_a2")->terms).value(), "nasal_cavity"),
            (std::vector<double>{0, 0, 37.5, 42.5}));
}

TEST(MeasuredTerms, WhatCannotBeIsRefused) {
  const auto depth = depthWithAllRegions();
  auto measured = emptyMeasurement(depth);
  std::swap(measured.boundaries[2], measured.boundaries[3]);
  const auto refused = measuredTerms(measured, depth, support::findDepthTerms("form_a2")->terms);
  ASSERT_FALSE(refused) << "also where the form does not ask of the region";
  EXPECT_NE(refused.error().message().find("laryngopharynx"), std::string::npos) << refused.error().message();
}

TEST(MeasuredTerms, TheSentenceSaysWhereTheyComeFrom) {
  auto measured = emptyMeasurement(depthWithAllRegions());
  EXPECT_EQ(measuredSentence(measured), "The depths of the regions are typed, without an image, anatomical scale 1.");
  measured.image = "head.png";
  EXPECT_EQ(measuredSentence(measured),
            "The depths of the regions are measured on the image 'head.png' (0.33 mm per pixel), anatomical scale 1.");
}

}  // namespace
}  // namespace tactus::elicitation
