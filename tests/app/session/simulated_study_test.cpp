#include "app/session/simulated_study.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>

#include "core/study/csv_tables.h"

namespace tactus::session {
namespace {

TEST(SimulatedStudy, SaysThatItIsSimulated) {
  const auto study = simulatedNgtStudy();
  ASSERT_TRUE(study);
  EXPECT_NE(study->name.find("simulated"), std::string::npos);
  ASSERT_EQ(study->participants.size(), 4U);
  for (const auto& participant : study->participants) {
    EXPECT_TRUE(participant.simulated);
    EXPECT_FALSE(participant.years_experience.has_value());  // the paper says "more than 10" only
  }
}

TEST(SimulatedStudy, S4GivesRulesAndTheOthersAnswers) {
  const auto study = simulatedNgtStudy(4, "ngt-a2-shifted");
  ASSERT_TRUE(study);
  std::set<std::string> answered;
  for (const auto& answer : study->answers) answered.insert(answer.participant);
  EXPECT_EQ(answered, (std::set<std::string>{"S1", "S2", "S3"}));
  EXPECT_EQ(study->rules.size(), 45U);
  for (const auto& rule : study->rules) {
    EXPECT_EQ(rule.participant, "S4");
    EXPECT_EQ(rule.form, "ngt-a2-shifted");
  }
}

TEST(SimulatedStudy, FollowsFromTheSeed) {
  EXPECT_EQ(simulatedNgtStudy(3).value(), simulatedNgtStudy(3).value());
  EXPECT_NE(simulatedNgtStudy(3)->answers, simulatedNgtStudy(4)->answers);
}

TEST(SimulatedStudy, UnknownReadingIsRefused) { EXPECT_FALSE(simulatedNgtStudy(1, "another")); }

TEST(SimulatedStudy, SurvivesItsTables) {
  auto study = simulatedNgtStudy().value();
  const auto folder = std::filesystem::path(::testing::TempDir()) / "tactus-simulated-study";
  const std::vector<std::string> inputs = {"lubrication", "neck_flexion", "depth", "speed"};
  ASSERT_TRUE(study::writeStudyFolder(study, inputs, folder.string()));
  const auto read = study::readStudyFolder(folder.string(), inputs);
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(read) << read.error().message();
  study.name = read->study.name;
  EXPECT_EQ(read->study, study);
}

}  // namespace
}  // namespace tactus::session
