#include "app/workbench/tune/tell/tell_controller.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/editing/rule_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "core/base/text.h"
#include "core/contracts/contract_check.h"

#include "tests/app/cli/run_program.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using Kind = CompareChoice::Kind;

class TellControllerTest : public testing::Test {
 protected:
  void open(const fuzzy::ForceModel& model) {
    path = folder.write(model);
    models.open(path);
  }
  /// A: the model as it was opened, B: as it is now.
  void compareWithFirst() {
    compare.choose(CompareSide::kA, {Kind::kState, 0, {}});
    compare.choose(CompareSide::kB, {Kind::kOpen, 0, {}});
  }
  bool search() {
    tell.hold(view);
    return tell.begin() &&
           QTest::qWaitFor([this] { return !tell.isBusy() && (tell.told() != nullptr || !tell.failure().isEmpty()); },
                           tests::kPatience);
  }
  nlohmann::json command(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "tell");
    arguments.emplace_back("--json");
    const cli::ProgramRun run(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out);
  }
  /// What the command says of the same pair.
  void expectSame(const nlohmann::json& json) {
    const contracts::TellingStroke& found = tell.told()->found;
    EXPECT_EQ(found.feel.rms_jnd, json["rms_jnd"].get<double>());
    EXPECT_EQ(found.feel.largest_n, json["largest_n"].get<double>());
    EXPECT_EQ(found.stroke.from_mm, json["stroke"]["from_mm"].get<double>());
    EXPECT_EQ(found.stroke.to_mm, json["stroke"]["to_mm"].get<double>());
    EXPECT_EQ(found.bound_jnd, json["bound_jnd"].get<double>());
    EXPECT_TRUE(tell.verdict().contains(QString::number(json["rms_jnd"].get<double>(), 'f', 2)))
        << tell.verdict().toStdString();
    EXPECT_TRUE(tell.bound().contains(QString::fromStdString(base::roundedNumber(json["bound_jnd"].get<double>()))))
        << tell.bound().toStdString();
  }

  tests::ModelFolder folder;
  QString path;
  ModelController models;
  EditController edits{models};
  CompareController compare{models, edits};
  TellController tell{compare, edits};
  QObject view;
};

TEST_F(TellControllerTest, FindsWhatTheCommandFinds) {
  open(support::s4FiveRegions());
  ASSERT_TRUE(edits.apply(editing::setConsequent(edits.model(), edits.model().experts[0].id, 27, "very_large")));
  compareWithFirst();
  ASSERT_TRUE(search());
  const QString after = folder.write(edits.model(), QStringLiteral("after.tactus.json"));
  expectSame(command({path.toStdString(), after.toStdString()}));
  EXPECT_TRUE(tell.verdict().startsWith(QStringLiteral("Felt: 3.02 JND"))) << tell.verdict().toStdString();
  EXPECT_TRUE(tell.details()[0].startsWith(QStringLiteral("Insertion from 125.0 to 155.0 mm, 120 mm/s")));
  // Neck flexion 90 degrees is the word large of the model.
  EXPECT_TRUE(tell.details()[1].contains(QStringLiteral("90 deg (Large)"), Qt::CaseInsensitive))
      << tell.details()[1].toStdString();

  // What is drawn is the stroke, and what is shaded is felt.
  const auto& moments = tell.told()->moments;
  EXPECT_EQ(moments.front().at.depth_mm, tell.told()->found.stroke.from_mm);
  EXPECT_DOUBLE_EQ(moments.back().at.depth_mm, tell.told()->found.stroke.to_mm);
  double largest_n = 0;
  for (const ToldMoment& one : moments) {
    const double difference_n = std::abs(one.b.force_n - one.a.force_n);
    largest_n = std::max(largest_n, difference_n);
    EXPECT_EQ(one.felt, difference_n >= contracts::justNoticeableDifference(one.a.force_n));
  }
  EXPECT_NEAR(largest_n, std::abs(tell.told()->found.feel.largest_n), 0.02);
}

TEST_F(TellControllerTest, OneExpertAloneIsComparedAsTheCommandDoes) {
  open(support::inventedExperts());
  compare.choose(CompareSide::kA, {Kind::kExpert, 0, "E1"});
  compare.choose(CompareSide::kB, {Kind::kExpert, 0, "S4"});
  ASSERT_TRUE(search());
  expectSame(command({path.toStdString(), path.toStdString(), "--expert-a", "E1", "--expert-b", "S4"}));
}

TEST_F(TellControllerTest, EqualModelsAreNoneFeltWithABound) {
  open(support::s4FiveRegions());
  compare.choose(CompareSide::kA, {Kind::kOpen, 0, {}});
  compare.choose(CompareSide::kB, {Kind::kState, 0, {}});
  ASSERT_TRUE(search());
  EXPECT_TRUE(tell.verdict().startsWith(QStringLiteral("None felt"))) << tell.verdict().toStdString();
  EXPECT_EQ(tell.bound(), QStringLiteral("At no place more than 0.02 JND, proved."));
  EXPECT_EQ(tell.told()->found.feel.rms_jnd, 0);
}

TEST_F(TellControllerTest, CancelEndsTheSearchAndAnEditMakesTheResultOld) {
  open(support::inventedExperts());
  ASSERT_TRUE(edits.apply(editing::setConsequent(edits.model(), "S4", 27, "very_large")));
  compareWithFirst();
  tell.hold(view);
  ASSERT_TRUE(tell.begin());
  EXPECT_TRUE(tell.isBusy());
  tell.cancel();
  EXPECT_FALSE(tell.isBusy());
  EXPECT_EQ(tell.told(), nullptr);
  ASSERT_TRUE(search());
  EXPECT_FALSE(tell.isOld());
  EXPECT_DOUBLE_EQ(tell.progress(), 1);
  edits.undo();
  EXPECT_TRUE(tell.isOld());
  EXPECT_NE(tell.told(), nullptr) << "it is still about its pair";
}

TEST_F(TellControllerTest, NobodyWhoWaitsMeansNoSearch) {
  open(support::inventedExperts());
  compare.choose(CompareSide::kA, {Kind::kExpert, 0, "E1"});
  ASSERT_TRUE(tell.begin());
  EXPECT_FALSE(tell.isBusy());
  tell.hold(view);
  EXPECT_TRUE(tell.isBusy());
  tell.hold(view, false);
  EXPECT_FALSE(tell.isBusy());
}

TEST_F(TellControllerTest, AModelWithoutAWayHasNoStroke) {
  auto model = tests::twoExperts();
  model.inputs[1].id = "angle";
  model.inputs[1].unit = "deg";
  for (auto& expert : model.experts) {
    for (auto& rule : expert.rules) {
      for (auto& condition : rule.conditions) {
        if (condition.input == "depth") condition.input = "angle";
      }
    }
  }
  open(model);
  compare.choose(CompareSide::kA, {Kind::kExpert, 0, "A"});
  ASSERT_TRUE(search());
  EXPECT_EQ(tell.told(), nullptr);
  EXPECT_TRUE(tell.failure().contains(QStringLiteral("no way of a tip"))) << tell.failure().toStdString();
}

}  // namespace
}  // namespace tactus::workbench
