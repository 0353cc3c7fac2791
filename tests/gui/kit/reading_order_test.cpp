
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/workbench/kit/layout.h"
#include "app/workbench/shell/main_window.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

std::string lettersOf(const QList<QWidget*>& stops) {
  std::string out;
  for (const QWidget* stop : stops) out += stop->objectName().toStdString();
  return out;
}

class ReadingOrder : public testing::Test {
 protected:
  QPushButton* button(const char* letter, QRect place, QWidget* parent) {
    auto* out = new QPushButton(parent);
    out->setObjectName(QLatin1String(letter));
    out->setGeometry(place);
    return out;
  }
  void show() {
    window.resize(300, 300);
    window.show();
    QCoreApplication::processEvents();
  }
  QWidget window;
};

TEST_F(ReadingOrder, RowsComeBeforeColumns) {
  // Made from the end to the beginning; the two of a row differ in height.
  button("f", {0, 200, 300, 20}, &window);
  button("e", {150, 102, 50, 24}, &window);
  button("d", {0, 100, 100, 30}, &window);
  button("a", {0, 0, 100, 20}, &window);
  button("b", {110, 4, 50, 8}, &window);
  button("c", {200, 0, 50, 20}, &window);
  show();
  EXPECT_EQ(lettersOf(readingOrder(window)), "abcdef");
}

TEST_F(ReadingOrder, AColumnIsReadToItsEnd) {
  // No line goes across both columns.
  button("d", {150, 0, 100, 60}, &window);
  button("e", {150, 70, 100, 60}, &window);
  button("a", {0, 0, 100, 30}, &window);
  button("b", {0, 40, 100, 40}, &window);
  button("c", {0, 90, 100, 40}, &window);
  show();
  EXPECT_EQ(lettersOf(readingOrder(window)), "abcde");
}

TEST_F(ReadingOrder, APartIsReadBeforeTheNextOne) {
  auto* right = new QWidget(&window);
  right->setGeometry(150, 0, 150, 100);
  auto* left = new QWidget(&window);
  left->setGeometry(0, 0, 150, 100);
  button("c", {0, 10, 50, 20}, right);
  button("a", {0, 0, 50, 20}, left);
  button("b", {0, 60, 50, 20}, left);
  show();
  EXPECT_EQ(lettersOf(readingOrder(window)), "abc");
}

TEST_F(ReadingOrder, LeavesOutWhatCannotBeReached) {
  button("a", {0, 0, 50, 20}, &window);
  button("b", {0, 30, 50, 20}, &window)->setEnabled(false);
  button("c", {0, 60, 50, 20}, &window)->setFocusPolicy(Qt::ClickFocus);
  button("d", {0, 90, 50, 20}, &window)->hide();
  auto* area = new QScrollArea(&window);
  area->setObjectName(QStringLiteral("s"));
  area->setGeometry(0, 120, 100, 100);
  auto* content = new QWidget;
  content->resize(50, 50);
  button("e", {0, 0, 50, 20}, content);
  area->setWidget(content);
  show();
  EXPECT_EQ(lettersOf(readingOrder(window)), "ae");
  content->resize(50, 400);
  QCoreApplication::processEvents();
  EXPECT_EQ(lettersOf(readingOrder(window)), "ase");
}

TEST_F(ReadingOrder, WhatGetsTheKeyboardIsScrolledIntoView) {
  QWidget* near = button("a", {0, 0, 50, 20}, &window);
  auto* area = new QScrollArea(&window);
  area->setGeometry(0, 30, 100, 100);
  area->setFocusPolicy(Qt::NoFocus);
  auto* content = new QWidget;
  content->resize(50, 400);
  QWidget* far = button("b", {0, 350, 50, 20}, content);
  area->setWidget(content);
  show();
  near->setFocus();
  ASSERT_TRUE(focusNextAsRead(window, true));
  EXPECT_EQ(window.focusWidget(), far);
  EXPECT_TRUE(area->viewport()->rect().contains(far->mapTo(area->viewport(), far->rect().center())));
  ASSERT_TRUE(focusNextAsRead(window, true));
  EXPECT_EQ(window.focusWidget()->objectName(), QStringLiteral("a"));
}

class KeyboardTest : public tests::ShownBench, public testing::WithParamInterface<Stage> {
 protected:
  KeyboardTest() : ShownBench(GetParam()) {}

  void SetUp() override {
    ShownBench::SetUp();
    for (QDockWidget* panel : bench.window.findChildren<QDockWidget*>()) {
      if (!panel->isHidden()) panels.push_back(panel);
    }
  }

  QDockWidget* panelOf(QWidget* widget) const {
    const auto found = std::find_if(panels.begin(), panels.end(),
                                    [widget](const QDockWidget* panel) { return panel->isAncestorOf(widget); });
    return found == panels.end() ? nullptr : *found;
  }

  std::vector<QDockWidget*> panels;
};

