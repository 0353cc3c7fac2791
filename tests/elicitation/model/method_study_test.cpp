#include "elicitation/model/method_study.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <tuple>

#include "app/session/study_source.h"

#include "tests/elicitation/four_people.h"
#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"

namespace tactus::elicitation {
namespace {

/// A says Small and B Medium wherever the tube is well, medium or poorly lubricated: .35 and .55 N by symmetric terms,
/// whatever clips or scales them.
study::Study smallAndMedium(double years_a, double years_b) {
  study::Study study;
  for (const auto& [code, years, then] : {std::tuple("A", years_a, "small"), std::tuple("B", years_b, "medium")}) {
    study::Participant one;
    one.code = code;
    one.years_experience = years;
    study.participants.push_back(one);
    for (const char* term : {"poor", "medium", "well"}) {
      study::GivenRule rule;
      rule.participant = code;
      rule.conditions = {{"lubrication", term}};
      rule.then = then;
      study.rules.push_back(rule);
    }
  }
  return study;
}

MethodVariant named(const std::string& factor, const std::string& value, const std::string& unavailable = {}) {
  MethodVariant out;
  out.factor = factor;
  out.value = value;
  out.unavailable = unavailable;
  return out;
}

const MethodVariant& variantOf(const MethodStudy& study, std::string_view factor, std::string_view value) {
  return *std::find_if(study.variants.begin(), study.variants.end(),
                       [&](const auto& one) { return one.factor == factor && one.value == value; });
}

const MethodFactor& factorOf(const MethodStudy& study, std::string_view factor) {
  return *std::find_if(study.factors.begin(), study.factors.end(),
                       [&](const auto& one) { return one.factor == factor; });
}

TEST(MethodStudy, ByHand) {
  // Equal weights give .45 N, nine years to one .37 N: .08 N of a just-noticeable difference of .0672 N.
  const auto study = smallAndMedium(9, 1);
  const auto built = buildModel(study, {}, {});
  ASSERT_TRUE(built) << built.error().message();
  std::vector<double> progress;
  MethodStudyRun run;
  run.progress = [&](double share) { progress.push_back(share); };
  const auto compared = methodStudy(study, {}, {}, *built, run);
  ASSERT_TRUE(compared) << compared.error().message();
  EXPECT_EQ(compared->points, 4096U);
  const auto& years = variantOf(*compared, "weights", "years");
  EXPECT_NEAR(years.rms_n, 0.08, 1e-12);  // rounding of the centroids
  EXPECT_NEAR(years.largest_n, 0.08, 1e-12);
  EXPECT_NEAR(years.rms_noticeable, 0.08 / std::hypot(0.04, 0.12 * 0.45), 1e-10);
  EXPECT_EQ(years.noticeable_share, 1);
  EXPECT_EQ(years.only_one_share, 0);
  const auto& category = variantOf(*compared, "weights", "category");
  EXPECT_NE(category.unavailable, "") << "the study has no categories";
  EXPECT_TRUE(factorOf(*compared, "weights").matters);
  EXPECT_EQ(factorOf(*compared, "weights").unchanged, "equal");
  // Symmetric sets have their centroid where it is.
  EXPECT_LT(variantOf(*compared, "implication", "scale").largest_n, 1e-12);
  EXPECT_LT(variantOf(*compared, "shapes", "triangle").largest_n, 1e-12);
  EXPECT_FALSE(factorOf(*compared, "implication").matters);
  // No strokes, no judgements: nothing to compare there.
  for (const auto& one : compared->factors) EXPECT_NE(one.factor, "alpha");
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1);
}

TEST(MethodStudy, WhatIsKnownIsNotComparedAgain) {
  const auto study = smallAndMedium(3, 1);
  const auto built = buildModel(study, {}, {});
  ASSERT_TRUE(built) << built.error().message();
  MethodStudyRun some;
  some.wanted = [](std::string_view factor) { return factor == "weights"; };
  auto known = methodStudy(study, {}, {}, *built, some).value();
  ASSERT_EQ(known.factors.size(), 1U);
  for (auto& one : known.variants) one.largest_n += 100;  // so that it can be told from what is compared
  MethodStudyRun others;
  others.known = &known;
  const auto all = methodStudy(study, {}, {}, *built, others).value();
  const auto alone = methodStudy(study, {}, {}, *built).value();
  ASSERT_EQ(all.variants.size(), alone.variants.size());
  for (std::size_t v = 0; v < all.variants.size(); ++v) {
    EXPECT_EQ(all.variants[v].factor, alone.variants[v].factor);
    EXPECT_EQ(all.variants[v].value, alone.variants[v].value);
    const double more = all.variants[v].factor == "weights" ? 100 : 0;
    EXPECT_EQ(all.variants[v].largest_n, alone.variants[v].largest_n + more) << all.variants[v].value;
  }
}

TEST(MethodStudy, ASmallChangeDoesNotMatter) {
  // Two years to one: .45 to .41667 N, half a just-noticeable difference.
  const auto study = smallAndMedium(2, 1);
  const auto built = buildModel(study, {}, {}).value();
  const auto compared = methodStudy(study, {}, {}, built).value();
  EXPECT_NEAR(variantOf(compared, "weights", "years").rms_n, 0.2 / 6, 1e-12);
  EXPECT_EQ(variantOf(compared, "weights", "years").noticeable_share, 0);
  EXPECT_FALSE(factorOf(compared, "weights").matters);
}

TEST(MethodStudy, WhatMattersComesBeforeALargerEffectThatIsFeltSeldom) {
  MethodStudy study;
  for (const double rms_noticeable : {0.57, 0.53, 0.9}) {
    study.variants.push_back(
        {.factor = "f", .value = "v", .unavailable = {}, .rms_noticeable = rms_noticeable, .at = {}});
  }
  study.factors = {{"seldom", "a", 0, false}, {"felt", "a", 1, true}, {"none", "a", {}, false}, {"most", "a", 2, true}};
  EXPECT_EQ(factorsByEffect(study), (std::vector<std::size_t>{3, 1, 0, 2}));
}

TEST(MethodStudy, InWordsTheLargestEffectComesFirst) {
  const auto study = smallAndMedium(9, 1);
  const auto built = buildModel(study, {}, {}).value();
  const auto compared = methodStudy(study, {}, {}, built).value();
  const auto order = factorsByEffect(compared);
  ASSERT_EQ(order.size(), compared.factors.size());
  EXPECT_EQ(compared.factors[order.front()].factor, "weights");
  // .08 N of a just-noticeable difference of .0672 N, everywhere.
  EXPECT_EQ(factorSentence(compared, factorOf(compared, "weights")),
            "Matters here: \"years\" instead of \"equal\" is felt at 100.0 % of the input space (0.080 N rms, 1.19 "
            "just-noticeable differences; at most 0.080 N).");
  EXPECT_EQ(factorVerdict(compared, factorOf(compared, "weights")), "Yes: \"years\" is felt at 100.0 %.");
  MethodStudy none;
  none.variants = {named("weights", "years", "no years of A")};
  none.factors = {{.factor = "weights", .unchanged = "equal", .worst = std::nullopt}};
  EXPECT_EQ(factorSentence(none, none.factors[0]), "Cannot be compared here: no years of A.");
  EXPECT_EQ(factorVerdict(none, none.factors[0]), "Cannot be compared: no years of A.");
  none.variants = {named("m", "3")};
  none.factors = {{.factor = "m", .unchanged = "2", .worst = 0}};
  EXPECT_EQ(factorSentence(none, none.factors[0]), "Does not matter here: no other choice moves the force.");
  EXPECT_EQ(factorVerdict(none, none.factors[0]), "No: no other choice moves the force.");
  EXPECT_EQ(factorTitle("implication"), "Implication");
  // .4167 N instead of .45 N, half a just-noticeable difference: felt nowhere.
  const auto near = smallAndMedium(2, 1);
  const auto near_compared = methodStudy(near, {}, {}, buildModel(near, {}, {}).value()).value();
  EXPECT_EQ(
      factorSentence(near_compared, factorOf(near_compared, "weights")),
      "Does not matter here: even \"years\" instead of \"equal\" is felt at none of the points (0.033 N rms, 0.50 "
      "just-noticeable differences; at most 0.033 N).");
  EXPECT_EQ(factorVerdict(near_compared, factorOf(near_compared, "weights")), "No: even \"years\" is felt nowhere.");
}

TEST(MethodStudy, GivesTheModelOfAVariant) {
  const auto study = smallAndMedium(9, 1);
  const auto built = buildModel(study, {}, {}).value();
  const auto compared = methodStudy(study, {}, {}, built).value();
  const auto years = methodModel(study, {}, {}, built, variantOf(compared, "weights", "years"));
  ASSERT_TRUE(years) << years.error().message();
  EXPECT_EQ(years->experts[0].weight, 9);
  EXPECT_EQ(methodModel(study, {}, {}, built, variantOf(compared, "implication", "scale"))->implication,
            fuzzy::Implication::kScale);
  EXPECT_FALSE(methodModel(study, {}, {}, built, variantOf(compared, "weights", "category")));
  EXPECT_FALSE(methodModel(study, {}, {}, built, named("weather", "fine")));
}

TEST(MethodStudy, ComparesMeasuredDepthsWhereThereAreSome) {
  study::Study study = smallAndMedium(1, 1);
  study.rules.push_back({.participant = "A", .form = {}, .conditions = {{"depth", "stomach"}}, .then = "very_large"});
  BuildSettings settings;
  const auto inputs = support::ngtInputs();
  settings.measured_depths = emptyMeasurement(inputs[2]);
  settings.measured_depths->boundaries.back() = {300, 20};
  const auto built = buildModel(study, {}, settings).value();
  const auto compared = methodStudy(study, {}, settings, built).value();
  EXPECT_EQ(factorOf(compared, "depths").unchanged, "template");
  EXPECT_GT(variantOf(compared, "depths", "measured").largest_n, 0.1);
  EXPECT_GT(variantOf(compared, "depths", "measured").at[2], 280) << "only between 280 and 460 mm";
  EXPECT_LT(variantOf(compared, "depths", "measured").at[2], 460);
  settings.depths = DepthsFrom::kMeasured;
  const auto measured = buildModel(study, {}, settings).value();
  EXPECT_EQ(factorOf(methodStudy(study, {}, settings, measured).value(), "depths").unchanged, "measured");
}

// At (1, 60, 200, 50) the vote gives .534861 N, mean thresholds .49263 N, by another program.
TEST(MethodStudy, TheLargestDifferenceIsAtLeastThatOfAKnownPoint) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {}).value();
  const auto compared = methodStudy(study, {}, {}, built).value();
  EXPECT_GE(variantOf(compared, "force_terms", "thresholds").largest_n, .534861 - .49263 - 1e-5);
  EXPECT_EQ(factorOf(compared, "force_terms").unchanged, "vote");
}

