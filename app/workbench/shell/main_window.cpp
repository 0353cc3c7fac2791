#include "app/workbench/shell/main_window.h"

#include <QAction>
#include <QBoxLayout>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSettings>
#include <QStatusTipEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

struct MenuText {
  Q_DECLARE_TR_FUNCTIONS(MenuText)
};

/// A menu holds the slots up to and with `last`, from the one after the menu before.
struct MenuSpan {
  MenuSlot last;
  QString title;
};

QList<MenuSpan> spans() {
  return {{MenuSlot::kFileQuit, MenuText::tr("&File")},    {MenuSlot::kEditAuthor, MenuText::tr("&Edit")},
          {MenuSlot::kStudyNotes, MenuText::tr("&Study")}, {MenuSlot::kView, MenuText::tr("&View")},
          {MenuSlot::kFeelLink, MenuText::tr("Fee&l")},    {MenuSlot::kHelp, MenuText::tr("&Help")}};
}

}  // namespace

WindowMenus::WindowMenus(QMenuBar& bar) {
  int slot = 0;
  for (const MenuSpan& span : spans()) {
    QMenu* menu = bar.addMenu(span.title);
    menu->menuAction()->setVisible(false);
    // A menu shows no separator at its end, and one for several in a row.
    for (; slot <= static_cast<int>(span.last); ++slot) groups_.push_back({menu, menu->addSeparator()});
  }
}

const WindowMenus::Group& WindowMenus::group(MenuSlot slot) const { return groups_[static_cast<std::size_t>(slot)]; }

QMenu& WindowMenus::menu(MenuSlot slot) const { return *group(slot).menu; }

QAction* WindowMenus::addAction(MenuSlot slot, const QString& text, const QKeySequence& keys) {
  auto* action = new QAction(text, group(slot).menu);
  action->setShortcut(keys);
  insert(slot, action);
  return action;
}

QMenu* WindowMenus::addMenu(MenuSlot slot, const QString& title) {
  auto* submenu = new QMenu(title, group(slot).menu);
  insert(slot, submenu->menuAction());
  return submenu;
}

void WindowMenus::insert(MenuSlot slot, QAction* action) {
  const auto [menu, end] = group(slot);
  menu->insertAction(end, action);
  menu->menuAction()->setVisible(true);
}

StageRail::StageRail(QWidget* parent) : QWidget(parent) {
  auto* layout = makeColumn(this, {}, 4);
  for (const Stage stage : kStages) {
    auto* button = new StageButton(stage, this);
    buttons_.insert(stage, button);
    layout->addWidget(button);
    button->hide();
    connect(button, &StageButton::clicked, this, [this, stage] { emit chosen(stage); });
  }
  layout->addStretch(1);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  fitWidth();
}

void StageRail::show(Stage stage) { buttons_.value(stage)->show(); }

void StageRail::setReady(Stage stage, bool ready) { buttons_.value(stage)->setEnabled(ready); }

void StageRail::setState(Stage stage, const QString& state) {
  if (StageButton* const button = buttons_.value(stage)) button->setState(state);
}

void StageRail::setStage(std::optional<Stage> stage) {
  for (StageButton* button : buttons_) {
    // Among exclusive buttons the checked one cannot be unchecked.
    button->setAutoExclusive(stage.has_value());
    button->setChecked(stage == button->stage());
  }
  // The frame of the keyboard goes with the stage, whatever entered it.
  const bool had_focus =
      std::any_of(buttons_.begin(), buttons_.end(), [](const StageButton* button) { return button->hasFocus(); });
  for (StageButton* button : buttons_) {
    if (had_focus && button->isChecked()) button->setFocus();
  }
}

void StageRail::setCompact(bool compact) {
  if (compact == compact_) return;
  compact_ = compact;
  for (StageButton* button : buttons_) button->setCompact(compact);
  fitWidth();
}

// Larger text is wider.
void StageRail::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && !buttons_.isEmpty()) fitWidth();
}

void StageRail::fitWidth() { setFixedWidth(buttons_.first()->sizeHint().width()); }

