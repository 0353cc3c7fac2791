#include "elicitation/model/model_builder.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/elicitation/model/small_study.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

TEST(ModelBuilder, TheAverageIsThatOfTheExpertsWhoDoNotAbstain) {
  const auto built = buildModel(smallStudy(), forms(), {});
  ASSERT_TRUE(built) << built.error().message();
  const auto& model = built->model;
  ASSERT_EQ(model.experts.size(), 2U);
  EXPECT_EQ(model.experts[0].rules.size(), 3U);
  EXPECT_EQ(model.experts[1].rules.size(), 1U);
  // Well lubricated in the nasal cavity, not fast: A says very small, the centroid of (0, 0, .2, .3):
  // area .2 + .05, moment .02 + .05 (.2 + .1/3); B says small, symmetric about .35.
  const double very_small = (0.02 + 0.05 * (0.2 + 0.1 / 3)) / 0.25;
  const auto both = evaluate(model, {1, 0, 30, 30});
  EXPECT_NEAR(both.force_n, (very_small + 0.35) / 2, 1e-14);
  EXPECT_TRUE(both.fired);
  // Deep and slow: only A has a rule, medium, symmetric about .55.
  EXPECT_NEAR(evaluate(model, {1, 0, 500, 30}).force_n, 0.55, 1e-14);
  EXPECT_FALSE(evaluate(model, {0, 0, 100, 110}).fired);
  EXPECT_TRUE(mentions(built->notes, "no insertion speeds"));
  EXPECT_TRUE(mentions(built->notes, "no force judgements"));
  // form_a1 is what both experts use, so it is the model's own list.
  EXPECT_EQ(model.inputs[2].terms, support::findDepthTerms("form_a1")->terms);
  EXPECT_TRUE(model.experts[0].overrides.empty());
}

TEST(ModelBuilder, WeightsFollowThePolicy) {
  BuildSettings settings;
  settings.weights.policy = WeightPolicy::kYears;
  const auto built = buildModel(smallStudy(), forms(), settings);
  ASSERT_TRUE(built);
  const double very_small = (0.02 + 0.05 * (0.2 + 0.1 / 3)) / 0.25;
  EXPECT_NEAR(evaluate(built->model, {1, 0, 30, 30}).force_n, (3 * very_small + 0.35) / 4, 1e-14);
}

TEST(ModelBuilder, ChecksAreThePointsOfTheModelItself) {
  const auto built = buildModel(smallStudy(), forms(), {});
  ASSERT_TRUE(built);
  ASSERT_GE(built->model.checks.size(), 24U);
  EXPECT_TRUE(std::any_of(built->model.checks.begin(), built->model.checks.end(),
                          [](const fuzzy::Check& check) { return check.fired; }));
  for (const auto& check : built->model.checks) {
    const auto at = evaluate(built->model, check.in);
    EXPECT_EQ(at.force_n, check.force);
    EXPECT_EQ(at.fired, check.fired);
  }
}

TEST(ModelBuilder, SpeedTermsAreAveragedOrOwn) {
  auto study = smallStudy();
  addSpeeds(study, "A", {20, 100, 200});
  addSpeeds(study, "B", {40, 140, 440});
  BuildSettings settings;
  settings.speed.alpha = 1;
  auto built = buildModel(study, forms(), settings);
  ASSERT_TRUE(built) << built.error().message();
  // alpha = 1: the vertices are the centers, averaged 30, 120, 320; B's 440 widens the universe to 500.
  const auto& speed = built->model.inputs[3];
  EXPECT_EQ(speed.max, 500);
  EXPECT_TRUE(mentions(built->notes, "The universe of the speed ends at 500 mm/s instead of 400 mm/s"));
  EXPECT_EQ(speed.terms[0].points, (std::vector<double>{0, 0, 30, 120}));
  EXPECT_EQ(speed.terms[1].points, (std::vector<double>{30, 120, 120, 320}));
  EXPECT_EQ(speed.terms[2].points, (std::vector<double>{120, 320, 500, 500}));
  EXPECT_EQ(built->speeds.size(), 2U);
  EXPECT_EQ(built->speeds[1].clusters->stop, FcmStop::kExact);

  settings.terms = SpeedTermsOf::kOwn;
  built = buildModel(study, forms(), settings);
  ASSERT_TRUE(built);
  ASSERT_EQ(built->model.experts[1].overrides.size(), 1U);
  EXPECT_EQ(built->model.experts[1].overrides[0].variable, "speed");
  EXPECT_EQ(built->model.experts[1].overrides[0].terms[1].points, (std::vector<double>{40, 140, 140, 440}));

  settings.averaging = Averaging::kWeightedMean;
  settings.weights.policy = WeightPolicy::kYears;  // 3 : 1
  built = buildModel(study, forms(), settings);
  ASSERT_TRUE(built);
  EXPECT_EQ(built->model.inputs[3].terms[1].points, (std::vector<double>{25, 110, 110, 260}));
}

