#include "elicitation/tracing/sources.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "app/session/study_source.h"

#include "tests/elicitation/four_people.h"
#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"

namespace tactus::elicitation {
namespace {

struct Traced {
  study::Study study = support::tableStudy(1, {.nurses = 3, .rows_per_s = 30});
  BuildSettings settings;
  BuiltModel built = buildModel(study, session::knownForms(support::defaultProcedure()), settings).value();
};

const Traced& traced() {
  static const Traced kTraced;
  return kTraced;
}

TEST(Sources, ASpeedVertexIsTheMeanOfTheParticipantsOwn) {
  const auto& t = traced();
  const auto& speed = t.built.model.inputs[3];
  // Medium: its foot is the p of the first ramp, its core begins at that ramp's q.
  for (const std::size_t point : {0U, 1U, 2U, 3U}) {
    const auto shares = speedVertexShares(t.study, t.built, t.settings, "medium", point);
    ASSERT_TRUE(shares) << shares.error().message();
    ASSERT_EQ(shares->size(), 3U);
    double mean_mm_s = 0;
    for (const auto& one : *shares) {
      EXPECT_NEAR(one.share, 1.0 / 3, 1e-15);
      mean_mm_s += one.share * one.value_mm_s;
      EXPECT_EQ(one.strokes.size(), 12U) << "four at each of three levels";
    }
    EXPECT_NEAR(mean_mm_s, speed.terms[1].points[point], 1e-9);
  }
  const auto sources = sourcesOfVertex(t.study, t.built, t.settings, "speed", "fast", 1);
  ASSERT_TRUE(sources);
  EXPECT_EQ(sources->strokes.size(), 36U);
  EXPECT_TRUE(sources->judgements.empty());
}

TEST(Sources, AnEndOfTheUniverseAndDefaultTermsComeFromNoRecord) {
  const auto& t = traced();
  for (const auto& [variable, term, point] :
       {std::tuple("speed", "slow", 0U), std::tuple("speed", "fast", 3U), std::tuple("depth", "esophagus", 1U),
        std::tuple("force", "very_small", 0U)}) {
    const auto sources = sourcesOfVertex(t.study, t.built, t.settings, variable, term, point);
    ASSERT_TRUE(sources);
    EXPECT_TRUE(sources->empty()) << variable << ' ' << term;
    EXPECT_EQ(sources->without_records.size(), 1U);
  }
  EXPECT_FALSE(sourcesOfVertex(t.study, t.built, t.settings, "warmth", "slow", 0));
  EXPECT_FALSE(sourcesOfVertex(t.study, t.built, t.settings, "speed", "quick", 0));
  EXPECT_FALSE(sourcesOfVertex(t.study, t.built, t.settings, "speed", "slow", 4));
}

TEST(Sources, AMeasuredDepthNamesItsImage) {
  const auto& t = traced();
  BuildSettings settings = t.settings;
  settings.depths = DepthsFrom::kMeasured;
  settings.measured_depths = emptyMeasurement(t.built.model.inputs[2]);
  settings.measured_depths->image = "patient.png";
  const auto sources = sourcesOfVertex(t.study, t.built, settings, "depth", "esophagus", 1);
  ASSERT_TRUE(sources);
  EXPECT_TRUE(sources->empty());
  ASSERT_EQ(sources->without_records.size(), 1U);
  EXPECT_NE(sources->without_records[0].find("measured on the image 'patient.png'"), std::string::npos)
      << sources->without_records[0];
}

// Table 2: very small wins at .1 and .2 N, so its core ends with the votes at .2 N, and its foot is where small begins.
TEST(Sources, AForceVertexIsTheVotesOfItsStep) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {}).value();
  for (const auto& [term, point, force_n] :
       {std::tuple("very_small", 2U, .2), std::tuple("very_small", 3U, .3), std::tuple("small", 1U, .3),
        std::tuple("large", 1U, .7), std::tuple("very_large", 1U, .8)}) {
    const auto sources = sourcesOfVertex(study, built, {}, "force", term, point);
    ASSERT_TRUE(sources);
    ASSERT_EQ(sources->judgements.size(), 4U) << term << ' ' << point;
    std::set<std::string> who;
    for (const auto index : sources->judgements) {
      EXPECT_NEAR(study.judgements[index].force_n, force_n, 1e-9);
      who.insert(study.judgements[index].participant);
    }
    EXPECT_EQ(who.size(), 4U);
  }
  BuildSettings thresholds;
  thresholds.force_terms = ForceTermsFrom::kThresholds;
  const auto by_thresholds = buildModel(study, {}, thresholds).value();
  EXPECT_EQ(sourcesOfVertex(study, by_thresholds, thresholds, "force", "small", 1)->judgements.size(), 44U);
}