BenchView::BenchView(SceneController& scene, QSettings& settings, QWidget* parent)
    : QWidget(parent), header_(new ModelHeader(scene, this)), panels_(new PanelArea(settings, this)) {
  makeColumn(this, {header_, {panels_, 1}});
}

HeaderPlace::HeaderPlace(QMenuBar& menus, BenchView& bench, QObject* parent)
    : QObject(parent), menus_(menus), bench_(bench) {
  menus_.installEventFilter(this);
}

void HeaderPlace::setLow(bool low) {
  low = low && !menus_.isNativeMenuBar();
  if (low == low_) return;
  low_ = low;
  ModelHeader& header = bench_.header();
  if (low) {
    header.setParent(&menus_);
    header.setVisible(shown_);
  } else {
    static_cast<QBoxLayout*>(bench_.layout())->insertWidget(0, &header);
    header.show();
    menus_.setMinimumHeight(0);
  }
  fit();
}

void HeaderPlace::setShown(bool shown) {
  shown_ = shown;
  if (low_) bench_.header().setVisible(shown);
  fit();
}

bool HeaderPlace::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::Resize || type == QEvent::LayoutRequest || type == QEvent::Show) fit();
  return QObject::eventFilter(watched, event);
}

void HeaderPlace::fit() {
  if (!low_) return;
  ModelHeader& header = bench_.header();
  menus_.setMinimumHeight(shown_ ? header.minimumSizeHint().height() : 0);
  int left = 0;
  for (const QAction* action : menus_.actions()) {
    left = std::max(left, menus_.actionGeometry(const_cast<QAction*>(action)).right());
  }
  left += 2 * theme::kGrid;
  header.setGeometry(left, 0, menus_.width() - left - theme::kGrid, menus_.height());
}

namespace {

constexpr auto kGeometryKey = "window_geometry";
constexpr auto kStageKey = "stage";
// px: a window that is smaller either way has the compact rail, and the line of the model beside the menus.
constexpr QSize kRoomyWindow(1500, 800);
constexpr int kTightHeight = 600;  // px at 100 %: below it panels share their places, for large text

/// A size that fits the screen with the frame around the window.
QSize firstSize(const QWidget& window) {
  constexpr QSize kWanted(1440, 900);
  constexpr QSize kFrame(16, 48);  // px, as large as window managers make it
  return kWanted.boundedTo(window.screen()->availableSize() - kFrame);
}

}  // namespace

MainWindow::MainWindow(const ModelController& models, SceneController& scene, QSettings& settings)
    : settings_(settings),
      menus_(*menuBar()),
      banner_(new MessageBanner(this)),
      column_(new QVBoxLayout),
      screens_(new PageStack(this)),
      bench_(new BenchView(scene, settings, this)),
      header_place_(new HeaderPlace(*menuBar(), *bench_, this)),
      rail_(new StageRail(this)),
      strip_(new OperatingStrip(models, scene, this)),
      models_(models) {
  screens_->addWidget(bench_);
  header_place_->setShown(true);
  auto* content = new QWidget(this);
  column_->setSpacing(theme::kGrid);
  column_->addWidget(banner_);
  column_->addWidget(screens_, 1);
  auto* stage = makeRow({rail_, {column_, 1}});
  makeColumn(content, {{stage, 1}, strip_}, theme::kGrid / 2, inset(theme::kGrid, theme::kGrid / 2));
  setCentralWidget(content);
  // There is nothing to do in a stage before a model or a study is open.
  rail_->hide();
  strip_->hide();
  setWindowTitle(tr("Tactus Workbench"));

  connect(menus_.addAction(MenuSlot::kFileQuit, tr("Close the &window"), QKeySequence::Close), &QAction::triggered,
          this, &QWidget::close);
  connect(menus_.addAction(MenuSlot::kFileQuit, tr("&Quit"), Qt::CTRL | Qt::Key_Q), &QAction::triggered, this,
          &QWidget::close);
  connect(rail_, &StageRail::chosen, this, &MainWindow::enter);
  connect(screens_, &QStackedWidget::currentChanged, this,
          [this] { header_place_->setShown(screens_->currentWidget() == bench_); });
  connect(&models, &ModelController::opened, this, &MainWindow::showStages);

  setMinimumSize(1024, 640);
  resize(firstSize(*this));
  restoreGeometry(settings_.value(QLatin1String(kGeometryKey)).toByteArray());
}