TEST(ModelBuilder, ABuildTellsItsShareAndEndsWhereItIsStopped) {
  auto study = smallStudy();
  addSpeeds(study, "A", {20, 100, 200});
  addSpeeds(study, "B", {40, 120, 240});
  std::vector<double> shares;
  const auto whole = buildModel(study, forms(), {}, nullptr, [&shares](double share) {
    shares.push_back(share);
    return true;
  });
  ASSERT_TRUE(whole);
  EXPECT_EQ(shares.front(), 0);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_TRUE(shares.back() > 0.5 && shares.back() <= 1);
  // Before each of the two, after them, before the checks, and several times while experts are left out.
  ASSERT_GE(shares.size(), 6U);
  EXPECT_EQ(whole->model, buildModel(study, forms(), {})->model) << "to be asked changes nothing";

  for (std::size_t last = 1; last <= shares.size(); ++last) {
    std::size_t asked = 0;
    const auto stopped = buildModel(study, forms(), {}, nullptr, [&](double) { return ++asked < last; });
    ASSERT_FALSE(stopped) << last;
    EXPECT_EQ(stopped.error().code, base::ErrorCode::kCancelled);
    EXPECT_EQ(asked, last) << "not asked again";
  }
}

TEST(ModelBuilder, ForceTermsComeFromTheVote) {
  auto study = smallStudy();
  const char* terms[] = {"very_small", "small", "medium", "large", "very_large"};
  for (int step = 1; step <= 5; ++step) {
    for (const char* who : {"A", "B"}) {
      study.judgements.push_back(
          {who, "ascending", step, 0.25 * step, study::ForceJudgement::Kind::kTerm, terms[step - 1]});
    }
  }
  auto built = buildModel(study, forms(), {});
  ASSERT_TRUE(built) << built.error().message();
  EXPECT_EQ(built->votes.size(), 5U);
  EXPECT_EQ(built->model.output.max, 1.25);
  EXPECT_TRUE(mentions(built->notes, "The universe of the force ends at 1.25 N instead of 1.1 N"));
  EXPECT_EQ(built->model.output.terms[1].points, (std::vector<double>{0.25, 0.5, 0.5, 0.75}));

  // No judgement is medium, and nothing lies between small and large but the gap: a triangle, which A's rule may use.
  study.judgements.erase(study.judgements.begin() + 4, study.judgements.begin() + 6);
  built = buildModel(study, forms(), {});
  ASSERT_TRUE(built);
  EXPECT_EQ(built->force_terms->interpolated, std::vector<std::string>{"medium"});
  // Nothing above small is judged: the terms above lie a step apart from there, and A's third rule has its medium.
  study.judgements.resize(4);
  built = buildModel(study, forms(), {});
  ASSERT_TRUE(built) << built.error().message();
  EXPECT_EQ(built->model.output.terms[2].points, (std::vector<double>{0.5, 0.75, 1}));
  EXPECT_EQ(built->model.output.max, 1.25);
  EXPECT_TRUE(mentions(built->notes, "its term is placed one step above, at 0.75 N"));
  BuildSettings settings;
  settings.series = "random";
  EXPECT_NE(errorOf(study, settings).find("no row of series 'random'"), std::string::npos);
}

/// What participant `who` says of 0.1, 0.2 ... N: s for small, l for large, V for very large.
void judge(study::Study& study, const char* who, const std::string& answers) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const char* term = answers[i] == 's' ? "small" : answers[i] == 'l' ? "large" : "very_large";
    study.judgements.push_back({who, "ascending", static_cast<int>(i) + 1, 0.1 * static_cast<double>(i + 1),
                                study::ForceJudgement::Kind::kTerm, term});
  }
}

