// The labs' widgets with the demo's study: what the user clicks becomes a setting or a record.
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/experts/experts_lab_view.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/force/force_terms_view.h"
#include "app/workbench/labs/force/judgement_grid.h"
#include "app/workbench/labs/force/judgement_view.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/method/method_lab.h"
#include "app/workbench/labs/method/method_lab_view.h"
#include "app/workbench/labs/rules/grids_view.h"
#include "app/workbench/labs/rules/rules_lab_view.h"
#include "app/workbench/plot/chart.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

struct CellTable {
  enum { kExpert, kWord, kFelt, kFromMean };
  static constexpr int kOrderRole = workbench::kOrderRole;
};
struct WeightTable {
  enum { kExpert, kWeight };
};

class LabViews : public testing::Test {
 protected:
  void SetUp() override { study.open(path); }
  void show(QWidget& view) {
    view.resize(1180, 640);
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  }
  /// Chooses the entry `text` of the menu that `owner` has opened.
  static bool pick(QWidget& owner, const QString& text) {
    auto* const menu = owner.findChild<QMenu*>();
    if (menu == nullptr) return false;
    for (QAction* action : menu->actions()) {
      if (action->text() != text) continue;
      action->trigger();
      menu->close();
      return true;
    }
    return false;
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  StudyConnection study;
  LabData data{study};
  LabModel model{data};
  Corrections corrections{data};
  SettingsPrice price{data};
};

// The words of before stay beside those of the other way, in its plot alone.
TEST_F(LabViews, AnotherWayToTheWordsShowsThoseOfBefore) {
  ForceLab lab(data, model, corrections);
  ForceLabView view(lab, price);
  price.setSeen(true);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return view.votes().table().rowCount() >= 11; }));
  const auto others = [&] {
    std::vector<elicitation::ForceTermsFrom> out;
    for (const auto from : kForceMethods) {
      if (view.terms().plot(from).hasGhosts()) out.push_back(from);
    }
    return out;
  };
  EXPECT_TRUE(others().empty());
  const auto now = lab.settings().force_terms;
  const auto other = now == kForceMethods.front() ? kForceMethods[1] : kForceMethods.front();
  lab.setMethod(other);
  ASSERT_TRUE(comesTrue([&] { return others() == std::vector{other}; }));
  // Taken back, or another change where the test was slow: nothing beside the other way.
  lab.setMethod(now);
  EXPECT_TRUE(comesTrue([&] { return others().empty() || others() == std::vector{now}; }));
}

TEST_F(LabViews, AForceLeadsToItsJudgementsAndAWordIsCorrectedThere) {
  ForceLab lab(data, model, corrections);
  ForceLabView view(lab, price);
  show(view);
  const VoteTable& table = view.votes().table();
  ASSERT_TRUE(comesTrue([&] { return table.rowCount() >= 11; }));
  emit view.votes().forceChosen(0.3);
  QTableView& judgements = view.judgements().table();
  const JudgementGrid& grid = view.judgements().grid();
  ASSERT_TRUE(comesTrue([&] { return grid.rowCount() == 4; }));
  emit view.votes().forceChosen(0.3);
  EXPECT_EQ(judgements.currentIndex().column(), grid.columnOf(0.3));

  const QModelIndex cell = judgements.currentIndex();
  const QString before = cell.data().toString();
  const QString wanted = before == QStringLiteral("Large") ? QStringLiteral("Medium") : QStringLiteral("Large");
  emit judgements.doubleClicked(cell);
  ASSERT_TRUE(pick(judgements, wanted));
  ASSERT_TRUE(comesTrue([&] { return grid.index(cell.row(), cell.column()).data().toString() == wanted; }));
  EXPECT_TRUE(grid.index(cell.row(), cell.column()).data(Qt::ToolTipRole).toString().contains(before));
  corrections.undo();
  EXPECT_TRUE(comesTrue([&] { return grid.index(cell.row(), cell.column()).data().toString() == before; }));
}

