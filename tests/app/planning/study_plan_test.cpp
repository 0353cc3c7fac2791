#include "app/planning/study_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numeric>
#include <string>

#include "app/planning/planned_study.h"
#include "app/planning/simulated_people.h"
#include "core/procedure/procedure.h"
#include "elicitation/model/model_builder.h"
#include "questionnaires/form_file.h"

#include "tests/support/default_procedure.h"

namespace tactus::planning {
namespace {

using elicitation::ForceTermsFrom;

PlanSettings smallPlan() {
  PlanSettings settings;
  settings.studies = 60;
  settings.population = 200;
  settings.points = 24;
  settings.most_nurses = 6;
  settings.questions = {45};
  settings.strokes = {4};
  settings.force_terms = ForceTermsFrom::kThresholds;
  return settings;
}

TEST(StudyPlan, AConstantShiftFallsWithTheRootOfTheNurses) {
  // All nurses say "medium" everywhere; they differ by a constant of their thresholds with a known standard deviation.
  // The averaged force is the middle of "medium", so its error is the mean of n such constants.
  constexpr double kSd = 0.08;
  const NurseSource shifted = [](base::Random& random) {
    TrueNurse nurse;
    const double shift = kSd * random.normal();
    for (const double one : {0.25, 0.45, 0.65, 0.85}) nurse.threshold_n.push_back(one + shift);
    nurse.beyond_from_n = 1.15 + shift;
    nurse.level.assign(45, 2);
    nurse.speed_mm_s = {50, 120, 220};
    return nurse;
  };
  PlanSettings settings = smallPlan();
  settings.least_nurses = 1;
  settings.most_nurses = 9;
  settings.points = 2;
  settings.studies = 400;
  settings.population = 1000;
  settings.noise = {0, 0, 0, 0};
  const auto plan = planStudy(questionsOf(procedure::defaultProcedure()), shifted, settings);
  ASSERT_TRUE(plan) << plan.error().message();
  // A step of 0.1 N adds its own 0.1 / sqrt(12) N at each threshold of a nurse; both thresholds of "medium" lie two
  // steps apart and round alike.
  const double one = std::hypot(kSd, 0.1 / std::sqrt(12.0));
  for (const int nurses : {1, 4, 9}) {
    const auto* const found = plan->find({nurses, 45, 4});
    ASSERT_NE(found, nullptr);
    // 400 studies give a standard deviation to 3.5 %; the truth of 1,000 nurses adds one / 32.
    EXPECT_NEAR(found->simulated_n, one / std::sqrt(nurses), 0.12 * one / std::sqrt(nurses)) << nurses;
    EXPECT_EQ(found->silent, 0);
  }
}

TEST(StudyPlan, TheSamePlanGivesTheSameBits) {
  PlanSettings settings = smallPlan();
  settings.studies = 20;
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto source = sourceOf(defaultFamily(questions));
  const auto two = planStudy(questions, source, settings);
  settings.threads = 1;
  const auto one = planStudy(questions, source, settings);
  settings.seed = 2;
  const auto other = planStudy(questions, source, settings);
  ASSERT_TRUE(one && two && other);
  ASSERT_EQ(one->designs.size(), two->designs.size());
  EXPECT_EQ(one->truth_n, two->truth_n);
  EXPECT_NE(one->truth_n, other->truth_n);
  for (std::size_t i = 0; i < one->designs.size(); ++i) {
    EXPECT_EQ(one->designs[i].error_n, two->designs[i].error_n);
    EXPECT_EQ(one->designs[i].p95_n, two->designs[i].p95_n);
  }
}

TEST(StudyPlan, MoreNursesAreNeverWorse) {
  for (const auto way : {ForceTermsFrom::kVote, ForceTermsFrom::kThresholds}) {
    PlanSettings settings = smallPlan();
    settings.questions = {15, 30, 45};
    settings.force_terms = way;
    const auto questions = questionsOf(procedure::defaultProcedure());
    const auto plan = planStudy(questions, sourceOf(defaultFamily(questions)), settings);
    ASSERT_TRUE(plan);
    for (std::size_t i = 1; i < plan->designs.size(); ++i) {
      const auto& before = plan->designs[i - 1];
      const auto& now = plan->designs[i];
      EXPECT_LE(now.low_n, now.error_n);
      EXPECT_GE(now.high_n, now.error_n);
      if (now.design.questions == before.design.questions) {
        EXPECT_LE(now.error_n, before.error_n);
        EXPECT_GT(now.hours, before.hours);
      }
    }
    EXPECT_LT(plan->find({6, 45, 4})->simulated_n, plan->find({2, 45, 4})->simulated_n);
  }
}

TEST(StudyPlan, TheCheapestDesignIsTheOneWithTheFewestHoursThatMeetsThePrecision) {
  PlanSettings settings = smallPlan();
  settings.questions = {30, 45};
  settings.precision_n = 0.12;
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto plan = planStudy(questions, sourceOf(defaultFamily(questions)), settings);
  ASSERT_TRUE(plan);
  double fewest = 1e9;
  for (const auto& one : plan->designs) {
    if (one.high_n <= settings.precision_n) fewest = std::min(fewest, one.hours);
  }
  ASSERT_EQ(plan->cheapest.has_value(), fewest < 1e9);
  if (plan->cheapest) {
    EXPECT_EQ(plan->designs[*plan->cheapest].hours, fewest);
  }
  // By hand: 4 nurses of 5 + 3 * 6 * .2 + 17 * .2 + 45 / 6 minutes.
  EXPECT_NEAR(hoursOf(questions, {4, 45, 4}, {}), 4 * (5 + 3.6 + 3.4 + 7.5) / 60, 1e-12);
}

TEST(StudyPlan, ItsModelIsThatOfTheBuild) {
  for (const auto& id : procedure::builtInIds()) {
    SCOPED_TRACE(id);
    const auto about = procedure::builtIn(id);
    const auto questions = questionsOf(about);
    const auto& form = about->forms.front();
    const auto family = defaultFamily(questions);
    base::Random random(5);
    std::vector<NurseData> people;
    study::Study study;
    study.name = "three";
    study.procedure = about;
    for (int who = 1; who <= 3; ++who) {
      const std::string code = "N" + std::to_string(who);
      auto data = dataOf(questions, family.draw(random), {}, 4, code, random);
      ASSERT_TRUE(data);
      addTo(study, form, code, *data);
      people.push_back(std::move(*data));
    }
    const auto built = elicitation::buildModel(study, {&form, 1}, {});
    ASSERT_TRUE(built) << built.error().message();
    const auto output = outputOf(questions, people, ForceTermsFrom::kVote);
    ASSERT_TRUE(output);
    std::vector<std::size_t> all(questions.items.size());
    std::iota(all.begin(), all.end(), 0U);
    const auto ours = modelOf(questions, people, all, *output);
    EXPECT_EQ(ours.output, built->model.output);
    ASSERT_EQ(ours.experts.size(), built->model.experts.size());
    for (std::size_t e = 0; e < ours.experts.size(); ++e)
      EXPECT_EQ(ours.experts[e].rules, built->model.experts[e].rules);
    for (std::size_t i = 0; i < ours.inputs.size(); ++i) {
      EXPECT_EQ(ours.inputs[i].terms, built->model.inputs[i].terms);
    }
  }
}

TEST(StudyPlan, APlanOfAnyProcedure) {
  for (const auto& id : procedure::builtInIds()) {
    SCOPED_TRACE(id);
    const auto questions = questionsOf(procedure::builtIn(id));
    PlanSettings settings = smallPlan();
    settings.studies = 16;
    settings.population = 60;
    settings.points = 16;
    settings.questions.clear();
    auto planned = planBefore(procedure::builtIn(id), settings);
    ASSERT_TRUE(simulate(planned, {}));
    const int all = static_cast<int>(questions.items.size());
    EXPECT_EQ(planned.settings.questions, (std::vector<int>{all / 3, 2 * all / 3, all}));
    EXPECT_LT(planned.plan.find({6, all, 4})->simulated_n, planned.plan.find({2, all, 4})->simulated_n);
    EXPECT_LT(planned.plan.find({6, all, 4})->refused, 0.5);
  }
  // The 6 questions about the way out lead to no rule.
  const auto catheter = questionsOf(procedure::builtIn("male-urethral-catheter"));
  EXPECT_EQ(catheter.items.size(), 54U);
}

TEST(StudyPlan, CancelAndWrongSettingsAreSaid) {
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto source = sourceOf(defaultFamily(questions));
  const auto canceled = planStudy(questions, source, smallPlan(), [](double) { return false; });
  ASSERT_FALSE(canceled);
  EXPECT_EQ(canceled.error().code, base::ErrorCode::kCancelled);
  PlanSettings wrong = smallPlan();
  wrong.region = "elbow";
  ASSERT_FALSE(planStudy(questions, source, wrong));
  wrong = smallPlan();
  wrong.questions = {46};
  ASSERT_FALSE(planStudy(questions, source, wrong));
}

// Nurses of another kind than the normal distributions of the plan, with the same standard deviations: two camps, a
// uniform spread, and heavy tails.
NurseSource twoCamps(NurseFamily family) {
  return [family = std::move(family)](base::Random& random) {
    NurseFamily camp = family;
    const double side = random.uniform() < 0.5 ? -1 : 1;
    for (double& one : camp.threshold_n) one *= std::exp(side * family.threshold_log);
    for (double& one : camp.level) one -= side * family.level_words;
    camp.beyond_from_n *= std::exp(side * family.threshold_log);
    camp.threshold_log = camp.level_words = 0;
    return camp.draw(random);
  };
}

NurseSource evenlySpread(NurseFamily family) {
  return [family = std::move(family)](base::Random& random) {
    NurseFamily own = family;
    const double felt = std::sqrt(3.0) * random.uniform(-1, 1);
    const double said = std::sqrt(3.0) * random.uniform(-1, 1);
    for (double& one : own.threshold_n) one *= std::exp(felt * family.threshold_log);
    for (double& one : own.level) one += said * family.level_words;
    own.beyond_from_n *= std::exp(felt * family.threshold_log);
    own.threshold_log = own.level_words = 0;
    return own.draw(random);
  };
}

NurseSource heavyTails(NurseFamily family) {
  return [family = std::move(family)](base::Random& random) {
    NurseFamily own = family;
    // One in five has twice as large deviations, the others smaller ones: variance 1.
    const double scale = random.uniform() < 0.2 ? 1.8 : std::sqrt((1 - 0.2 * 1.8 * 1.8) / 0.8);
    own.threshold_log *= scale;
    own.level_words *= scale;
    own.level_region_words *= scale;
    own.level_own_words *= scale;
    return own.draw(random);
  };
}

TEST(StudyPlan, ThePredictionHoldsForOtherFamilies) {
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto family = defaultFamily(questions);
  PlanSettings settings = smallPlan();
  const char* const more = std::getenv("TACTUS_PLAN_STUDIES");
  settings.studies = more == nullptr ? 200 : std::stoul(more);
  settings.population = 400;
  settings.least_nurses = 4;
  const auto predicted = planStudy(questions, sourceOf(family), settings);
  ASSERT_TRUE(predicted);
  settings.seed = 77;
  for (const auto& source : {twoCamps(family), evenlySpread(family), heavyTails(family)}) {
    const auto realized = planStudy(questions, source, settings);
    ASSERT_TRUE(realized);
    for (const int nurses : {4, 6}) {
      const double ratio = predicted->find({nurses, 45, 4})->error_n / realized->find({nurses, 45, 4})->error_n;
      EXPECT_GT(ratio, 0.8) << nurses;
      EXPECT_LT(ratio, 1.2) << nurses;
    }
  }
}

TEST(StudyFamily, TheSpreadOfAStudyPredictsItsError) {
  // A study of many nurses of another family, through the build; the plan from its data against fresh studies.
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto form = support::ngtForceForm();
  auto truth = defaultFamily(questions);
  truth.threshold_log *= 0.7;
  truth.level_words = 0.25;
  truth.level_own_words = 0.7;
  const auto source = evenlySpread(truth);
  base::Random random(11);
  study::Study study;
  study.name = "pilot";
  for (int who = 1; who <= 40; ++who) {
    const std::string code = "N" + std::to_string(who);
    const auto data = dataOf(questions, source(random), {}, 4, code, random);
    ASSERT_TRUE(data);
    addTo(study, form, code, *data);
  }
  elicitation::BuildSettings build;
  build.force_terms = ForceTermsFrom::kThresholds;
  const auto built = elicitation::buildModel(study, {&form, 1}, build);
  ASSERT_TRUE(built) << built.error().message();
  const auto found = familyOf(study, *built, build);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_FALSE(found->notes.empty());
  PlanSettings settings = smallPlan();
  settings.studies = 150;
  settings.population = 400;
  settings.least_nurses = 4;
  const auto predicted = planStudy(found->questions, sourceOf(found->family), settings);
  const auto realized = planStudy(questions, source, settings);
  ASSERT_TRUE(predicted && realized);
  for (const int nurses : {4, 6}) {
    const double ratio = predicted->find({nurses, 45, 4})->error_n / realized->find({nurses, 45, 4})->error_n;
    EXPECT_GT(ratio, 0.8) << nurses;
    EXPECT_LT(ratio, 1.2) << nurses;
  }
  EXPECT_FALSE(familyOf({}, {}, build));
}

}  // namespace
}  // namespace tactus::planning