TEST(ModelBuilder, OneWhoGoesOnMovesNobodysForce) {
  auto study = smallStudy();
  for (const char* code : {"C", "D"}) study.participants.push_back(participant(code));
  study.rules = {{"C", "reading", {{"depth", "stomach"}}, "very_large", 1}};
  for (const char* who : {"A", "B", "C"}) judge(study, who, "ssllVV");
  auto stopped = study;
  judge(stopped, "D", "ssllVV");
  judge(study, "D", "ssllVVVVVVVVVV");
  const auto built = buildModel(study, forms(), {});
  const auto without = buildModel(stopped, forms(), {});
  ASSERT_TRUE(built && without);
  EXPECT_EQ(built->model.output, without->model.output);
  EXPECT_EQ(evaluate(built->model, {1, 0, 300, 0}).force_n, evaluate(without->model, {1, 0, 300, 0}).force_n);
  EXPECT_TRUE(mentions(built->notes, "Vote at 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.3, 1.4 N: above 0.6 N"));

  BuildSettings settings;
  settings.force_end_n = 1.4;
  const auto asked = buildModel(study, forms(), settings);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->model.output.max, 1.4);
  EXPECT_EQ(settingOf(asked->model, "force_end_n"), "1.4");
  EXPECT_TRUE(mentions(asked->notes, "The universe of the force ends at 1.4 N instead of 1.1 N: as asked for."));
}

TEST(ModelBuilder, ForceTermsInThreeWays) {
  auto study = smallStudy();
  judge(study, "A", "sslllV");
  judge(study, "B", "slVVVV");
  const auto points = [&study](ForceTermsFrom from, std::size_t term) {
    BuildSettings settings;
    settings.force_terms = from;
    const auto built = buildModel(study, forms(), settings);
    EXPECT_TRUE(built) << built.error().message();
    EXPECT_EQ(settingOf(built->model, "force_terms"), '"' + std::string(name(from)) + '"');
    return built->model.output.terms[term].points;
  };
  // Votes: .1 small, .2 large (the higher of two halves), .3 very large, so all above.
  EXPECT_EQ(points(ForceTermsFrom::kVote, 4), (std::vector<double>{0.2, 0.1 * 3, 0.1 * 6, 0.1 * 6}));
  // Thresholds of very large: 0.55 and 0.25 N.
  const auto thresholds = points(ForceTermsFrom::kThresholds, 4);
  EXPECT_NEAR(thresholds[0], 0.35, 1e-9);  // sums of tenths
  EXPECT_NEAR(thresholds[1], 0.45, 1e-9);
  const auto frequency = points(ForceTermsFrom::kFrequency, 4);
  EXPECT_LE(frequency[0], 0.2);  // half of the answers from 0.3 N on, all at 0.6 N
  EXPECT_EQ(frequency[1], 0.6);

  study.judgements.clear();
  BuildSettings settings;
  EXPECT_EQ(settingOf(buildModel(study, forms(), settings)->model, "force_terms"), "\"default\"");
  settings.force_end_n = 1;
  EXPECT_EQ(errorOf(study, settings),
            "force-end: found no force judgements, wanted judgements, because without them the force has its default "
            "terms and their end");
}

TEST(ModelBuilder, GivenRulesTakeThePlaceOfAnswersAndBringTheirDepthTerms) {
  auto study = smallStudy();
  study.rules = {{"B", "reading", {{"depth", "laryngopharynx"}}, "large", 1}};
  auto built = buildModel(study, forms(), {});
  ASSERT_TRUE(built) << built.error().message();
  EXPECT_TRUE(mentions(built->notes, "both given rules and answers"));
  EXPECT_EQ(built->experts[1].source, ExpertRules::Source::kGiven);
  EXPECT_EQ(built->experts[1].depth_terms, "form_a2");
  // One expert each: the first one's set is the model's, the other has an override.
  EXPECT_EQ(built->model.inputs[2].terms, support::findDepthTerms("form_a1")->terms);
  ASSERT_EQ(built->model.experts[1].overrides.size(), 1U);
  EXPECT_EQ(built->model.experts[1].overrides[0].terms, support::findDepthTerms("form_a2")->terms);
  // 130 mm is laryngopharynx for B alone: large, symmetric about .7.
  EXPECT_NEAR(evaluate(built->model, {0, 0, 130, 110}).force_n, 0.7, 1e-14);
}

