#include "app/workbench/labs/experts/experts_lab.h"

#include <QTemporaryDir>
#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/base/display_text.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using elicitation::WeightPolicy;
using tests::comesTrue;

class ExpertsLabTest : public testing::Test {
 protected:
  void SetUp() override {
    study.open(path);
    lab.setWanted(true);
    ASSERT_TRUE(comesTrue([this] { return !lab.compared().empty() && !lab.curves().x.empty(); }));
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  StudyConnection study;
  LabData data{study};
  LabModel model{data};
  ExpertsLab lab{data, model};
};

TEST_F(ExpertsLabTest, EqualWeightsDifferByNothingAndWhatTheDataLackSaysWhy) {
  for (const ComparedWeights& one : lab.compared()) {
    if (one.policy == WeightPolicy::kEqual) {
      EXPECT_EQ(one.from_equal.largest_n, 0);
      EXPECT_EQ(one.weights, std::vector<double>(4, 1.0));
    }
    // The demo's nurses have "more than 10 years", which is no number.
    if (one.policy == WeightPolicy::kYears) {
      EXPECT_FALSE(one.unavailable.isEmpty());
    }
  }
  struct PolicyTable {
    enum { kLargest = 2 };
  };
  Columns<PolicyRow> table(policyColumns());
  table.setRows(policyRows(lab.compared()));
  EXPECT_EQ(table.index(0, PolicyTable::kLargest).data().toString(), QStringLiteral("0.000 N"));
}

TEST_F(ExpertsLabTest, ThePullsAddUpToNothing) {
  const auto pulls = pullsOf(lab.curves());
  ASSERT_EQ(pulls.size(), 4U);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < lab.curves().x.size(); ++i) {
    double sum = 0;
    bool all = true;
    for (const auto& pull : pulls) {
      all = all && !std::isnan(pull[i]);
      sum += pull[i];
    }
    if (!all) continue;
    ++seen;
    EXPECT_NEAR(sum, 0, 1e-12) << lab.curves().x[i];
  }
  EXPECT_GT(seen, 100U);
}

TEST_F(ExpertsLabTest, AWeightOfOnesOwnMovesTheMeanTowardThatExpert) {
  const auto before = lab.curves();
  const auto pulls = pullsOf(before);
  lab.setWeight("S4", 3);
  EXPECT_EQ(lab.weights().policy, WeightPolicy::kTable);
  EXPECT_EQ(lab.weights().table.at("S1"), 1);
  ASSERT_TRUE(comesTrue([&] {
    return lab.built()->model.experts[3].weight == 3 && lab.curves().x == before.x &&
           lab.curves().mean[200].force_n != before.mean[200].force_n;
  }));
  // With weights 1 1 1 3 instead of 1 1 1 1 the mean moves by (3/6 - 1/4) / (1 - 1/4) = a third of S4's distance.
  const auto& after = lab.curves();
  for (std::size_t i = 0; i < after.x.size(); ++i) {
    bool all = true;
    for (const auto& expert : after.experts) all = all && expert[i].fired;
    if (!all) continue;
    EXPECT_NEAR(after.mean[i].force_n - before.mean[i].force_n, pulls[3][i] / 3, 1e-12) << after.x[i];
  }
}

TEST_F(ExpertsLabTest, TheLastWeightCannotBeTakenAway) {
  for (const char* id : {"S1", "S2", "S3"}) {
    lab.setWeight(id, 0);
    ASSERT_TRUE(comesTrue([&] { return data.settings().weights.table.at(id) == 0 && lab.built() != nullptr; }));
  }
  lab.setWeight("S4", 0);
  EXPECT_EQ(data.settings().weights.table.at("S4"), 1);
  lab.setWeight("S4", -1);
  EXPECT_EQ(data.settings().weights.table.at("S4"), 1);
}

TEST_F(ExpertsLabTest, DistancesAreThoseOfTheBuild) {
  Columns<DistanceRow> table;
  showDistances(table, lab.built().get());
  ASSERT_EQ(table.rowCount(), 4);
  EXPECT_TRUE(table.index(2, 2).data().toString().isEmpty());
  EXPECT_EQ(table.index(0, 3).data().toString(), table.index(3, 0).data().toString());
  const auto row = [](const std::string& expert) { return expert.back() - '1'; };  // S1 to S4
  ASSERT_EQ(lab.built()->influences.pairs.size(), 6U);
  for (const auto& pair : lab.built()->influences.pairs) {
    EXPECT_EQ(table.index(row(pair.first), row(pair.second)).data().toString(), forceText(pair.rms_n, "N"))
        << pair.first << pair.second;
  }
  EXPECT_EQ(table.headerData(3, Qt::Vertical, Qt::DisplayRole).toString(), QStringLiteral("S4"));
}

}  // namespace
}  // namespace tactus::workbench
