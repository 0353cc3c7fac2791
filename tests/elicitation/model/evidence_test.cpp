// The distance to a reference, and experts' strokes against students', by hand calculation.
#include "elicitation/model/evidence.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/default_procedure.h"
#include "tests/support/ngt_model.h"

namespace tactus::elicitation {
namespace {

// The model's own force, moved by known amounts: mean, root mean square and largest follow by hand.
TEST(Evidence, DistanceToAReference) {
  const auto model = support::s4FiveRegions();
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled);
  SealedCurve curve;
  curve.conditions = {{"lubrication", 1}, {"neck_flexion", 60}, {"speed", 50}};
  const double moved_n[] = {0.1, -0.2, 0.05};
  double jnd_square = 0;
  int place = 0;
  for (const double depth_mm : {70.0, 200.0, 300.0}) {
    const auto own = compiled->evaluate(referenceInputs(support::defaultProcedure(), curve.conditions, depth_mm));
    ASSERT_TRUE(own.fired);
    const double reference_n = own.force_n - moved_n[place];
    curve.points.push_back({depth_mm, reference_n});
    const double jnd_n = std::sqrt(0.04 * 0.04 + 0.12 * 0.12 * reference_n * reference_n);
    jnd_square += std::pow(moved_n[place] / jnd_n, 2);
    ++place;
  }
  const auto error = referenceError(support::defaultProcedure(), model, curve);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->points, 3U);
  // Sums of three numbers near 1 in double precision.
  EXPECT_NEAR(error->mean_n, -0.05 / 3, 1e-12);
  EXPECT_NEAR(error->rms_n, std::sqrt((0.01 + 0.04 + 0.0025) / 3), 1e-12);
  EXPECT_NEAR(error->rms_jnd, std::sqrt(jnd_square / 3), 1e-12);
  EXPECT_NEAR(error->largest_n, -0.2, 1e-12);
  EXPECT_EQ(error->largest_at_mm, 200);
}

void addPerson(study::Study& study, const std::string& code, const std::string& category) {
  study::Participant person;
  person.code = code;
  person.category = category;
  study.participants.push_back(person);
}

/// A stroke forward from 10 mm to `end_mm` at a speed, with `turns` movements back of 2 mm.
void addStroke(study::Study& study, const std::string& who, int number, double end_mm, double speed_mm_s, int turns) {
  double time_s = 0;
  const auto add = [&](double depth_mm, double speed) {
    study.speeds.push_back({who, "slow", number, time_s, depth_mm, speed, {}});
    time_s += 0.1;
  };
  for (double depth_mm = 10; depth_mm <= end_mm; depth_mm += 5) {
    add(depth_mm, speed_mm_s);
    if (turns-- > 0) add(depth_mm - 2, -speed_mm_s);
  }
}

TEST(Evidence, ExpertsAgainstStudents) {
  study::Study study;
  addPerson(study, "E1", "expert");
  addPerson(study, "E2", "Expert");
  addPerson(study, "S1", "student");
  addPerson(study, "S2", "beginner");
  addPerson(study, "X", "intermediate");
  addStroke(study, "E1", 1, 60, 50, 0);
  addStroke(study, "E2", 1, 65, 50, 0);
  addStroke(study, "S1", 1, 40, 50, 3);
  addStroke(study, "S1", 2, 40, 50, 1);
  addStroke(study, "S2", 1, 45, 50, 4);
  addStroke(study, "X", 1, 45, 50, 4);
  const auto found = constructEvidence(study, support::s4FiveRegions());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->experts, 2U);
  EXPECT_EQ(found->students, 2U);
  EXPECT_FALSE(found->simulated);
  EXPECT_EQ(found->reversals.expert_mean, 0);
  EXPECT_EQ(found->reversals.student_mean, 3);  // (3 + 1) / 2 = 2, and 4
  EXPECT_EQ(found->reversals.above, 0);
  // Six divisions of four persons in two pairs; two of them are as far apart, both ways round.
  EXPECT_NEAR(*found->reversals.chance, 2.0 / 6, 1e-12);
  EXPECT_EQ(found->work.above, 1);
  EXPECT_GT(found->work.expert_mean, found->work.student_mean);
}

TEST(Evidence, OneStudentIsTooFew) {
  study::Study study;
  addPerson(study, "E1", "expert");
  addPerson(study, "S1", "student");
  study.participants.back().simulated = true;
  addStroke(study, "E1", 1, 60, 50, 0);
  addStroke(study, "S1", 1, 60, 50, 0);
  const auto found = constructEvidence(study, support::s4FiveRegions());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->students, 1U);
  EXPECT_TRUE(found->simulated);
  EXPECT_FALSE(found->peak.chance.has_value());
}

}  // namespace
}  // namespace tactus::elicitation
