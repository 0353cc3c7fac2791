#include "app/workbench/shell/help_menu.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/shell/main_window.h"

namespace tactus::workbench {
namespace {

using Line = std::pair<QString, QString>;  // what it does, keys

struct Section {
  QString title;
  QList<Line> lines;
};

constexpr int kColumns = 3;  // that the sheet fits on a small screen

/// In lines, with the title and the space before the next one.
qsizetype heightOf(const Section& section) { return section.lines.size() + 2; }

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

QGridLayout* makeSection(const Section& section, QWidget* parent) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * theme::kGrid);
  grid->setVerticalSpacing(4);
  auto* head = new QLabel(section.title, parent);
  head->setFont(theme::headingFont());
  grid->addWidget(head, 0, 0, 1, 2);
  for (const Line& line : section.lines) {
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
  QList<Section> sections;
  for (const QAction* entry : menus.actions()) {
    const QList<Line> lines = linesOf(*entry->menu());
    if (!lines.isEmpty()) sections << Section{plainText(entry->text()), lines};
  }
  sections << Section{tr("Plots"),
                      {{tr("Read the force"), tr("move the mouse")},
                       {tr("Set the operating point"), tr("click or drag")},
                       {tr("Zoom"), tr("wheel")},
                       {tr("Move the zoomed part"), tr("Shift and drag")},
                       {tr("Show all"), tr("double click")}}};
  sections << Section{tr("Numbers and sliders"),
                      {{tr("One step"), tr("arrow keys")},
                       {tr("Ten steps"), tr("Page up, page down")},
                       {tr("Accept a typed number"), tr("Enter")}}};
  sections << Section{tr("Rule grids"),
                      {{tr("Answer and go on"), tr("1 to 9")},
                       {tr("Skip a cell"), tr("Space")},
                       {tr("Empty a cell"), tr("Delete")},
                       {tr("Next grid"), tr("Page down")},
                       {tr("Choose from a menu"), tr("Enter")}}};
  sections << Section{tr("Membership functions"),
                      {{tr("Move a vertex, an edge or a term"), tr("drag, or its slider")},
                       {tr("Fine step, coarse step"), tr("left, right; with Shift")},
                       {tr("Next vertex"), tr("up, down")},
                       {tr("Take a drag back"), tr("Esc")}}};
  sections << Section{tr("While a model is felt"),
                      {{tr("Hold the tool"), tr("Space")},
                       {tr("Move the hand"), tr("left, right; with Shift farther")},
                       {tr("No force, at once"), tr("F12, or Esc outside a drag")}}};
  sections << Section{tr("Panels"),
                      {{tr("Move, or put behind another"), tr("drag the title or tab")},
                       {tr("Take out of the window, or back"), tr("double click the title")},
                       {tr("Float, close, reset the layout"), tr("right button on the title")}}};

  qsizetype height = 0;
  for (const Section& section : sections) height += heightOf(section);
  auto* sheet = new QWidget;
  auto* columns = makeRow(sheet, {}, 4 * theme::kGrid);
  QVBoxLayout* column = nullptr;
  qsizetype filled = 0;
  for (const Section& section : sections) {
    // A section belongs to the column in which most of it lies.
    const bool next = column == nullptr || (filled + heightOf(section) / 2) * kColumns > height * columns->count();
    if (next) {
      if (column != nullptr) column->addStretch(1);
      column = new QVBoxLayout;
      column->setSpacing(2 * theme::kGrid);
      columns->addLayout(column, 1);
    }
    column->addLayout(makeSection(section, this));
    filled += heightOf(section);
  }
  column->addStretch(1);
  auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout =
      makeColumn(this, {}, 3 * theme::kGrid, {3 * theme::kGrid, 3 * theme::kGrid, 3 * theme::kGrid, 2 * theme::kGrid});
  // With large text it is larger than a small screen.
  auto* area = new QScrollArea(this);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setAccessibleName(windowTitle());
  area->setWidget(sheet);
  layout->addWidget(area);
  layout->addWidget(close);
  const QSize bar(area->verticalScrollBar()->sizeHint().width(), area->horizontalScrollBar()->sizeHint().height());
  const QSize around = layout->sizeHint() - area->sizeHint();
  resize((sheet->sizeHint() + around + bar)
             .boundedTo(parent != nullptr ? parent->window()->size() : screen()->availableSize()));
}

namespace {

struct HelpMenu {
  Q_DECLARE_TR_FUNCTIONS(HelpMenu)
};

void showShortcuts(MainWindow& window) {
  ShortcutSheet sheet(*window.menuBar(), &window);
  sheet.exec();
}

void showAbout(MainWindow& window) {
  const QString version = QString::fromUtf8(kVersion.data(), static_cast<qsizetype>(kVersion.size()));
  QMessageBox::about(
      &window, HelpMenu::tr("About Tactus Workbench"),
      HelpMenu::tr("<h3>Tactus Workbench %1</h3>"
                   "<p>Turns what expert nurses know by feel into a force model that a haptic simulator can run.</p>"
                   "<p>Free software under the GNU General Public License, version 3 or later, without any "
                   "warranty. It uses Qt %2 and QCustomPlot.</p>")
          .arg(version, QString::fromLatin1(qVersion())));
}

}  // namespace

void addHelpMenu(MainWindow& window) {
  QAction* const shortcuts =
      window.menus().addAction(MenuSlot::kHelp, HelpMenu::tr("Show the &keyboard shortcuts"), Qt::CTRL | Qt::Key_Slash);
  QAction* const about = window.menus().addAction(MenuSlot::kHelp, HelpMenu::tr("&About Tactus Workbench"));
  QObject::connect(shortcuts, &QAction::triggered, &window, [&window] { showShortcuts(window); });
  QObject::connect(about, &QAction::triggered, &window, [&window] { showAbout(window); });
}

}  // namespace tactus::workbench
