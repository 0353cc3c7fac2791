#include "app/workbench/tune/findings/findings_controller.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/editing/rule_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using FindingKind = elicitation::RuleFinding::Kind;

using tests::kDepth;
using tests::kPatience;
const editing::VertexPlace kNearFoot{{"depth", ""}, "near", 3};

class FindingsControllerTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  [[nodiscard]] bool waitForFindings() {
    return QTest::qWaitFor([&] { return findings.isCurrent(); }, kPatience);
  }
  [[nodiscard]] bool waitForFixes() {
    return QTest::qWaitFor([&] { return findings.isCurrent() && !findings.isLookingForFixes(); }, kPatience);
  }

  std::size_t indexOf(FindingKind kind, const QString& who) const {
    const auto& all = findings.findings();
    const auto it = std::find_if(all.begin(), all.end(), [&](const ShownFinding& shown) {
      return shown.finding.kind == kind && shown.who == who;
    });
    EXPECT_NE(it, all.end());
    return static_cast<std::size_t>(it - all.begin());
  }

  /// Index of the fix whose button begins with `start`.
  std::size_t fixOf(const QString& start) const {
    const auto& all = findings.fixes();
    const auto it = std::find_if(all.begin(), all.end(), [&](const auto& fix) { return fix.text.startsWith(start); });
    EXPECT_NE(it, all.end()) << start.toStdString();
    return static_cast<std::size_t>(it - all.begin());
  }

  void moveBoundary(double to_mm) { ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearFoot, to_mm))); }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  FindingsController findings{edits, scene};
};

TEST_F(FindingsControllerTest, FixesAreComputedOnlyWhileThePanelIsVisible) {
  moveBoundary(5.5);
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(*findings.lintedModel(), edits.model());
  ASSERT_FALSE(findings.findings().empty());
  findings.choose(0);
  EXPECT_FALSE(findings.isLookingForFixes());
  EXPECT_TRUE(findings.fixes().empty());
  findings.setWatched(true);
  EXPECT_TRUE(findings.isLookingForFixes());
  ASSERT_TRUE(waitForFixes());
}

// A vertical edge is a step of the force that was not there before; a move of the boundary makes nothing new.
TEST_F(FindingsControllerTest, CountsWhatTheLastEditAdded) {
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(findings.added(), 0U);
  const auto before = findings.findings().size();
  moveBoundary(5.5);
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(findings.added(), findings.findings().size() - before);
  const auto with_edit = findings.findings().size();
  moveBoundary(5.4);
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(findings.added(), 0U) << findings.findings().size() << " after " << with_edit;
  edits.undo();
  edits.undo();
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(findings.added(), 0U);
}

TEST_F(FindingsControllerTest, MostNewtonsFirst) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  double last_n = 1e9;
  for (const ShownFinding& shown : findings.findings()) {
    EXPECT_LE(shown.finding.newtons.value_or(-1), last_n);
    last_n = shown.finding.newtons.value_or(-1);
    EXPECT_FALSE(shown.sentence.isEmpty());
  }
  // Expert A has no rule from 5 to 6 mm; beside it a fast tube gives 0.75 N. Around that force
  // sqrt(0.04^2 + (0.12 * 0.75)^2) = 0.0985 N is just noticeable.
  const ShownFinding& hole = findings.findings()[indexOf(FindingKind::kHole, QStringLiteral("A"))];
  EXPECT_DOUBLE_EQ(*hole.finding.newtons, 0.75);
  EXPECT_NEAR(*hole.noticeable, 0.75 / std::hypot(0.04, 0.12 * 0.75), 1e-9);
  EXPECT_EQ(hole.sentence, QStringLiteral("No rule fires: Depth 5 to 6 mm"));
}

TEST_F(FindingsControllerTest, AChosenFindingMovesTheOperatingPoint) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  QSignalSpy looked(&findings, &FindingsController::lookedAt);
  findings.choose(indexOf(FindingKind::kHole, QStringLiteral("A")));
  EXPECT_GE(scene.value(kDepth), 5);
  EXPECT_LE(scene.value(kDepth), 6);
  EXPECT_FALSE(scene.reading().experts[0].fired);
  ASSERT_EQ(looked.count(), 1);
  EXPECT_EQ(looked[0][0].toString(), QStringLiteral("A"));
  EXPECT_EQ(looked[0][1].toString(), QStringLiteral("depth"));
  // Where the jump begins there is a force: the one at stake.
  findings.goTo(true);
  EXPECT_TRUE(scene.reading().experts[0].fired);
  EXPECT_DOUBLE_EQ(scene.reading().experts[0].force_n, 0.75);
}