TEST(MethodStudy, OfAWholeStudyTriesEveryFactorAndEndsOnRequest) {
  auto study = support::tableStudy(1, {.nurses = 2, .rows_per_s = 30});
  const auto forms = session::knownForms(support::defaultProcedure());
  const auto built = buildModel(study, forms, {}).value();
  const auto compared = methodStudy(study, forms, {}, built);
  ASSERT_TRUE(compared);
  std::vector<std::string> factors;
  for (const auto& one : compared->factors) factors.push_back(one.factor);
  EXPECT_EQ(factors, (std::vector<std::string>{"shapes", "implication", "alpha", "m", "trim", "centres", "averaging",
                                               "terms", "force_terms", "weights"}));
  EXPECT_GT(variantOf(*compared, "alpha", "0.8").largest_n, 0);

  std::stop_source source;
  source.request_stop();
  const auto stopped = methodStudy(study, forms, {}, built, {source.get_token(), {}});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::ErrorCode::kCancelled);
}

TEST(MethodStudy, AnotherAlphaTakesTheClustersThatThereAre) {
  const auto study = support::tableStudy(1, {.nurses = 2, .rows_per_s = 30});
  const auto forms = session::knownForms(support::defaultProcedure());
  int passes = 0;
  BuildSettings settings;
  settings.speed.fcm.keep_going = [&passes](const FcmProgress&) { return ++passes > 0; };
  const auto built = buildModel(study, forms, settings).value();
  EXPECT_GT(passes, 0);
  passes = 0;
  const auto model = methodModel(study, forms, settings, built, named("alpha", "0.8"));
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(passes, 0);
  // And yet it is the model that these settings build.
  settings.speed.alpha = 0.8;
  const auto whole = buildModel(study, forms, settings).value();
  EXPECT_EQ(model->inputs, whole.model.inputs);
  EXPECT_NE(model->inputs, built.model.inputs);
}

