// The rule editor on Table A2, small as on a small screen, and what finds its parts.
#pragma once

#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <string>

#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/tune/rules/rule_list_model.h"

#include "tests/gui/patience.h"
#include "tests/gui/s4_rules.h"

namespace tactus::tests {

class RuleEditorFixture : public S4Rules {
 protected:
  void SetUp() override {
    S4Rules::SetUp();
    editor.resize(590, 570);
    editor.show();
    grids = editor.findChild<workbench::RuleGrids*>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return rules.selected().has_value(); }, kPatience));
    QCoreApplication::processEvents();
  }

  void click(const workbench::RuleCell& cell) {
    QTest::mouseClick(grids, Qt::LeftButton, {}, grids->cellRect(cell).center());
  }
  std::string answer(const workbench::RuleCell& cell) const { return rules.cell(cell).then; }

  /// The widget with an accessible name.
  template <class Widget>
  Widget* named(const char* name) const {
    const QList<Widget*> all = editor.findChildren<Widget*>();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](auto* w) { return w->accessibleName() == QLatin1String(name); });
    return found == all.end() ? nullptr : *found;
  }
  template <class Button>
  Button* button(const char* text) const {
    const QList<Button*> all = editor.findChildren<Button*>();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](auto* b) { return b->text() == QString::fromUtf8(text); });
    return found == all.end() ? nullptr : *found;
  }

  QTableView* openList() {
    auto* tabs = editor.findChild<QTabBar*>();
    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
    auto* table = editor.findChild<QTableView*>();
    EXPECT_TRUE(waitForRows(table, static_cast<int>(count())));
    return table;
  }
  static QModelIndex at(const QTableView* table, int row, int column) { return table->model()->index(row, column); }
  static void clickRow(QTableView* table, int row, Qt::KeyboardModifiers keys = {}) {
    const QModelIndex index = at(table, row, workbench::RuleListModel::kConditions);
    table->scrollTo(index);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, keys, table->visualRect(index).center());
  }
  static bool waitForRows(const QTableView* table, int rows) {
    return QTest::qWaitFor([&] { return table->model()->rowCount() == rows; }, kPatience);
  }

  workbench::RuleEditor editor{rules};
  workbench::RuleGrids* grids = nullptr;
};

}  // namespace tactus::tests