void MainWindow::setStartScreen(QWidget* screen) {
  start_ = screen;
  screens_->addWidget(screen);
  screens_->setCurrentWidget(screen);
}

void MainWindow::setStageState(Stage stage, const QString& state) { rail_->setState(stage, state); }

void MainWindow::addScreen(Stage stage, QWidget* screen, Needs needs) {
  TACTUS_CHECK(!hasScreen(stage));
  if (screens_->indexOf(screen) < 0) screens_->addWidget(screen);
  stages_.insert(static_cast<int>(stage), {screen, needs});
  rail_->show(stage);
  rail_->setReady(stage, canEnter(stage));
}

bool MainWindow::canEnter(Stage stage) const {
  if (!hasScreen(stage)) return false;
  const bool needs_study = stages_.value(static_cast<int>(stage)).needs == Needs::kStudy;
  return needs_study ? study_open_ : models_.current() != nullptr;
}

void MainWindow::setStudyOpen(bool open) {
  study_open_ = open;
  showStages();
}

void MainWindow::addScreen(Stage stage, std::vector<PanelPlace> layout, std::vector<PanelPlace> tight) {
  panels().setLayout(stageId(stage), std::move(layout), std::move(tight));
  addScreen(stage, bench_);
}

void MainWindow::addLayout(const QString& id, std::vector<PanelPlace> layout) {
  panels().setLayout(id, std::move(layout));
}

Panel& MainWindow::addPanel(const QString& id, const QString& title, QWidget* content) {
  Panel& panel = panels().addPanel(id, title, content);
  // The layout keeps it closed, also after the end of the program.
  connect(&panel, &Panel::closed, this, [this, &panel] {
    if (isVisible())
      banner_->showOffer(tr("The panel %1 is closed and stays closed in this stage.").arg(panel.windowTitle()),
                         {tr("Show it again"), [&panel] { panel.reveal(); }});
  });
  return panel;
}

void MainWindow::addStrip(QWidget* strip) { column_->insertWidget(column_->indexOf(screens_), strip); }

void MainWindow::addCloseGuard(std::function<bool()> may_close) { close_guards_.push_back(std::move(may_close)); }

void MainWindow::showError(const QString& sentence, MessageAct act, const QObject& from) {
  banner_->showRemedy(sentence, std::move(act), &from);
}

void MainWindow::takeBackError(const QObject& from) { banner_->takeBack(from); }

void MainWindow::say(const QString& sentence) { strip_->showMessage(harmless(sentence)); }

void MainWindow::enter(Stage stage) {
  TACTUS_CHECK(hasScreen(stage));
  if (!canEnter(stage)) return;
  stage_ = stage;
  QWidget* const screen = stages_.value(static_cast<int>(stage)).screen;
  screens_->setCurrentWidget(screen);
  if (screen == bench_) {
    // The panels take their shares of the room that the window has now.
    if (!panels().stage()) centralWidget()->layout()->activate();
    panels().enter(stage);
  }
  rail_->setStage(stage);
  strip_->showPoint(screen == bench_ || stage == Stage::kBuild);
  settings_.setValue(QLatin1String(kStageKey), stageId(stage));
  setLayoutBeside({});
  emit entered(stage);
}

void MainWindow::showStart() {
  screens_->setCurrentWidget(start_);
  rail_->setStage(std::nullopt);
  strip_->showPoint(false);
}

void MainWindow::enterLayout(const QString& id) {
  if (!models_.current() || id == layout_beside_) return;
  screens_->setCurrentWidget(bench_);
  panels().enterLayout(id);
  rail_->setStage(std::nullopt);
  strip_->showPoint(true);
  setLayoutBeside(id);
}

void MainWindow::leaveLayout() {
  if (!layout_beside_.isEmpty() && stage_) enter(*stage_);
}