TEST_F(FindingsControllerTest, AFixIsOneEntryOfTheUndoList) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  findings.choose(indexOf(FindingKind::kHole, QStringLiteral("Mean")));
  ASSERT_TRUE(waitForFixes());
  const std::size_t near = fixOf(QStringLiteral("Stretch Near"));
  EXPECT_FALSE(findings.fixes()[near].effect.isEmpty());
  ASSERT_TRUE(findings.apply(near));
  // Its edge became the left edge of Far: down from 6 to 7 mm.
  EXPECT_EQ(edits.model().inputs[kDepth].terms[0].points, (std::vector<double>{0, 0, 6, 7}));
  EXPECT_EQ(edits.history().line().size(), 2U);
  EXPECT_FALSE(findings.isCurrent());
  ASSERT_TRUE(waitForFindings());
  for (const auto& shown : findings.findings()) {
    EXPECT_FALSE(shown.finding.kind == FindingKind::kHole && shown.who != QStringLiteral("B"));
  }
  EXPECT_FALSE(findings.chosen().has_value());
  edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(FindingsControllerTest, AFixOfAnOlderModelIsNotCarriedOut) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  findings.choose(indexOf(FindingKind::kHole, QStringLiteral("Mean")));
  ASSERT_TRUE(waitForFixes());
  ASSERT_FALSE(findings.fixes().empty());
  const QSignalSpy refused(&edits, &EditController::refused);
  moveBoundary(5.5);
  const auto model = edits.model();
  EXPECT_FALSE(findings.apply(0));
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(edits.model(), model);

  // Nor one of the model before a drag that goes on.
  ASSERT_TRUE(waitForFixes());
  edits.begin();
  EXPECT_FALSE(findings.apply(0));
  edits.update(editing::moveVertex(edits.base(), kNearFoot, 5.7));
  EXPECT_FALSE(findings.apply(0));
  edits.cancel();
}

TEST_F(FindingsControllerTest, ADragIsLintedWhenItEnds) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  edits.begin();
  edits.update(editing::moveVertex(edits.base(), kNearFoot, 5.7));
  EXPECT_FALSE(findings.isCurrent());
  edits.commit();
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(*findings.lintedModel(), edits.model());
  // A drag that comes back leaves the findings as they are.
  const auto* const lint = findings.lint();
  edits.begin();
  edits.update(editing::moveVertex(edits.base(), kNearFoot, 5.2));
  edits.cancel();
  EXPECT_TRUE(findings.isCurrent());
  EXPECT_EQ(findings.lint(), lint);
}

TEST_F(FindingsControllerTest, OfManyEditsTheLastOneIsLinted) {
  findings.setWatched(true);
  for (int i = 0; i < 50; ++i) moveBoundary(5 + i * 0.01);
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(*findings.lintedModel(), edits.model());
  EXPECT_EQ(findings.lintedModel()->inputs[kDepth].terms[0].points[3], 5.49);
}

TEST_F(FindingsControllerTest, TheChoiceStaysWithItsFinding) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  findings.choose(indexOf(FindingKind::kHole, QStringLiteral("A")));
  ASSERT_TRUE(edits.apply(editing::setExpertWeight(edits.model(), "B", 0.5)));
  ASSERT_TRUE(waitForFixes());
  ASSERT_TRUE(findings.chosen().has_value());
  EXPECT_EQ(findings.findings()[*findings.chosen()].who, QStringLiteral("A"));
  EXPECT_FALSE(findings.fixes().empty());
}

TEST_F(FindingsControllerTest, AnAcceptedHoleStandsQuietAtTheEnd) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  findings.choose(indexOf(FindingKind::kHole, QStringLiteral("Mean")));
  ASSERT_TRUE(waitForFixes());
  ASSERT_TRUE(findings.apply(fixOf(QStringLiteral("Accept"))));
  ASSERT_TRUE(waitForFindings());
  // Expert A has the same hole.
  const auto& all = findings.findings();
  ASSERT_GE(all.size(), 2U);
  EXPECT_EQ(all[all.size() - 1].acceptance, Acceptance::kAccepted);
  EXPECT_EQ(all[all.size() - 2].acceptance, Acceptance::kAccepted);
  EXPECT_EQ(all.front().acceptance, Acceptance::kNone);

  findings.choose(all.size() - 1);
  ASSERT_TRUE(waitForFixes());
  ASSERT_TRUE(findings.apply(fixOf(QStringLiteral("Take the acceptance back"))));
  EXPECT_TRUE(edits.model().accepted_holes.empty());
}

TEST_F(FindingsControllerTest, AnAcceptanceLapsesWithItsBoundary) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  findings.choose(indexOf(FindingKind::kHole, QStringLiteral("Mean")));
  ASSERT_TRUE(waitForFixes());
  ASSERT_TRUE(findings.apply(fixOf(QStringLiteral("Accept"))));
  moveBoundary(5.5);
  ASSERT_TRUE(waitForFindings());
  EXPECT_EQ(findings.findings()[indexOf(FindingKind::kHole, QStringLiteral("A"))].acceptance, Acceptance::kNone);
  ASSERT_EQ(findings.findings().back().acceptance, Acceptance::kLapsed);
  EXPECT_TRUE(findings.findings().back().sentence.contains(QStringLiteral("depth 5 to 6 mm")));

  findings.choose(findings.findings().size() - 1);
  ASSERT_TRUE(waitForFixes());
  ASSERT_EQ(findings.fixes().size(), 1U);
  ASSERT_TRUE(findings.apply(0));
  EXPECT_TRUE(edits.model().accepted_holes.empty());
}

TEST_F(FindingsControllerTest, AnotherModelBeginsAnew) {
  findings.setWatched(true);
  ASSERT_TRUE(waitForFindings());
  findings.choose(0);
  models.reopen();
  EXPECT_TRUE(findings.findings().empty());
  EXPECT_FALSE(findings.chosen().has_value());
  ASSERT_TRUE(waitForFindings());
  EXPECT_FALSE(findings.findings().empty());
}

}  // namespace
}  // namespace tactus::workbench
