#include "app/workbench/shell/menus.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <optional>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"

namespace tactus::workbench {

ViewMenu::ViewMenu(MainWindow& window, const ModelController& models, QSettings& settings)
    : window_(window), settings_(settings) {
  addStages();
  QAction* const panels = addPanels()->menuAction();
  addLooks();
  addTextSizes();
  QAction* const next =
      window_.menus().addAction(MenuSlot::kView, tr("Go to the next p&art of the window"), Qt::Key_F6);
  QAction* const before =
      window_.menus().addAction(MenuSlot::kView, tr("Go to the part &before"), Qt::SHIFT | Qt::Key_F6);
  connect(next, &QAction::triggered, &window_, [this] { window_.focusNextPart(true); });
  connect(before, &QAction::triggered, &window_, [this] { window_.focusNextPart(false); });
  QAction* const reset =
      window_.menus().addAction(MenuSlot::kView, tr("&Reset layout"), Qt::CTRL | Qt::SHIFT | Qt::Key_R);
  connect(reset, &QAction::triggered, &window_.panels(), &PanelArea::resetLayout);
  for (QAction* action : {panels, reset}) {
    action->setEnabled(false);
    connect(&models, &ModelController::opened, action, [action] { action->setEnabled(true); });
  }
}

void ViewMenu::addStages() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Stage"));
  int number = 0;
  for (const Stage stage : kStages) {
    QAction* action = menu->addAction(stageName(stage));
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + number++)));
    action->setVisible(window_.hasScreen(stage));
    connect(action, &QAction::triggered, &window_, [this, stage] {
      if (window_.canEnter(stage)) return window_.enter(stage);
      window_.say(stage == Stage::kCollect || stage == Stage::kBuild ? tr("%1 needs a study.").arg(stageName(stage))
                                                                     : tr("%1 needs a model.").arg(stageName(stage)));
    });
  }
}

QMenu* ViewMenu::addPanels() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Panels"));
  menu->addActions(window_.panels().toggleActions());
  return menu;
}

void ViewMenu::addLooks() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Look"));
  auto* group = new QActionGroup(menu);
  const std::pair<std::optional<theme::Look>, QString> looks[] = {
      {std::nullopt, tr("As the s&ystem")}, {theme::Look::kLight, tr("&Light")}, {theme::Look::kDark, tr("&Dark")}};
  const auto now = appearance::chosenLook(settings_);
  for (const auto& [look, name] : looks) {
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    action->setChecked(look == now);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, chosen = look] {
      appearance::chooseLook(settings_, chosen);
      theme::changeLook(*qApp, chosen.value_or(appearance::systemLook(*qApp)));
    });
  }
}

void ViewMenu::addTextSizes() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Text size"));
  auto* group = new QActionGroup(menu);
  for (const int percent : appearance::kTextSizes) {
    QAction* action = menu->addAction(tr("%1 %").arg(percent));
    action->setCheckable(true);
    action->setChecked(percent == appearance::chosenTextSize(settings_));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, percent] {
      appearance::chooseTextSize(settings_, percent);
      appearance::changeTextSize(*qApp, percent);
    });
  }
}

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