TEST(ModelBuilder, TheClustersOfAnEarlierModelServeAllButTheirOwnSettings) {
  const auto study = support::tableStudy(1, {.nurses = 2, .rows_per_s = 30});
  const auto forms = session::knownForms(support::defaultProcedure());
  int passes = 0;
  BuildSettings first;
  first.speed.fcm.keep_going = [&passes](const FcmProgress&) { return ++passes > 0; };
  const auto earlier = buildModel(study, forms, first).value();
  BuildSettings now = first;
  now.speed.alpha = 1;
  now.averaging = Averaging::kMedian;
  now.terms = SpeedTermsOf::kOwn;
  EXPECT_TRUE(clusterAlike(first.speed, now.speed));
  passes = 0;
  const auto quick = buildModel(study, forms, now, &earlier.speeds).value();
  EXPECT_EQ(passes, 0);
  const auto whole = buildModel(study, forms, now).value();
  EXPECT_EQ(quick.model, whole.model);
  EXPECT_EQ(quick.notes, whole.notes);
  for (const auto& change : {+[](SpeedTermSettings& s) { s.fcm.m = 2.5; }, +[](SpeedTermSettings& s) { s.trim = 0.1; },
                             +[](SpeedTermSettings& s) { s.centres = SpeedCentres::kLevelMeans; }}) {
    SpeedTermSettings other = first.speed;
    change(other);
    EXPECT_FALSE(clusterAlike(first.speed, other));
  }
}

}  // namespace
}  // namespace tactus::elicitation