// In reading order: the rail, the screen or its panels row by row, the strip.
QList<QWidget*> MainWindow::parts() const {
  QList<QWidget*> parts{rail_};
  if (screens_->currentWidget() == bench_) {
    parts << &bench_->header();
    QList<QWidget*> shown;
    for (Panel* panel : bench_->panels().panels()) {
      if (panel->isVisible() && !panel->isFloating() && !bench_->panels().isBehind(*panel)) shown << panel;
    }
    std::sort(shown.begin(), shown.end(),
              [](const QWidget* a, const QWidget* b) { return std::pair(a->y(), a->x()) < std::pair(b->y(), b->x()); });
    parts << shown;
  } else {
    parts << screens_->currentWidget();
  }
  return parts << strip_;
}

void MainWindow::focusNextPart(bool forward) {
  const QList<QWidget*> all = parts();
  const QWidget* focus = focusWidget();
  const auto here = std::find_if(all.begin(), all.end(), [&](const QWidget* part) {
    return part == focus || (focus != nullptr && part->isAncestorOf(focus));
  });
  const auto count = static_cast<int>(all.size());
  int at = here == all.end() ? (forward ? -1 : 0) : static_cast<int>(here - all.begin());
  for (int tried = 0; tried < count; ++tried) {
    at = (at + (forward ? 1 : count - 1)) % count;
    QWidget* part = all[at];
    const QList<QWidget*> inside = part->isVisible() ? readingOrder(*part) : QList<QWidget*>();
    if (inside.isEmpty()) continue;
    inside.first()->setFocus(Qt::TabFocusReason);
    return;
  }
}

void MainWindow::setLayoutBeside(const QString& id) {
  if (std::exchange(layout_beside_, id) != id) emit layoutChanged();
}

void MainWindow::showStages() {
  for (const Stage stage : kStages) rail_->setReady(stage, canEnter(stage));
  const bool any = std::any_of(kStages.begin(), kStages.end(), [this](Stage stage) { return canEnter(stage); });
  rail_->setVisible(any);
  strip_->setVisible(any);
  if (stage_ && canEnter(*stage_)) return;
  stage_.reset();
  if (const auto last = lastStage()) {
    enter(*last);
  } else {
    screens_->setCurrentWidget(start_);
  }
}

// The stage of the last time, else Tune for a model, else where a study is.
std::optional<Stage> MainWindow::lastStage() const {
  const QString id = settings_.value(QLatin1String(kStageKey)).toString();
  const auto last = std::find_if(kStages.begin(), kStages.end(),
                                 [&](Stage stage) { return stageId(stage) == id && canEnter(stage); });
  if (last != kStages.end()) return *last;
  if (canEnter(Stage::kTune)) return Stage::kTune;
  const auto any = std::find_if(kStages.begin(), kStages.end(), [this](Stage stage) { return canEnter(stage); });
  return any == kStages.end() ? std::nullopt : std::optional(*any);
}

// A field that refuses what was typed says so in a status tip.
bool MainWindow::event(QEvent* event) {
  // Later, because the panels get their fonts now.
  if (event->type() == QEvent::FontChange)
    QMetaObject::invokeMethod(this, &MainWindow::fitPanels, Qt::QueuedConnection);
  if (event->type() != QEvent::StatusTip) return QMainWindow::event(event);
  if (const QString tip = static_cast<QStatusTipEvent*>(event)->tip(); !tip.isEmpty()) say(tip);
  return true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!std::all_of(close_guards_.rbegin(), close_guards_.rend(), [](const auto& may_close) { return may_close(); })) {
    event->ignore();
    return;
  }
  emit closing();
  panels().storeLayout();
  settings_.setValue(QLatin1String(kGeometryKey), saveGeometry());
  QMainWindow::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  const bool compact = width() < kRoomyWindow.width() || height() < kRoomyWindow.height();
  rail_->setCompact(compact);
  header_place_->setLow(compact);
  fitPanels();
}

void MainWindow::fitPanels() { panels().setTight(height() < appearance::scaled(kTightHeight)); }

bool MainWindow::focusNextPrevChild(bool next) { return focusNextAsRead(*this, next); }

}  // namespace tactus::workbench
