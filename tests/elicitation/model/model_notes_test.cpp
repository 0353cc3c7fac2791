// What a built model and the notes of its build say of the data: forms, odd rows, and what is simulated.
#include <algorithm>
#include <gtest/gtest.h>

#include "elicitation/model/model_builder.h"

#include "tests/elicitation/model/small_study.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

using Status = study::Answer::Status;

TEST(ModelBuilder, GivenRulesWithoutAFormGetTheSetTheyUse) {
  const auto set_of = [](std::vector<const char*> regions) {
    study::Study study;
    study.participants = {participant("A")};
    for (const char* region : regions) study.rules.push_back({"A", "", {{"depth", region}}, "small", 1});
    const auto built = buildModel(study, forms(), {});
    EXPECT_TRUE(mentions(built.value().notes, "name no form"));
    EXPECT_TRUE(mentions(built.value().notes, support::findDepthTerms(built.value().experts.at(0).depth_terms)->label));
    EXPECT_FALSE(mentions(built.value().notes, built.value().experts.at(0).depth_terms)) << "an id of the program";
    EXPECT_EQ(settingOf(built.value().model, "forms"), "{ \"A\": null }");
    EXPECT_EQ(settingOf(built.value().model, "depth_terms_inferred"), "[\"A\"]");
    return built.value().experts.at(0).depth_terms;
  };
  EXPECT_EQ(set_of({"nasal_cavity", "stomach"}), "form_a2");
  EXPECT_EQ(set_of({"oropharynx"}), "form_a1");
  EXPECT_EQ(set_of({"oropharynx", "stomach"}), "six_regions");
  EXPECT_EQ(set_of({"nasal_cavity"}), "six_regions");
}

TEST(ModelBuilder, OtherFormsAndParticipantsWithoutRulesAreNoted) {
  auto study = smallStudy();
  study.participants.push_back(participant("C"));
  study.answers.push_back({"C", "usability", 1, "5", Status::kAnswered});
  const auto built = buildModel(study, forms(), {});
  ASSERT_TRUE(built) << built.error().message();
  EXPECT_TRUE(mentions(built->notes, "'usability'"));
  EXPECT_TRUE(mentions(built->notes, "Participant C has no rules"));
}

TEST(ModelBuilder, ProvenanceSaysWhichFormsAndDepthTermsWereUsed) {
  auto study = smallStudy();
  study.rules = {{"B", "reading", {{"depth", "laryngopharynx"}}, "large", 1}};
  BuildSettings settings;
  settings.extra = {{"simulation_seed", "7"}};
  const auto built = buildModel(study, forms(), settings);
  ASSERT_TRUE(built) << built.error().message();
  EXPECT_EQ(settingOf(built->model, "forms"), "{ \"A\": \"short\", \"B\": \"reading\" }");
  EXPECT_EQ(settingOf(built->model, "depth_terms"), "{ \"A\": \"form_a1\", \"B\": \"form_a2\" }");
  EXPECT_EQ(settingOf(built->model, "depth_terms_inferred"), "absent");
  EXPECT_EQ(settingOf(built->model, "simulation_seed"), "7");
}

TEST(ModelBuilder, OddDataAreNoted) {
  auto study = smallStudy();
  addSpeeds(study, "A", {-3, 100, 200});
  study.rules = {{"B", "", {{"speed", "slow"}, {"depth", "stomach"}}, "small", 1, {2}},
                 {"B", "", {{"depth", "stomach"}}, "small", 1, {3}},
                 {"B", "", {{"depth", "stomach"}, {"speed", "slow"}}, "large", 1, {4}}};
  BuildSettings settings;
  settings.weights.policy = WeightPolicy::kTable;
  settings.weights.table = {{"A", 1}, {"B", 1}, {"Z", 1}};
  settings.weights.table_file = "w.csv";
  study.speeds.push_back({"A", "slow", 1, 0, 0, 8});  // so that the lowest of three centers is not negative
  for (int i = 0; i < 100; ++i) study.speeds.push_back({"A", "slow", 2, 0.001 * i, 0, 8});
  const auto built = buildModel(study, forms(), settings);
  ASSERT_TRUE(built) << built.error().message();
  EXPECT_TRUE(mentions(built->notes, "10 of 131 speed samples lie below 0 mm/s"));
  EXPECT_TRUE(mentions(built->notes,
                       "Participant B contradicts themselves: rule 1 (line 2) says 'small', rule 3 (line 4) says "
                       "'large' of the same conditions."));
  EXPECT_TRUE(mentions(built->notes, "w.csv has a weight for 'Z', who is not in the study."));
}

TEST(ModelBuilder, SimulatedDataSaySo) {
  auto study = smallStudy();
  for (auto& participant : study.participants) participant.simulated = true;
  study.rules = {{"A", "", {{"depth", "nasal_cavity"}}, "small", 1}};
  const auto built = buildModel(study, forms(), {});
  ASSERT_TRUE(built);
  EXPECT_EQ(built->model.experts[0].label, "A") << "given rules are not what is simulated of a participant";
  EXPECT_EQ(built->model.experts[1].label, "B (simulated)");
  EXPECT_EQ(built->model.provenance->notes, "Simulated, not measured: answers of A, B. Rules given directly: A.");
  EXPECT_TRUE(mentions(built->notes, "Simulated"));
  const auto& sources = built->model.provenance->sources;
  EXPECT_TRUE(std::any_of(sources.begin(), sources.end(), [](const fuzzy::NamedJson& source) {
    return source.key == "simulated" && source.json == "[\"A\", \"B\"]";
  }));
}

TEST(ModelBuilder, WhatIsSimulatedIsSaidForEachKindOfData) {
  auto study = smallStudy();
  study.participants[0].simulated = true;
  addSpeeds(study, "A", {20, 100, 200});
  study.judgements = {{"A", "ascending", 1, 1.1, study::ForceJudgement::Kind::kTerm, "small"},
                      {"B", "ascending", 1, 1.1, study::ForceJudgement::Kind::kTerm, "small"}};
  study.answers = {{"B", "short", 1, "small", Status::kAnswered}};
  study.rules = {{"A", "", {{"depth", "nasal_cavity"}}, "small", 1}};
  const auto notes = [&study] { return buildModel(study, forms(), {}).value().model.provenance->notes; };
  EXPECT_EQ(notes(), "Simulated, not measured: strokes and judgements of A. Rules given directly: A.");
  study.participants[1].simulated = true;
  EXPECT_EQ(notes(),
            "Simulated, not measured: strokes of A; judgements of A, B; answers of B. Rules given directly: A.");
  study.speeds.clear();
  study.judgements.clear();
  study.participants[1].simulated = false;
  EXPECT_EQ(notes(), "Simulated participants without strokes, judgements and answers: A. Rules given directly: A.");
}

}  // namespace
}  // namespace tactus::elicitation
