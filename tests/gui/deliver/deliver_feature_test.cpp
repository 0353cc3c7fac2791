#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/deliver/bundle_panel.h"
#include "app/workbench/deliver/readiness_panel.h"
#include "app/workbench/features/features.h"
#include "app/workbench/shell/panel_area.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class DeliverFeatureTest : public tests::ShownBench {
 protected:
  DeliverFeatureTest() : ShownBench(Stage::kDeliver) {}

  const ReadinessLine& line(ReadinessTopic topic) { return bench.readiness.lines()[static_cast<std::size_t>(topic)]; }
  QPushButton& makeButton() { return *bench.window.findChild<QPushButton*>(QStringLiteral("make_bundle")); }
  QPushButton* button(QWidget& in, const QString& text) {
    for (auto* one : in.findChildren<QPushButton*>()) {
      if (one->isVisible() && one->text() == text) return one;
    }
    return nullptr;
  }
  ReadinessRow& row(ReadinessTopic topic) {
    return *bench.window.findChildren<ReadinessRow*>()[static_cast<int>(topic)];
  }
  void waitForLint() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return bench.findings.isCurrent(); }, kPatience));
    settle();
  }
};

TEST_F(DeliverFeatureTest, AHoleStopsTheBundleUntilItIsAcceptedByName) {
  waitForLint();
  EXPECT_EQ(line(ReadinessTopic::kHoles).state, Readiness::kBlocks);
  EXPECT_FALSE(makeButton().isEnabled());
  auto* const accept = button(row(ReadinessTopic::kHoles), QStringLiteral("Accept"));
  ASSERT_NE(accept, nullptr);
  EXPECT_TRUE(accept->accessibleName().contains(QStringLiteral("Depth 5 to 6 mm")));
  QTest::mouseClick(accept, Qt::LeftButton);
  EXPECT_EQ(bench.edits.model().accepted_holes, (std::vector<std::string>{"depth 5 to 6 mm"}));
  waitForLint();
  EXPECT_EQ(line(ReadinessTopic::kHoles).state, Readiness::kReady);
  EXPECT_TRUE(makeButton().isEnabled());
  EXPECT_EQ(button(row(ReadinessTopic::kHoles), QStringLiteral("Accept")), nullptr);
  bench.edits.undo();
  waitForLint();
  EXPECT_FALSE(makeButton().isEnabled());
}

TEST_F(DeliverFeatureTest, EachLineLeadsToItsPlace) {
  waitForLint();
  // Two experts at far: 0.75 N and 0.25 N.
  EXPECT_TRUE(line(ReadinessTopic::kExpertsApart).sentence.endsWith(QStringLiteral("by up to 0.500 N.")))
      << line(ReadinessTopic::kExpertsApart).sentence.toStdString();
  QTest::mouseClick(button(row(ReadinessTopic::kExpertsApart), QStringLiteral("Show findings")), Qt::LeftButton);
  EXPECT_EQ(bench.window.stage(), Stage::kTune);
  EXPECT_TRUE(bench.panels.findings->isVisible());
  ASSERT_TRUE(bench.findings.chosen());
  EXPECT_EQ(bench.findings.findings()[*bench.findings.chosen()].finding.kind,
            elicitation::RuleFinding::Kind::kExpertsApart);
  bench.window.enter(Stage::kDeliver);
  settle();
  QTest::mouseClick(button(row(ReadinessTopic::kSignOff), QStringLiteral("Sign off…")), Qt::LeftButton);
  EXPECT_EQ(bench.window.stage(), Stage::kTune);
  settle();
  EXPECT_TRUE(bench.panels.history->isVisible());
}

TEST_F(DeliverFeatureTest, ABundleShowsTheErrorOfEachFile) {
  waitForLint();
  bench.readiness.acceptHole("depth 5 to 6 mm");
  bench.bundles.make(folder.path(QStringLiteral("bundle")));
  ASSERT_TRUE(QTest::qWaitFor([this] { return bench.bundles.doing() == BundleMaker::Doing::kNothing; }, 60'000));
  settle();
  auto* const table = bench.window.findChild<QTableView*>(QStringLiteral("bundle_files"));
  ASSERT_NE(table, nullptr);
  EXPECT_TRUE(table->isVisible());
  ASSERT_TRUE(bench.bundles.delivered());
  struct DeliveredModel {
    enum { kFile, kError };
  };
  EXPECT_EQ(table->model()->rowCount(), static_cast<int>(bench.bundles.delivered()->files.size()));
  EXPECT_EQ(table->model()->index(0, DeliveredModel::kFile).data().toString(), QStringLiteral("model.tactus.json"));
  EXPECT_EQ(table->model()->index(0, DeliveredModel::kError).data().toString(), QStringLiteral("0 N"));
  EXPECT_EQ(line(ReadinessTopic::kChecks).state, Readiness::kReady);
  EXPECT_NE(button(*bench.window.findChild<BundlePanel*>(), QStringLiteral("Open folder")), nullptr);
}

TEST_F(DeliverFeatureTest, ABundleThatIsNotMadeSaysWhyAndOffersAnotherFolder) {
  waitForLint();
  bench.readiness.acceptHole("depth 5 to 6 mm");
  QFile other(folder.path(QStringLiteral("other.txt")));
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  bench.bundles.make(folder.path({}));  // not empty
  ASSERT_TRUE(QTest::qWaitFor([this] { return bench.bundles.doing() == BundleMaker::Doing::kNothing; }, 60'000));
  settle();
  auto* const panel = bench.window.findChild<BundlePanel*>();
  auto* const act = button(*panel, QStringLiteral("Choose another folder…"));
  ASSERT_NE(act, nullptr);
  EXPECT_TRUE(bench.bundles.failure().startsWith(QStringLiteral("The bundle was not made. ")));
  QObject::disconnect(panel, &BundlePanel::wanted, nullptr, nullptr);  // no dialog of files here
  const QSignalSpy wanted(panel, &BundlePanel::wanted);
  act->click();
  EXPECT_EQ(wanted.count(), 1);
}

}  // namespace
}  // namespace tactus::workbench