TEST(Sources, ARuleIsItsAnswer) {
  const auto& t = traced();
  const auto forms = session::knownForms(support::defaultProcedure());
  for (std::size_t e = 0; e < t.built.model.experts.size(); ++e) {
    const auto& rules = t.built.model.experts[e].rules;
    for (std::size_t r = 0; r < rules.size(); ++r) {
      const auto sources = sourcesOfRule(t.study, t.built, e, r);
      ASSERT_TRUE(sources);
      ASSERT_EQ(sources->answers.size(), 1U);
      const auto& answer = t.study.answers[sources->answers[0]];
      EXPECT_EQ(ruleOfAnswer(t.study, t.built, sources->answers[0]), (RulePlace{e, r}));
      EXPECT_EQ(answer.participant, t.built.model.experts[e].id);
      EXPECT_EQ(answer.term, rules[r].then);
      const auto form =
          std::find_if(forms.begin(), forms.end(), [&](const auto& one) { return one.id == answer.form; });
      const auto item = std::find_if(form->items.begin(), form->items.end(),
                                     [&](const auto& one) { return one.number == answer.item; });
      ASSERT_EQ(item->conditions.size(), rules[r].conditions.size());
      for (std::size_t c = 0; c < item->conditions.size(); ++c) {
        EXPECT_EQ(item->conditions[c].term, rules[r].conditions[c].term);
      }
    }
  }
  EXPECT_FALSE(sourcesOfRule(t.study, t.built, 0, 999));
}

TEST(Sources, AGivenRuleIsItsRow) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {}).value();
  const auto sources = sourcesOfRule(study, built, 2, 7);
  ASSERT_TRUE(sources);
  EXPECT_EQ(sources->rules, (std::vector<std::size_t>{2 * 45 + 7}));
  EXPECT_EQ(ruleOfGiven(study, built, 2 * 45 + 7), (RulePlace{2, 7}));
}

// At (1, 60, 70, 50): well, flexion medium and large, nasal cavity and nasopharynx half each, slow. An expert has at
// most one winning rule for each word, and only words that fire count.
TEST(Sources, AForceIsTheRulesThatSetItAndTheVotesOfTheirWords) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {}).value();
  const auto sources = sourcesOfForce(study, built, {}, std::vector<double>{1, 60, 70, 50});
  ASSERT_TRUE(sources) << sources.error().message();
  EXPECT_TRUE(std::is_sorted(sources->rules.begin(), sources->rules.end()));
  ASSERT_FALSE(sources->rules.empty());
  std::set<std::string> who;
  for (const auto index : sources->rules) {
    const auto& rule = study.rules[index];
    who.insert(rule.participant);
    const auto& depth = rule.conditions[1].term;
    EXPECT_TRUE(depth == "nasal_cavity" || depth == "nasopharynx") << depth;
    const auto& condition = rule.conditions[0];
    EXPECT_TRUE(condition.term == "well" || condition.term == "slow" ||
                (condition.input == "neck_flexion" && condition.term != "small"))
        << condition.input << ' ' << condition.term;
  }
  EXPECT_EQ(who.size(), 4U);
  EXPECT_FALSE(sources->judgements.empty());
  EXPECT_FALSE(sourcesOfForce(study, built, {}, std::vector<double>{1, 60}));
}

}  // namespace
}  // namespace tactus::elicitation
