// The contracts in the window: added from the menu, changed and removed, felt with one click.
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "app/editing/rule_edits.h"
#include "app/workbench/deliver/readiness.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/shell/panel_area.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class ContractsPanelTest : public tests::ShownBench {
 protected:
  ContractsPanelTest() : ShownBench(Stage::kTune) {}
  void SetUp() override {
    ShownBench::SetUp();
    bench.panels.contracts->reveal();
    settle();
  }

  template <class Part>
  Part* part(const char* name) const {
    return bench.window.findChild<Part*>(QLatin1String(name));
  }
  QAction* entry(QMenu& menu, const QString& start) const {
    emit menu.aboutToShow();
    for (QAction* action : menu.actions()) {
      if (action->text().remove(QLatin1Char('&')).startsWith(start)) return action;
    }
    return nullptr;
  }
  void add(const QString& start) {
    QAction* const action = entry(*part<QPushButton>("contracts_add")->menu(), start);
    ASSERT_NE(action, nullptr) << start.toStdString();
    action->trigger();
  }
  QDialog* form() const { return part<QDialog>("contract_form"); }
  void choose(const char* box, const QString& words) {
    auto* const choice = form()->findChild<QComboBox*>(QLatin1String(box));
    ASSERT_NE(choice, nullptr) << box;
    const int index = choice->findText(words);
    ASSERT_GE(index, 0) << words.toStdString();
    choice->setCurrentIndex(index);
    emit choice->activated(index);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  void take() {
    form()->findChild<QPushButton*>(QStringLiteral("contract_take"))->click();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  bool wait() {
    return QTest::qWaitFor([this] { return bench.contracts.isCurrent() && !bench.contracts.isBusy(); }, kPatience);
  }
};

TEST_F(ContractsPanelTest, ASuggestionIsOneClickAndOneUndo) {
  add(QStringLiteral("The model is never silent"));
  ASSERT_TRUE(wait());
  settle();
  EXPECT_EQ(part<QLabel>("contract_sentence")->text(),
            QStringLiteral("The model is never silent: some rule fires everywhere"));
  EXPECT_TRUE(part<QLabel>("contract_details")->text().startsWith(QStringLiteral("No rule fires at")));
  EXPECT_EQ(bench.panels.contracts->windowTitle(), QStringLiteral("Contracts (1 broken)"));
  bench.edits.undo();
  settle();
  EXPECT_EQ(bench.edits.model(), tests::twoExperts());
  EXPECT_EQ(bench.panels.contracts->windowTitle(), QStringLiteral("Contracts"));
}

TEST_F(ContractsPanelTest, OneClickFeelsWhereItIsBrokenAndAnotherTheOtherPlace) {
  // Near and slow says low, near and fast says high: more speed raises the force.
  add(QStringLiteral("More of an input"));
  ASSERT_NE(form(), nullptr);
  choose("contract_input", QStringLiteral("Speed"));
  take();
  ASSERT_TRUE(wait());
  settle();
  const ShownContract& shown = bench.contracts.shown()[0];
  ASSERT_EQ(shown.state, ContractState::kBroken);
  ASSERT_EQ(shown.places.size(), 2U);
  auto* const feel = part<QPushButton>("contract_feel");
  ASSERT_TRUE(feel->isVisible());
  QTest::mouseClick(feel, Qt::LeftButton);
  EXPECT_EQ(bench.scene.values(), shown.places[0]);
  EXPECT_EQ(bench.scene.xInput(), tests::kSpeed);
  EXPECT_TRUE(bench.panels.feel->isVisible());
  EXPECT_EQ(feel->text(), QStringLiteral("Feel the other place"));
  QTest::mouseClick(feel, Qt::LeftButton);
  EXPECT_EQ(bench.scene.values(), shown.places[1]);
}

TEST_F(ContractsPanelTest, ItIsChangedInPlainWordsAndRemoved) {
  add(QStringLiteral("The force is never above or below"));
  ASSERT_NE(form(), nullptr);
  form()->findChild<NumberBox*>(QStringLiteral("contract_limit"))->setValue(0.8);
  choose("contract_where_depth", QStringLiteral("Near"));
  take();
  ASSERT_TRUE(wait());
  settle();
  EXPECT_EQ(part<QLabel>("contract_sentence")->text(),
            QStringLiteral("The force is never above 0.8 N, where “Depth” is “Near”"));
  EXPECT_EQ(bench.contracts.shown()[0].state, ContractState::kProved);
  QMenu& menu = *part<QToolButton>("contract_change")->menu();
  entry(menu, QStringLiteral("Change"))->trigger();
  ASSERT_NE(form(), nullptr);
  choose("contract_kind", QStringLiteral("never below"));
  take();
  ASSERT_TRUE(wait());
  EXPECT_EQ(bench.contracts.shown()[0].state, ContractState::kBroken);
  EXPECT_EQ(bench.edits.model().contracts.size(), 1U);
  entry(menu, QStringLiteral("Remove"))->trigger();
  EXPECT_TRUE(bench.edits.model().contracts.empty());
  for (int i = 0; i < 3; ++i) bench.edits.undo();
  EXPECT_EQ(bench.edits.model(), tests::twoExperts());
}

TEST_F(ContractsPanelTest, EachKindHasAFormThatMakesItsSentence) {
  add(QStringLiteral("One word is never harder"));
  ASSERT_NE(form(), nullptr);
  take();
  add(QStringLiteral("The force never steps"));
  ASSERT_NE(form(), nullptr);
  choose("contract_unit", QStringLiteral("units of the force"));
  form()->findChild<NumberBox*>(QStringLiteral("contract_limit"))->setValue(0.05);
  take();
  ASSERT_TRUE(wait());
  settle();
  ASSERT_EQ(bench.contracts.shown().size(), 2U);
  EXPECT_EQ(bench.contracts.shown()[0].sentence, QStringLiteral("Depth: “Near” is never harder than “Far”"));
  EXPECT_EQ(bench.contracts.shown()[1].sentence,
            QStringLiteral("The force never changes by more than 0.05 N within 0.1 mm of “Depth”"));
}

TEST_F(ContractsPanelTest, ReadinessSaysWhatIsBroken) {
  const auto line = [this] { return bench.readiness.lines()[static_cast<std::size_t>(ReadinessTopic::kContracts)]; };
  EXPECT_EQ(line().state, Readiness::kReady);
  add(QStringLiteral("The model is never silent"));
  bench.window.enter(Stage::kDeliver);
  ASSERT_TRUE(QTest::qWaitFor([&] { return line().state == Readiness::kLook; }, kPatience));
  EXPECT_TRUE(line().sentence.startsWith(QStringLiteral("The model breaks 1 of 1 contract")));
}

}  // namespace
}  // namespace tactus::workbench
