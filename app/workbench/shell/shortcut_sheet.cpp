#include "app/workbench/shell/shortcut_sheet.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <utility>

#include "app/workbench/base/ink.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

using Line = std::pair<QString, QString>;  // what it does, keys

QString plainText(QString text) { return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

QList<Line> linesOf(const QMenu& menu) {
  QList<Line> lines;
  for (const QAction* action : menu.actions()) {
    if (action->menu()) lines << linesOf(*action->menu());
    if (action->shortcut().isEmpty()) continue;
    lines << Line{plainText(action->text()), action->shortcut().toString(QKeySequence::NativeText)};
  }
  return lines;
}

QGridLayout* makeSection(const QString& title, const QList<Line>& lines, QWidget* parent) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(3 * theme::kGrid);
  grid->setVerticalSpacing(4);
  auto* head = new QLabel(title, parent);
  head->setFont(theme::headingFont());
  grid->addWidget(head, 0, 0, 1, 2);
  for (const Line& line : lines) {
    const int row = grid->rowCount();
    auto* keys = new QLabel(line.second, parent);
    setInk(*keys, theme::mutedInk());
    grid->addWidget(new QLabel(line.first, parent), row, 0);
    grid->addWidget(keys, row, 1, Qt::AlignRight);
  }
  return grid;
}

}  // namespace

ShortcutSheet::ShortcutSheet(const QMenuBar& menus, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Keyboard shortcuts"));
  auto* menu_column = new QVBoxLayout;
  menu_column->setSpacing(2 * theme::kGrid);
  for (const QAction* entry : menus.actions()) {
    const QList<Line> lines = linesOf(*entry->menu());
    if (!lines.isEmpty()) menu_column->addLayout(makeSection(plainText(entry->text()), lines, this));
  }
  menu_column->addStretch(1);

  auto* plot_column = new QVBoxLayout;
  plot_column->setSpacing(2 * theme::kGrid);
  plot_column->addLayout(makeSection(
      tr("Plots"), {{tr("Read the force"), tr("move the mouse")}, {tr("Set the operating point"), tr("click or drag")}},
      this));
  plot_column->addLayout(makeSection(tr("Numbers and sliders"),
                                     {{tr("One step"), tr("arrow keys")},
                                      {tr("Ten steps"), tr("Page up, page down")},
                                      {tr("Accept a typed number"), tr("Enter")}},
                                     this));
  plot_column->addLayout(makeSection(tr("Rule grids"),
                                     {{tr("Answer and go on"), tr("1 to 9")},
                                      {tr("Skip a cell"), tr("Space")},
                                      {tr("Empty a cell"), tr("Delete")},
                                      {tr("Next grid"), tr("Page down")},
                                      {tr("Choose from a menu"), tr("Enter")}},
                                     this));
  plot_column->addLayout(makeSection(tr("Membership functions"),
                                     {{tr("Move a vertex, an edge or a term"), tr("drag, or its slider")},
                                      {tr("Fine step, coarse step"), tr("left, right; with Shift")},
                                      {tr("Next vertex"), tr("up, down")},
                                      {tr("Take a drag back"), tr("Esc")}},
                                     this));
  plot_column->addLayout(makeSection(tr("While a model is felt"),
                                     {{tr("Hold the tube"), tr("Space")},
                                      {tr("Move the hand"), tr("left, right; with Shift farther")},
                                      {tr("No force, at once"), tr("F12, or Esc while nothing is dragged")}},
                                     this));
  plot_column->addLayout(makeSection(tr("Panels"),
                                     {{tr("Move, or put behind another"), tr("drag the title or tab")},
                                      {tr("Take out of the window, or back"), tr("double click the title or tab")},
                                      {tr("Float, close, reset the layout"), tr("right button on the title or tab")}},
                                     this));
  plot_column->addStretch(1);

  auto* columns = new QHBoxLayout;
  columns->setSpacing(6 * theme::kGrid);
  columns->addLayout(menu_column);
  columns->addLayout(plot_column);
  auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * theme::kGrid, 3 * theme::kGrid, 3 * theme::kGrid, 2 * theme::kGrid);
  layout->setSpacing(3 * theme::kGrid);
  layout->addLayout(columns);
  layout->addWidget(close);
}

}  // namespace tactus::workbench