TEST_P(KeyboardTest, TabGoesThroughEveryPanelAndComesBack) {
  for (QDockWidget* front : panels) {
    front->raise();
    settle();
    ASSERT_FALSE(readingOrder(bench.window).isEmpty());
    // Of buttons that exclude each other only the one with the keyboard is a stop from then on; arrow keys do the rest.
    for (QWidget* stop : readingOrder(bench.window)) {
      if (!qobject_cast<StageButton*>(stop)) continue;
      stop->setFocus();
      break;
    }
    const QList<QWidget*> all = readingOrder(bench.window);
    all.front()->setFocus();
    QList<QWidget*> reached{all.front()};
    std::vector<QDockWidget*> entered;
    for (qsizetype i = 1; i < all.size(); ++i) {
      QTest::keyClick(bench.window.focusWidget(), Qt::Key_Tab);
      reached << bench.window.focusWidget();
      QDockWidget* const panel = panelOf(reached.back());
      if (panel && (entered.empty() || entered.back() != panel)) entered.push_back(panel);
    }
    EXPECT_EQ(reached, all) << front->windowTitle().toStdString();
    // Nobody has to come back to a panel for the rest of it.
    auto once = entered;
    std::sort(once.begin(), once.end());
    EXPECT_EQ(std::unique(once.begin(), once.end()), once.end()) << front->windowTitle().toStdString();
    QTest::keyClick(bench.window.focusWidget(), Qt::Key_Tab);
    EXPECT_EQ(bench.window.focusWidget(), all.front());
    QTest::keyClick(bench.window.focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(bench.window.focusWidget(), all.back());
  }
}

TEST_P(KeyboardTest, WhatTakesTheKeyboardHasAName) {
  for (QDockWidget* front : panels) {
    front->raise();
    settle();
    for (QWidget* stop : readingOrder(bench.window)) {
      // On Linux a box of choices tells its choice in the place of its name; its own one counts here.
      const bool choice = qobject_cast<QComboBox*>(stop) != nullptr;
      const QString told = QAccessible::queryAccessibleInterface(stop)->text(QAccessible::Name);
      EXPECT_FALSE((choice ? stop->accessibleName() : told).isEmpty())
          << stop->metaObject()->className() << " at " << stop->mapTo(&bench.window, QPoint()).x() << ", "
          << stop->mapTo(&bench.window, QPoint()).y() << ", " << stop->width() << " wide, beside "
          << front->windowTitle().toStdString();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Stages, KeyboardTest, testing::Values(Stage::kUnderstand, Stage::kTune),
                         [](const auto& stage) { return stageId(stage.param).toStdString(); });

TEST_F(ReadingOrder, ARowIsOneStopAndTheArrowsGoAlongIt) {
  QList<QWidget*> row{button("a", {0, 0, 50, 20}, &window), new QLineEdit(QStringLiteral("12"), &window),
                      button("c", {140, 0, 50, 20}, &window)};
  row[1]->setObjectName(QStringLiteral("b"));
  row[1]->setGeometry(60, 0, 60, 20);
  button("z", {0, 40, 50, 20}, &window);
  new RowStop(row, &window);
  show();
  EXPECT_EQ(lettersOf(readingOrder(window)), "az");
  row[0]->setFocus();
  QTest::keyClick(row[0], Qt::Key_Right);
  EXPECT_TRUE(row[1]->hasFocus());
  EXPECT_EQ(lettersOf(readingOrder(window)), "bz");
  // The text is selected as by Tab, so the next arrow leaves it; inside the text it moves the cursor.
  static_cast<QLineEdit*>(row[1])->setCursorPosition(1);
  QTest::keyClick(row[1], Qt::Key_Right);
  EXPECT_TRUE(row[1]->hasFocus());
  QTest::keyClick(row[1], Qt::Key_Right);
  EXPECT_TRUE(row[2]->hasFocus());
  QTest::keyClick(row[2], Qt::Key_Right);
  EXPECT_TRUE(row[2]->hasFocus());
  QTest::keyClick(row[2], Qt::Key_Left);
  QTest::keyClick(row[1], Qt::Key_Left);
  EXPECT_TRUE(row[0]->hasFocus());
}

TEST_F(ReadingOrder, ARowKeepsAStopWhileAnyPartOfItCanBeUsed) {
  QList<QWidget*> row{button("a", {0, 0, 50, 20}, &window), button("b", {60, 0, 50, 20}, &window),
                      button("c", {120, 0, 50, 20}, &window)};
  row[0]->setEnabled(false);
  new RowStop(row, &window);
  button("z", {0, 40, 50, 20}, &window);
  show();
  EXPECT_EQ(lettersOf(readingOrder(window)), "bz");
  row[1]->setEnabled(false);
  EXPECT_EQ(lettersOf(readingOrder(window)), "cz");
  row[2]->hide();
  EXPECT_EQ(lettersOf(readingOrder(window)), "z");
  row[0]->setEnabled(true);
  EXPECT_EQ(lettersOf(readingOrder(window)), "az");
  delete row[1];
  row[2]->show();
  row[0]->setFocus();
  QTest::keyClick(row[0], Qt::Key_Right);
  EXPECT_TRUE(row[2]->hasFocus());
}

TEST_F(ReadingOrder, AColumnOfButtonsIsOneStopAndAClickTakesTheKeyboardNoMoreThanBefore) {
  QList<QWidget*> column{button("a", {0, 0, 50, 20}, &window), button("b", {0, 30, 50, 20}, &window)};
  column[0]->setFocusPolicy(Qt::TabFocus);
  column[1]->setFocusPolicy(Qt::StrongFocus);
  new RowStop(column, &window, Qt::Vertical);
  show();
  EXPECT_EQ(lettersOf(readingOrder(window)), "a");
  EXPECT_EQ(column[0]->focusPolicy(), Qt::TabFocus);
  EXPECT_EQ(column[1]->focusPolicy(), Qt::ClickFocus);
  column[0]->setFocus();
  QTest::keyClick(column[0], Qt::Key_Right);
  EXPECT_TRUE(column[0]->hasFocus());
  QTest::keyClick(column[0], Qt::Key_Down);
  EXPECT_TRUE(column[1]->hasFocus());
  EXPECT_EQ(column[0]->focusPolicy(), Qt::NoFocus);
}

}  // namespace
}  // namespace tactus::workbench