TEST_F(LabViews, InASmallWindowTheReasonsGiveWayToTheWords) {
  ForceLab lab(data, model, corrections);
  ForceLabView view(lab, price);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return view.votes().table().rowCount() >= 11; }));
  auto* const votes = view.votes().findChild<QTableView*>();
  const int reasons = view.votes().table().reasonColumn();
  for (const auto& [size, hidden] :
       {std::pair(QSize(1168, 600), true), std::pair(QSize(1808, 960), false), std::pair(QSize(1168, 600), true)}) {
    view.resize(size);
    ASSERT_TRUE(comesTrue([&] { return votes->isColumnHidden(reasons) == hidden; })) << size.width();
    // The pictures stand side by side on one line, so that they can be compared.
    const ForceTermsPlot& first = view.terms().plot(kForceMethods.front());
    for (const auto from : kForceMethods) {
      const ForceTermsPlot& one = view.terms().plot(from);
      EXPECT_EQ(one.mapTo(&view, QPoint()).y(), first.mapTo(&view, QPoint()).y()) << methodName(from).toStdString();
      EXPECT_EQ(one.height(), first.height());
      EXPECT_GE(one.width(), 160);
    }
  }
}

TEST_F(LabViews, TheRoundButtonChoosesTheWayOfTheModel) {
  ForceLab lab(data, model, corrections);
  ForceLabView view(lab, price);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return !lab.votes().steps.empty(); }));
  const auto choices = view.findChildren<QRadioButton*>();
  ASSERT_EQ(choices.size(), 4);
  ASSERT_TRUE(comesTrue([&] { return choices[0]->isChecked() && choices[3]->isEnabled(); }));
  choices[1]->click();
  EXPECT_EQ(data.settings().force_terms, elicitation::ForceTermsFrom::kFrequency);
  choices[3]->click();
  EXPECT_EQ(data.settings().force_terms, elicitation::ForceTermsFrom::kProbit);
}

TEST_F(LabViews, TheCornersOfTheWordsFitWhereTheLabIsNarrow) {
  ForceLab lab(data, model, corrections);
  ForceLabView view(lab, price);
  show(view);
  const auto corners = [&view] {
    QList<QLabel*> out;
    for (QLabel* label : view.terms().findChildren<QLabel*>()) {
      if (label->text().startsWith(QStringLiteral("VS "))) out << label;
    }
    return out;
  };
  ASSERT_TRUE(comesTrue([&] { return corners().size() == 4; }));
  for (const int width : {1700, 1100}) {
    view.resize(width, 560);
    QCoreApplication::processEvents();
    for (const QLabel* label : corners()) {
      EXPECT_LE(label->fontMetrics().size(0, label->text()).width(), label->width()) << width;
    }
  }
  // The hint has all decimals of the vote's first ramp.
  EXPECT_TRUE(corners().front()->toolTip().startsWith(QStringLiteral("VS  0 · 0 · 0.2 · 0.3")));
}

TEST_F(LabViews, AHiddenLabComputesNothing) {
  ForceLab lab(data, model, corrections);
  ForceLabView view(lab, price);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return !lab.votes().steps.empty() && !lab.work().isBusy(); }));
  view.hide();
  data.setSettings(data.settings());
  EXPECT_FALSE(lab.work().isBusy());
}

TEST_F(LabViews, ADoubleClickInAGridCorrectsTheAnswer) {
  RulesLab lab(model, corrections);
  RulesLabView view(lab);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return lab.conflicts() != nullptr && !lab.work().isBusy(); }));
  GridsView& grids = view.grids();
  ASSERT_TRUE(comesTrue([&] { return !lab.grids().rows.empty(); }));
  // With the keyboard: to the first cell of the first expert, then its menu.
  grids.setFocus();
  QTest::keyClick(&grids, Qt::Key_Up);
  ASSERT_TRUE(lab.chosen());
  const GridPlace place = *lab.chosen();
  const AskedCell cell = lab.grids().at(0, place.row, place.column);
  ASSERT_TRUE(cell.word && cell.record);
  QTest::keyClick(&grids, Qt::Key_Return);
  ASSERT_TRUE(pick(grids, QStringLiteral("cannot tell")));
  EXPECT_TRUE(comesTrue([&] { return !lab.grids().at(0, place.row, place.column).word; }));
}

