// S4's rule base from Table A2, filled in by mouse and keys; the esophagus split; everything undone again.
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/editing/rule_edits.h"
#include "app/figures/force_curves.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

// Table A2 in the rows of the grids, as number keys; `-` skips the oropharynx, which it does not have.
constexpr const char* kAnswers[9] = {
    "45-554",  // lubrication poor
    "12-242",  // medium
    "12-231",  // well
    "13-332",  // neck flexion small
    "13-332",  // medium
    "13-453",  // large
    "13-321",  // speed slow
    "24-442",  // medium
    "35-554",  // fast
};

struct GivenReading {
  double depth_mm;
  double force_n;
};

// Force of S4 at lubrication 1, neck flexion 60 deg, speed 50 mm/s: exact integration in a program of another author,
// to five digits.
constexpr GivenReading kPublished[] = {{0, .12667},   {30, .12667},  {60, .12667},  {70, .33765},  {80, .45},
                                       {120, .45},    {139, .5},     {145, .49428}, {150, .47875}, {160, .46882},
                                       {170, .46797}, {185, .46797}, {200, .58944}, {215, .54365}, {420, .54365},
                                       {440, .46445}, {460, .25657}, {600, .25657}};

fuzzy::ForceModel withoutRules() {
  fuzzy::ForceModel model = support::s4AsPrinted();
  model.created_utc = "2026-11-21T08:00:00Z";
  model.generator = "tactus tests";
  model.experts[0].rules.clear();
  return model;
}

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  return file.readAll();
}

class S4ByHand : public testing::Test {
 protected:
  void SetUp() override {
    path = folder.write(withoutRules());
    start = bytesOf(path);
    models.open(path);
    editor.resize(590, 570);
    editor.show();
    grids = editor.findChild<RuleGrids*>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return rules.selected().has_value(); }, kPatience));
    QCoreApplication::processEvents();
  }

  void fillIn() {
    QTest::mouseClick(grids, Qt::LeftButton, {}, grids->cellRect({0, 0, 0}).center());
    for (const char* row : kAnswers) {
      for (const char* key = row; *key != '\0'; ++key) {
        QTest::keyClick(grids, *key == '-' ? Qt::Key_Space : static_cast<Qt::Key>(*key));
      }
    }
  }

  void splitTheEsophagus() {
    GhostController ghost(edits, scene);
    MembershipEditor terms_editor(edits, terms, scene, ghost);
    terms_editor.resize(720, 560);
    terms_editor.show();
    terms.setVariable("depth");
    QCoreApplication::processEvents();
    for (auto* more : terms_editor.findChildren<QToolButton*>()) {
      if (more->accessibleName() == QStringLiteral("More for esophagus"))
        more->findChild<QMenu*>()->actions()[0]->trigger();
    }
    auto* form = terms_editor.findChild<PopupForm*>();
    ASSERT_NE(form, nullptr);
    auto* cuts = form->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
    cuts->selectAll();
    QTest::keyClicks(cuts, QStringLiteral("290, 365"));
    QTest::keyClick(cuts, Qt::Key_Return);
  }

  figures::ForceCurves curvesOf(const fuzzy::ForceModel& model) const {
    return figures::computeCurves(model, fuzzy::compile(model).value(), 2, std::vector<double>{1, 60, 0, 50});
  }

  tests::ModelFolder folder;
  QString path;
  QByteArray start;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  TermController terms{edits};
  Selection selection{edits};
  RuleController rules{edits, scene, selection};
  RuleEditor editor{rules};
  RuleGrids* grids = nullptr;
};

TEST_F(S4ByHand, TheCurvesAreThoseOfTableA2BitForBit) {
  fillIn();
  const fuzzy::ForceModel wanted = support::s4AsPrinted();
  ASSERT_EQ(rules.expert().rules.size(), 45U);
  for (const fuzzy::Rule& rule : wanted.experts[0].rules) {
    EXPECT_TRUE(std::any_of(rules.expert().rules.begin(), rules.expert().rules.end(),
                            [&](const fuzzy::Rule& one) { return one == editing::inOrderOfInputs(wanted, rule); }));
  }
  const figures::ForceCurves by_hand = curvesOf(edits.model());
  const figures::ForceCurves golden = curvesOf(wanted);
  ASSERT_EQ(by_hand.x, golden.x);
  for (std::size_t i = 0; i < golden.x.size(); ++i) {
    ASSERT_EQ(by_hand.mean[i].fired, golden.mean[i].fired) << golden.x[i];
    ASSERT_EQ(by_hand.mean[i].force_n, golden.mean[i].force_n) << golden.x[i];
  }
}

TEST_F(S4ByHand, TheForcesAreThePublishedOnes) {
  fillIn();
  const auto compiled = fuzzy::compile(edits.model()).value();
  for (const GivenReading& reading : kPublished) {
    const auto force = compiled.evaluate(std::vector<double>{1, 60, reading.depth_mm, 50});
    EXPECT_TRUE(force.fired);
    EXPECT_NEAR(force.force_n, reading.force_n, 5.1e-6) << reading.depth_mm << " mm";  // half a unit of the last digit
  }
  for (const double hole_mm : {125.0, 130.0, 137.0}) {
    EXPECT_FALSE(compiled.evaluate(std::vector<double>{1, 60, hole_mm, 50}).fired) << hole_mm << " mm";
  }
}

TEST_F(S4ByHand, UndoLeadsBackToTheStartBitForBit) {
  fillIn();
  const fuzzy::ForceModel filled = edits.model();
  splitTheEsophagus();
  EXPECT_EQ(edits.model().inputs[2].terms.size(), 8U);
  EXPECT_EQ(rules.expert().rules.size(), 45U + 2 * 9U) << "the nine rules of the esophagus are copied to three parts";
  ASSERT_EQ(rules.grids()[0].cells.columns.size(), 8U);
  EXPECT_EQ(rules.cell({0, 2, 4}).then, "medium");
  EXPECT_EQ(rules.cell({0, 2, 6}).then, "medium");

  EXPECT_EQ(edits.history().line().size(), 1U + 45U + 1U);
  edits.undo();
  EXPECT_TRUE(editing::sameBits(edits.model(), filled));
  while (edits.canUndo()) edits.undo();
  EXPECT_TRUE(rules.expert().rules.empty());
  EXPECT_FALSE(models.isModified());
  models.saveAs(folder.path(QStringLiteral("undone.tactus.json")));
  EXPECT_EQ(bytesOf(folder.path(QStringLiteral("undone.tactus.json"))), start);
  while (edits.canRedo()) edits.redo();
  EXPECT_EQ(rules.expert().rules.size(), 63U);
}

}  // namespace
}  // namespace tactus::workbench
