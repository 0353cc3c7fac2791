#include <gtest/gtest.h>
#include <limits>

#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {
namespace {

std::vector<study::Participant> experts() {
  study::Participant a;
  a.code = "A";
  a.years_experience = 12;
  a.category = "Expert";
  a.weight = 0.5;
  study::Participant b;
  b.code = "B";
  b.years_experience = 3;
  b.category = "beginner";
  b.weight = 0;
  return {a, b};
}

std::vector<double> weights(const WeightSettings& settings) { return expertWeights(experts(), settings).value(); }

TEST(ExpertWeights, EachPolicy) {
  WeightSettings settings;
  EXPECT_EQ(weights(settings), (std::vector<double>{1, 1}));
  settings.policy = WeightPolicy::kYears;
  EXPECT_EQ(weights(settings), (std::vector<double>{12, 3}));
  settings.policy = WeightPolicy::kCategory;
  EXPECT_EQ(weights(settings), (std::vector<double>{3, 1}));
  settings.policy = WeightPolicy::kColumn;
  EXPECT_EQ(weights(settings), (std::vector<double>{0.5, 0}));
  settings.policy = WeightPolicy::kTable;
  settings.table = {{"B", 2}, {"A", 7}, {"C", 1}};
  EXPECT_EQ(weights(settings), (std::vector<double>{7, 2}));
}

TEST(ExpertWeights, RefusesMissingAndUselessValues) {
  WeightSettings settings;
  settings.policy = WeightPolicy::kTable;
  settings.table = {{"A", 1}};
  auto result = expertWeights(experts(), settings);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message(),
            "participant B: found no row in the table of weights, wanted one row per expert (there are: A)");
  settings.table = {{"A", 0}, {"B", 0}};
  EXPECT_FALSE(expertWeights(experts(), settings));
  settings.table = {{"A", -1}, {"B", 1}};
  EXPECT_FALSE(expertWeights(experts(), settings));

  auto people = experts();
  people[1].years_experience.reset();
  people[1].category = "wizard";
  settings.policy = WeightPolicy::kYears;
  EXPECT_FALSE(expertWeights(people, settings));
  settings.policy = WeightPolicy::kCategory;
  EXPECT_NE(expertWeights(people, settings).error().message().find("'wizard'"), std::string::npos);
}

TEST(ExpertWeights, RefusesWhatIsNoWeightWithItsPlace) {
  auto people = experts();
  people[0].line = {2};
  people[1].line = {3};
  people[0].years_experience = 0;
  people[1].years_experience = 0;
  WeightSettings settings;
  settings.policy = WeightPolicy::kYears;
  EXPECT_EQ(expertWeights(people, settings).error().message(),
            "participants.csv: weights: found 0 for every expert, wanted at least one weight above 0");
  people[1].years_experience = -2;
  EXPECT_EQ(
      expertWeights(people, settings).error().message(),
      "participants.csv: line 3, column 'years_experience': found weight -2, wanted a finite number of 0 or more");
  settings.policy = WeightPolicy::kTable;
  settings.table_file = "w.csv";
  settings.table = {{"A", 1}, {"B", std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(expertWeights(people, settings).error().message(),
            "w.csv: participant B: found weight inf, wanted a finite number of 0 or more");
}

TEST(ExpertWeights, NotesWhoHardlyCountsAndHowMuchIsSimulated) {
  const auto people = experts();
  const auto notes = [&](std::vector<double> weights, std::vector<bool> simulated) {
    return weightNotes(people, weights, simulated);
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(notes({1, 3}, {false, false}), Notes{});
  EXPECT_EQ(notes({1, 3}, {true, true}), Notes{}) << "all simulated is said elsewhere";
  EXPECT_EQ(notes({1, 0}, {false, false}), Notes{"Participant B has the weight 0 and does not count in the mean."});
  EXPECT_EQ(notes({1e300, 1e-300}, {false, false}),
            Notes{"Participant B hardly counts in the mean: the weight 1e-300 is less than 0.1 % of all."});
  EXPECT_EQ(notes({1e308, 1e308}, {false, true}),
            Notes{"Simulated experts (B) have 50.0 % of the weight of the mean."});
}

TEST(ExpertWeights, ReadsATable) {
  const auto read = [](const char* text) { return readWeightTable(base::CsvTable::parse(text, "w.csv").value()); };
  EXPECT_EQ(read("participant,weight\nA,2\nB,0.5\n").value(), (std::map<std::string, double>{{"A", 2}, {"B", 0.5}}));
  EXPECT_FALSE(read("participant,weight\nA,2\nA,3\n"));
  EXPECT_FALSE(read("participant,weight\nA,-2\n"));
  EXPECT_FALSE(read("participant\nA\n"));
}

}  // namespace
}  // namespace tactus::elicitation
