#include "app/workbench/understand/here/rule_panel.h"

#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <gtest/gtest.h>

#include "app/editing/rule_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/tune/history/compare_controller.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class RulePanelTest : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(tests::twoExperts()));
    panel.resize(600, 300);
    panel.show();
  }

  QComboBox& who() { return *panel.findChild<QComboBox*>(); }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  Selection selection{edits};
  RulePanel panel{scene, selection};
};

TEST_F(RulePanelTest, WhoIsLookedAtStays) {
  EXPECT_EQ(who().currentText(), QStringLiteral("Mean"));
  who().setCurrentIndex(2);
  emit who().activated(2);
  // A weight in the mean is another frame for the plots.
  ASSERT_TRUE(edits.apply(editing::setExpertWeight(edits.model(), "A", 0.5)));
  EXPECT_EQ(who().currentText(), QStringLiteral("B"));
  CompareController compare(models, edits);
  compare.choose(CompareSide::kB, {CompareChoice::Kind::kExpert, 0, "A"});
  compare.show(CompareSide::kB);
  EXPECT_EQ(who().currentText(), QStringLiteral("B"));
  compare.end();
  EXPECT_EQ(who().currentText(), QStringLiteral("B"));

  auto model = tests::twoExperts();
  model.experts[1].id = "C";
  models.open(folder.write(model, QStringLiteral("other.tactus.json")));
  EXPECT_EQ(who().currentText(), QStringLiteral("Mean"));
}

TEST_F(RulePanelTest, FourInputsFitAWindowOf1280Pixels) {
  panel.resize(590, 300);  // what is left of it beside the editors
  models.open(folder.write(support::s4AsPrinted(), QStringLiteral("s4.tactus.json")));
  scene.setValue(2, 300);
  const auto* bar = panel.findChild<QScrollArea*>()->horizontalScrollBar();
  const auto* flow = panel.findChild<RuleFlow*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return flow->isVisible() && flow->minimumSizeHint().width() > 300; }, kPatience));
  EXPECT_EQ(bar->maximum(), 0);
  who().setCurrentIndex(0);
  emit who().activated(0);
  QCoreApplication::processEvents();
  EXPECT_EQ(bar->maximum(), 0);
}

}  // namespace
}  // namespace tactus::workbench