TEST(ModelBuilder, RefusesWhatDoesNotResolve) {
  const auto with_rule = [](study::GivenRule rule) {
    auto study = smallStudy();
    study.rules = {std::move(rule)};
    return errorOf(study);
  };
  EXPECT_EQ(
      with_rule({"A", "reading", {{"depth", "oropharynx"}}, "small", 1}),
      "rule 1 of participant A: found depth 'oropharynx', wanted one of nasal_cavity, nasopharynx, laryngopharynx, "
      "esophagus, stomach");
  EXPECT_EQ(with_rule({"A", "", {{"angle", "small"}}, "small", 1}),
            "rule 1 of participant A: found input 'angle', wanted one of lubrication, neck_flexion, depth, speed");
  EXPECT_EQ(with_rule({"A", "", {{"speed", "slow"}}, "huge", 1}),
            "rule 1 of participant A: found force 'huge', wanted one of very_small, small, medium, large, very_large");
  EXPECT_EQ(with_rule({"A", "nowhere", {{"speed", "slow"}}, "small", 1}),
            "rules of participant A: found form 'nowhere', wanted one of short, reading");
  EXPECT_EQ(with_rule({"A", "", {{"speed", "slow"}}, "small", 1.5}),
            "rule 1 of participant A: found weight 1.5, wanted a number in [0, 1]");
  EXPECT_EQ(with_rule({"Z", "", {{"speed", "slow"}}, "small", 1}),
            "rules: found participant 'Z', wanted a participant of the study");

  auto study = smallStudy();
  study.answers.clear();
  EXPECT_NE(errorOf(study).find("found no participant with rules"), std::string::npos);
  study = smallStudy();
  addSpeeds(study, "B", {20, 20, 30});
  EXPECT_EQ(errorOf(study),
            "speeds of participant B, samples: found 2 distinct values, wanted at least 3, one for each cluster");
  BuildSettings settings;
  settings.speed.trim = 1;
  EXPECT_EQ(errorOf(study, settings), "trim: found 1, wanted a share of 0 or more and below 1");
}

TEST(ModelBuilder, AnExpertAloneHasItsOwnTermsAsTheModels) {
  auto study = smallStudy();
  study.rules = {{"B", "reading", {{"depth", "laryngopharynx"}}, "large", 1}};
  const auto built = buildModel(study, forms(), {});
  ASSERT_TRUE(built);
  const auto alone = expertModel(built->model, "B");
  ASSERT_TRUE(alone) << alone.error().message();
  ASSERT_EQ(alone->experts.size(), 1U);
  EXPECT_TRUE(alone->experts[0].overrides.empty());
  EXPECT_EQ(alone->inputs[2].terms, support::findDepthTerms("form_a2")->terms);
  EXPECT_FALSE(evaluate(*alone, {1, 0, 30, 30}).fired);
  EXPECT_NEAR(evaluate(*alone, {1, 0, 130, 30}).force_n, 0.7, 1e-14);
  for (const auto& check : alone->checks) EXPECT_EQ(evaluate(*alone, check.in).force_n, check.force);
  EXPECT_EQ(expertModel(built->model, "Z").error().message(), "experts: found 'Z', wanted one of A, B");
}

TEST(ModelBuilder, MeasuredDepthsReachTheModelAndAreStoredInIt) {
  BuildSettings settings;
  const auto inputs = support::ngtInputs();
  settings.measured_depths = emptyMeasurement(inputs[2]);
  settings.measured_depths->image = "patient.png";
  settings.measured_depths->boundaries[0] = {80, 5};
  const auto with_template = buildModel(smallStudy(), forms(), settings);
  ASSERT_TRUE(with_template);
  EXPECT_EQ(with_template->model, buildModel(smallStudy(), forms(), {})->model) << "measured, and not chosen";

  settings.depths = DepthsFrom::kMeasured;
  const auto built = buildModel(smallStudy(), forms(), settings);
  ASSERT_TRUE(built) << built.error().message();
  const auto& depth = built->model.inputs[2];
  ASSERT_EQ(depth.terms.size(), 5U) << "the regions of the form";
  EXPECT_EQ(depth.terms[0].points, (std::vector<double>{0, 0, 75, 85}));
  EXPECT_EQ(depth.terms[1].points, (std::vector<double>{75, 85, 105, 125}));
  std::string stored;
  for (const auto& one : built->model.provenance->settings) {
    if (one.key == "depths") {
      EXPECT_EQ(one.json, "\"measured\"");
    }
    if (one.key == "depth_measurement") stored = one.json;
  }
  auto kept = readMeasurement(stored);
  ASSERT_TRUE(kept) << stored;
  EXPECT_EQ(kept->boundaries, settings.measured_depths->boundaries);
  EXPECT_EQ(kept->image, "") << "a file's name may be a person's";
  EXPECT_EQ(built->notes.front().find("The depths of the regions are measured on the image 'patient.png'"), 0U);
  EXPECT_EQ(built->note_subjects.front(), "depth");

  settings.measured_depths.reset();
  const auto refused = buildModel(smallStudy(), forms(), settings);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("no measurement of depths in the study"), std::string::npos);
}

}  // namespace
}  // namespace tactus::elicitation