TEST_F(LabViews, AClickOnAHeadSortsTheExpertsOfACellByTheirDistanceFromTheMean) {
  RulesLab lab(model, corrections);
  RulesLabView view(lab);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return lab.chosen() && lab.influenceOf(0).has_value(); }));
  const auto tables = view.findChildren<QTableView*>();
  const auto table = std::find_if(tables.begin(), tables.end(), [](const QTableView* one) {
    return one->accessibleName() == QStringLiteral("Experts in the chosen cell");
  });
  ASSERT_NE(table, tables.end());
  const QAbstractItemModel& rows = *(*table)->model();
  ASSERT_EQ(rows.rowCount(), 4);
  EXPECT_TRUE(rows.index(0, CellTable::kExpert).data().toString().startsWith(QStringLiteral("S1")));
  (*table)->sortByColumn(CellTable::kFromMean, Qt::DescendingOrder);
  double before = 10;
  for (int row = 0; row < 4; ++row) {
    const double distance = rows.index(row, CellTable::kFromMean).data(CellTable::kOrderRole).toDouble();
    EXPECT_LE(distance, before) << row;
    before = distance;
  }
}

TEST_F(LabViews, AWeightIsTypedIntoTheTable) {
  ExpertsLab lab(data, model);
  ExpertsLabView view(lab);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return view.weights().rowCount() == 4; }));
  Columns<WeightRow>& table = view.weights();
  EXPECT_TRUE(table.setData(table.index(1, WeightTable::kWeight), QStringLiteral("2,5"), Qt::EditRole));
  EXPECT_EQ(data.settings().weights.table.at("S2"), 2.5);
  EXPECT_FALSE(table.setData(table.index(1, WeightTable::kWeight), QStringLiteral("many"), Qt::EditRole));
  EXPECT_TRUE(
      comesTrue([&] { return table.index(1, WeightTable::kWeight).data().toString() == QStringLiteral("2.5"); }));
}

TEST_F(LabViews, WordsAndRulesAreComparedWhileTheirPageIsShown) {
  ExpertsLab lab(data, model);
  ExpertsLabView view(lab);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return view.weights().rowCount() == 4; }));
  EXPECT_EQ(lab.wordsAndRules().value(), nullptr);
  auto* const page = view.findChild<WordsAndRulesView*>();
  ASSERT_NE(page, nullptr);
  auto* const pages = view.findChild<QTabWidget*>();
  pages->setCurrentWidget(page);
  ASSERT_TRUE(comesTrue([&] { return page->table().rowCount() == 2; }));
  const elicitation::WordsAndRules& found = *lab.wordsAndRules().value();
  EXPECT_EQ(found.participants.size(), 4U);
  EXPECT_EQ(page->sentence(), wordsAndRulesText(found));
  EXPECT_TRUE(page->table().row(0).shared_rules.startsWith(QStringLiteral("0"))) << "one model has one force";
  pages->setCurrentIndex(0);
  EXPECT_FALSE(lab.wordsAndRules().isHeld());
}

TEST_F(LabViews, TheForcesThatEachPersonCalledByAWordAreDrawnWithTheirAgreement) {
  ForceLab lab(data, model, corrections);
  ForceLabView view(lab, price);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return !lab.votes().intervals.empty(); }));
  ASSERT_TRUE(comesTrue([&] { return view.intervals().chart().legend().size() == 4; }));
  EXPECT_TRUE(view.intervals().summary().contains(QStringLiteral("3 of 3"))) << "of the lowest word, in Table 2";
  view.intervals().setIntervals(lab.votes().words, {}, 1.1);
  EXPECT_TRUE(view.intervals().summary().startsWith(QStringLiteral("No force")));
  EXPECT_TRUE(view.intervals().chart().legend().empty());
}

TEST_F(LabViews, OneButtonComparesTheChoicesAndAClickShowsTwoCurves) {
  MethodLab lab(data);
  MethodLabView view(lab);
  show(view);
  ASSERT_TRUE(comesTrue([&] { return view.button().isEnabled(); }));
  QTest::mouseClick(&view.button(), Qt::LeftButton);
  ASSERT_TRUE(comesTrue([&] { return view.button().text() == QStringLiteral("Cancel"); }));
  const QAbstractItemModel& factors = *view.factorView().model();
  ASSERT_TRUE(comesTrue([&] { return factors.rowCount() >= 8; }));
  ASSERT_TRUE(comesTrue([&] { return lab.curves() != nullptr; })) << "the first row is chosen";
  const std::size_t first = *lab.chosen();
  QTest::mouseClick(view.factorView().viewport(), Qt::LeftButton, {},
                    view.factorView().visualRect(factors.index(1, 0)).center());
  ASSERT_TRUE(comesTrue([&] { return lab.curves() != nullptr && *lab.chosen() != first; }));
  ASSERT_TRUE(comesTrue([&] { return view.plot().legend().size() == 4; }));
}

}  // namespace
}  // namespace tactus::workbench
