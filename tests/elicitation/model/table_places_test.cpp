// Errors about records that come from a table name its file, line and column.
#include <gtest/gtest.h>

#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {
namespace {

using JudgementKind = study::ForceJudgement::Kind;
using Status = study::Answer::Status;

std::vector<study::Form> forms() {
  study::Form form;
  form.id = "short";
  form.depth_terms = "form_a1";
  form.items = {{1, "", {{"lubrication", "well"}, {"depth", "nasal_cavity"}}}, {2, "", {{"speed", "fast"}}}};
  study::Form reading;
  reading.id = "reading";
  reading.depth_terms = "form_a2";
  return {form, reading};
}

study::Study study() {
  study::Study study;
  study::Participant a;
  a.code = "A";
  a.line = {2};
  study.participants = {a};
  study.rules = {{"A", "", {{"speed", "slow"}}, "small", 1, {2}}};
  return study;
}

std::string placedError(const study::Study& study, const BuildSettings& settings = {}) {
  const auto built = buildModel(study, forms(), settings);
  return built ? std::string("no error") : built.error().message();
}

std::string withRules(std::vector<study::GivenRule> rules) {
  auto changed = study();
  changed.rules = std::move(rules);
  return placedError(changed);
}

std::string withAnswers(std::vector<study::Answer> answers) {
  auto changed = study();
  changed.rules.clear();
  changed.answers = std::move(answers);
  return placedError(changed);
}

TEST(TablePlaces, GivenRules) {
  EXPECT_EQ(withRules({{"A", "", {{"lubrication", "wel"}}, "small", 1, {2}}}),
            "rules.csv: line 2, column 'lubrication': found 'wel', wanted one of poor, medium, well");
  EXPECT_EQ(withRules({{"A", "reading", {{"depth", "oropharynx"}}, "small", 1, {5}}}),
            "rules.csv: line 5, column 'depth': found 'oropharynx', wanted one of nasal_cavity, nasopharynx, "
            "laryngopharynx, esophagus, stomach");
  EXPECT_EQ(withRules({{"A", "", {{"speed", "slow"}}, "huge", 1, {3}}}),
            "rules.csv: line 3, column 'then': found 'huge', wanted one of very_small, small, medium, large, "
            "very_large");
  EXPECT_EQ(withRules({{"A", "nowhere", {{"speed", "slow"}}, "small", 1, {2}}}),
            "rules.csv: line 2, column 'form': found 'nowhere', wanted one of short, reading");
  EXPECT_EQ(withRules({{"A", "short", {{"speed", "slow"}}, "small", 1, {2}},
                       {"A", "reading", {{"speed", "fast"}}, "small", 1, {4}}}),
            "rules.csv: line 4, column 'form': found 'reading' after 'short' for participant A, wanted forms with the "
            "same depth terms");
  EXPECT_EQ(
      withRules({{"A", "", {{"speed", "slow"}}, "small", 1, {2}}, {"A", "", {{"speed", "slow"}}, "small", 1, {3}}}),
      "rules.csv: line 3, column 'then': found the same rule as before, wanted each rule once");
  EXPECT_EQ(withRules({{"Z", "", {{"speed", "slow"}}, "small", 1, {9}}}),
            "rules.csv: line 9, column 'participant': found 'Z', wanted a participant of the study");
}

TEST(TablePlaces, FormsOfOneExpertThatDifferAreNamedByTheirLabelsElsewhere) {
  EXPECT_EQ(
      withRules({{"A", "short", {{"speed", "slow"}}, "small", 1}, {"A", "reading", {{"speed", "fast"}}, "small", 1}}),
      "participant A: found forms with different depth terms (short: Five regions of the form (Table A1); the "
      "esophagus reaches the end; reading: Five regions of the given rules (Table A2); the laryngopharynx covers "
      "the oropharynx), wanted forms with the same depth terms");
}

TEST(TablePlaces, Answers) {
  EXPECT_EQ(withAnswers({{"A", "short", 46, "small", Status::kAnswered, {7}}}),
            "answers.csv: line 7, column 'item': found item 46, which form short does not have, wanted one of its 2 "
            "items");
  EXPECT_EQ(withAnswers({{"A", "short", 1, "smal", Status::kAnswered, {7}}}),
            "answers.csv: line 7, column 'term': found 'smal', wanted one of very_small, small, medium, large, "
            "very_large");
  EXPECT_EQ(withAnswers({{"A", "short", 1, "small", Status::kAnswered, {7}},
                         {"A", "short", 1, "small", Status::kAnswered, {8}}}),
            "answers.csv: line 8, column 'item': found item 1 again, wanted one answer per item");
}

TEST(TablePlaces, AnAnswerWithATermThatNoForceGot) {
  auto changed = study();
  changed.rules.clear();
  // The first force of all is small already: nothing lies below 0 N.
  changed.answers = {{"A", "short", 2, "very_small", Status::kAnswered, {6}}};
  changed.judgements = {{"A", "ascending", 1, 0, JudgementKind::kTerm, "small", {2}},
                        {"A", "ascending", 2, 0.2, JudgementKind::kTerm, "medium", {3}}};
  EXPECT_EQ(
      placedError(changed),
      "answers.csv: line 6, column 'term': found 'very_small', wanted a term that the judged forces give: there is no "
      "room for 'very_small' between 0 N and the end of the universe at 0.6 N");
}

TEST(TablePlaces, Judgements) {
  auto changed = study();
  changed.judgements = {{"A", "ascending", 1, 0.1, JudgementKind::kTerm, "smal", {4}}};
  EXPECT_EQ(placedError(changed),
            "judgements.csv: line 4, column 'term': found 'smal', wanted one of very_small, small, medium, large, "
            "very_large");
  changed.judgements[0].force_n = -1;
  EXPECT_EQ(placedError(changed),
            "judgements.csv: line 4, column 'force_n': found -1 N, wanted a force of 0 N or more");
  changed.judgements = {{"A", "ascending", 1, 0.1, JudgementKind::kTerm, "small", {4}},
                        {"A", "ascending", 2, 0.1, JudgementKind::kTerm, "small", {5}}};
  EXPECT_EQ(placedError(changed),
            "judgements.csv: line 5, column 'force_n': found a second judgement in series 'ascending' at 0.1 N, wanted "
            "one judgement per participant and force");
  changed.judgements = {{"A", "random", 1, 0.1, JudgementKind::kTerm, "small", {4}}};
  EXPECT_EQ(placedError(changed),
            "judgements.csv: judgements: found no row of series 'ascending', wanted a series that was judged (there "
            "are: random)");
  changed.judgements = {{"A", "ascending", 1, 0.1, JudgementKind::kNotFelt, "", {4}}};
  EXPECT_EQ(placedError(changed),
            "judgements.csv: vote: found no decided force, wanted at least one force above 0 N that was judged");
}

TEST(TablePlaces, Speeds) {
  auto changed = study();
  changed.speeds = {{"A", "slow", 1, 0, 0, 1, {2}}, {"A", "zzz", 1, 0, 0, 2, {3}}};
  EXPECT_EQ(placedError(changed), "speeds.csv: line 3, column 'level': found 'zzz', wanted one of slow, medium, fast");
  changed.speeds[1] = {"A", "fast", 1, 0, 0, 2, {3}};
  EXPECT_EQ(placedError(changed),
            "speeds.csv: speeds of participant A, samples: found 2 distinct values, wanted at least 3, one for each "
            "cluster");
  changed.speeds = {{"A", "zzz", 1, 0, 0, 2}};
  EXPECT_EQ(placedError(changed), "speeds of participant A: found level 'zzz', wanted one of slow, medium, fast");
}

TEST(TablePlaces, Weights) {
  BuildSettings settings;
  settings.weights.policy = WeightPolicy::kYears;
  EXPECT_EQ(placedError(study(), settings),
            "participants.csv: line 2, column 'years_experience': found an empty cell, wanted a number, because the "
            "weights are the years");
  settings.weights.policy = WeightPolicy::kTable;
  settings.weights.table = {{"Z", 1}};
  settings.weights.table_file = "w.csv";
  EXPECT_EQ(placedError(study(), settings),
            "w.csv: participant A: found no row in the table of weights, wanted one row per expert (there are: Z)");
}

}  // namespace
}  // namespace tactus::elicitation
