#include "app/workbench/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusTipEvent>
#include <QVBoxLayout>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/study_path.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/bench_view.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/feel_status.h"
#include "app/workbench/kit/message_banner.h"
#include "app/workbench/kit/reading_order.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/shell/file_drop.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/recent_files.h"
#include "app/workbench/shell/shortcut_sheet.h"
#include "app/workbench/shell/stage_rail.h"
#include "app/workbench/shell/start_view.h"

namespace tactus::workbench {
namespace {

constexpr auto kGeometryKey = "window_geometry";
constexpr auto kStageKey = "stage";
constexpr int kRoomyWidth = 1500;  // px: below it the rail takes less room

Stage lastStage(const QSettings& settings) {
  const QString id = settings.value(QLatin1String(kStageKey)).toString();
  for (const Stage stage : kStages) {
    if (stageId(stage) == id && isReady(stage)) return stage;
  }
  return Stage::kTune;
}

}  // namespace

MainWindow::MainWindow(ModelController& models, SceneController& scene, FeelController& feel, RecentFiles& recent,
                       QSettings& settings)
    : models_(models),
      scene_(scene),
      feel_(feel),
      recent_(recent),
      settings_(settings),
      banner_(new MessageBanner(this)),
      column_(new QVBoxLayout),
      screens_(new QStackedWidget(this)),
      start_(new StartView(recent, this)),
      bench_(new BenchView(scene, feel, settings, this)),
      rail_(new StageRail(this)),
      strip_(new OperatingStrip(models, scene, this)) {
  screens_->addWidget(start_);
  screens_->addWidget(bench_);
  auto* content = new QWidget(this);
  column_->setSpacing(theme::kGrid);
  column_->addWidget(banner_);
  column_->addWidget(screens_, 1);
  auto* stage = new QHBoxLayout;
  stage->setSpacing(theme::kGrid);
  stage->addWidget(rail_);
  stage->addLayout(column_, 1);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(theme::kGrid, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2);
  layout->setSpacing(theme::kGrid / 2);
  layout->addLayout(stage, 1);
  layout->addWidget(strip_);
  setCentralWidget(content);
  auto* feel_status = new FeelStatus(feel);
  strip_->setDeviceState(feel_status);
  connect(feel_status, &FeelStatus::latencyChanged, strip_, &OperatingStrip::showLatency);
  // There is nothing to do in a stage before a model is open.
  rail_->hide();
  strip_->hide();
  connect(new FileDrop(*this), &FileDrop::dropped, this, &MainWindow::openFile);
  setWindowTitle(tr("Tactus Workbench"));

  buildMenus();
  listRecent();
  connectAll();
  restorePlace();
}

void MainWindow::buildMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  open_ = file->addAction(tr("&Open…"));
  open_->setShortcut(QKeySequence::Open);
  recent_menu_ = file->addMenu(tr("Open &recent"));
  reopen_ = file->addAction(tr("&Reopen"));
  reopen_->setShortcut(Qt::Key_F5);
  reopen_->setEnabled(false);
  file->addSeparator();
  save_ = file->addAction(tr("&Save"));
  save_->setShortcut(QKeySequence::Save);
  save_as_ = file->addAction(tr("Save &as…"));
  save_as_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_S);
  file->addSeparator();
  save_curves_ = file->addAction(tr("Save &picture of the curves…"));
  save_curves_->setShortcut(Qt::CTRL | Qt::Key_E);
  save_map_ = file->addAction(tr("Save picture of the &map…"));
  save_map_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_E);
  copy_picture_ = file->addAction(tr("&Copy picture of the plot"));
  copy_picture_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_C);
  copy_picture_->setToolTip(tr("The plot with the keyboard or under the mouse"));
  for (QAction* action : {save_, save_as_, save_curves_, save_map_, copy_picture_}) action->setEnabled(false);
  file->addSeparator();
  quit_ = file->addAction(tr("&Quit"));
  quit_->setShortcut(Qt::CTRL | Qt::Key_Q);

  view_menu_ = menuBar()->addMenu(tr("&View"));
  stage_menu_ = view_menu_->addMenu(tr("&Stage"));
  int number = 0;
  for (const Stage stage : kStages) {
    QAction* action = stage_menu_->addAction(stageName(stage));
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + number++)));
    action->setEnabled(isReady(stage));
    connect(action, &QAction::triggered, this, [this, stage] { enter(stage); });
  }
  panel_menu_ = view_menu_->addMenu(tr("&Panels"));
  look_menu_ = view_menu_->addMenu(tr("&Look"));
  listLooks();
  reset_layout_ = view_menu_->addAction(tr("&Reset layout"));
  reset_layout_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_R);
  for (QAction* action : {stage_menu_->menuAction(), panel_menu_->menuAction(), reset_layout_}) {
    action->setEnabled(false);
  }

  buildFeelMenu();
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  shortcuts_ = help->addAction(tr("&Keyboard shortcuts"));
  shortcuts_->setShortcut(QKeySequence::HelpContents);
  about_ = help->addAction(tr("&About Tactus Workbench"));
}

void MainWindow::buildFeelMenu() {
  QMenu* menu = menuBar()->addMenu(tr("F&eel"));
  feel_start_ = menu->addAction(tr("&Start on the chosen device"));
  feel_start_->setShortcut(Qt::Key_F9);
  // Works without the menu too, whatever has the keyboard (feel_panel.cpp).
  feel_stop_ = menu->addAction(tr("S&top: no force"));
  feel_stop_->setShortcut(Qt::Key_F12);
  menu->addSeparator();
  flex_ = menu->addAction(tr("&Flex the neck, or raise the head"));
  flex_->setShortcut(Qt::Key_F8);
  new_placement_ = menu->addAction(tr("&New placement"));
  showFeel();
}

void MainWindow::showFeel() {
  const bool open = models_.current() != nullptr;
  feel_start_->setEnabled(open && feel_.state() == FeelController::State::kStopped);
  feel_stop_->setEnabled(feel_.isRunning() || feel_.state() == FeelController::State::kOpening);
  flex_->setEnabled(open);
  new_placement_->setEnabled(feel_.isRunning());
}

void MainWindow::connectAll() {
  connect(open_, &QAction::triggered, this, &MainWindow::choose);
  connect(reopen_, &QAction::triggered, this, &MainWindow::reopen);
  connect(save_, &QAction::triggered, &models_, &ModelController::save);
  connect(save_as_, &QAction::triggered, this, &MainWindow::chooseCopy);
  connect(save_curves_, &QAction::triggered, &bench_->curvesMenu(), &PlotMenu::choosePicture);
  connect(save_map_, &QAction::triggered, &bench_->mapMenu(), &PlotMenu::choosePicture);
  connect(copy_picture_, &QAction::triggered, this, &MainWindow::copyPicture);
  connect(quit_, &QAction::triggered, this, &QWidget::close);
  connect(panel_menu_, &QMenu::aboutToShow, this, &MainWindow::listPanels);
  connect(reset_layout_, &QAction::triggered, &panels(), &PanelArea::resetLayout);
  connect(feel_start_, &QAction::triggered, bench_, &BenchView::toggleFeel);
  connect(feel_stop_, &QAction::triggered, &feel_, &FeelController::stop);
  connect(flex_, &QAction::triggered, &feel_, [this] { feel_.setNeckFlexed(!feel_.isNeckFlexed()); });
  connect(new_placement_, &QAction::triggered, &feel_, &FeelController::newPlacement);
  connect(&feel_, &FeelController::stateChanged, this, &MainWindow::showFeel);
  connect(shortcuts_, &QAction::triggered, this, &MainWindow::showShortcuts);
  connect(about_, &QAction::triggered, this, &MainWindow::showAbout);
  connect(start_, &StartView::openRequested, this, &MainWindow::choose);
  connect(start_, &StartView::recentRequested, this, &MainWindow::openFile);
  connect(rail_, &StageRail::chosen, this, &MainWindow::enter);
  connect(&recent_, &RecentFiles::changed, this, &MainWindow::listRecent);
  connect(&models_, &ModelController::openFailed, this, &MainWindow::showFailure);
  connect(&models_, &ModelController::saveFailed, this,
          [this](const QString& /*path*/, const QString& sentence) { banner_->showError(sentence); });
  connect(&models_, &ModelController::saved, this, &MainWindow::showTitle);
  connect(&models_, &ModelController::modifiedChanged, this, &MainWindow::setWindowModified);
  connect(&models_, &ModelController::opened, this, &MainWindow::showModel);
}

void MainWindow::restorePlace() {
  setMinimumSize(1024, 640);
  resize(1280, 800);
  restoreGeometry(settings_.value(QLatin1String(kGeometryKey)).toByteArray());
}

// A field that refuses what was typed says so in a status tip.
bool MainWindow::event(QEvent* event) {
  if (event->type() != QEvent::StatusTip) return QMainWindow::event(event);
  if (const QString tip = static_cast<QStatusTipEvent*>(event)->tip(); !tip.isEmpty()) say(tip);
  return true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLoseChanges()) {
    event->ignore();
    return;
  }
  // Nobody can stop the force once the window is gone.
  feel_.stop();
  panels().storeLayout();
  settings_.setValue(QLatin1String(kGeometryKey), saveGeometry());
  QMainWindow::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  rail_->setCompact(width() < kRoomyWidth);
}

bool MainWindow::focusNextPrevChild(bool next) { return focusNextAsRead(*this, next); }

void MainWindow::showError(const QString& sentence) { banner_->showError(sentence); }

void MainWindow::say(const QString& sentence) { strip_->showMessage(harmless(sentence)); }

void MainWindow::choose() {
  const auto open = models_.current();
  const QString folder = open ? QFileInfo(open->path).absolutePath() : QString();
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a model or a study"), folder,
      tr("Models and studies (*.json *.tactus);;Force models (*.json);;Studies (*.tactus);;"
         "All files (*)"));
  if (!path.isEmpty()) openFile(path);
}

void MainWindow::chooseCopy() {
  const OpenModel& open = *models_.current();
  const QFileInfo file(open.path);
  const QString proposal =
      open.in_study ? file.absolutePath() + QLatin1Char('/') + file.completeBaseName() + QStringLiteral(".tactus.json")
                    : open.path;
  QString path = QFileDialog::getSaveFileName(this, tr("Save the model"), proposal, tr("Force models (*.tactus.json)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) path += QStringLiteral(".tactus.json");
  models_.saveAs(path);
}

QAction* MainWindow::addReferenceAction() {
  auto* action = new QAction(tr("Open re&ference curve…"), this);
  action->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_O);
  auto* file = qobject_cast<QMenu*>(recent_menu_->parent());
  file->insertAction(save_curves_, action);
  return action;
}

void MainWindow::copyPicture() {
  if (PlotMenu* plot = currentPlot(*bench_)) plot->copyPicture();
}

void MainWindow::openFile(const QString& path) {
  if (!mayLoseChanges()) return;
  if (isStudyPath(path)) {
    emit studyChosen(path);
  } else {
    models_.open(path);
  }
}

void MainWindow::reopen() {
  if (mayLoseChanges()) models_.reopen();
}

bool MainWindow::mayLoseChanges() {
  if (!models_.isModified()) return true;
  const auto answer = QMessageBox::question(
      this, tr("Changes not saved"), tr("%1 has changes that are not saved.").arg(text(models_.current()->model.name)),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) models_.save();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && !models_.isModified());
}

void MainWindow::addStrip(QWidget* strip) { column_->insertWidget(column_->indexOf(screens_), strip); }

PanelArea& MainWindow::panels() { return bench_->panels(); }

FeelPanel& MainWindow::feelPanel() { return bench_->feelPanel(); }

void MainWindow::enter(Stage stage) {
  panels().enter(stage);
  rail_->setStage(stage);
  settings_.setValue(QLatin1String(kStageKey), stageId(stage));
}

void MainWindow::showModel() {
  const OpenModel& open = *models_.current();
  screens_->setCurrentWidget(bench_);
  rail_->show();
  strip_->show();
  for (QAction* action : {reopen_, save_, save_as_, save_curves_, copy_picture_, stage_menu_->menuAction(),
                          panel_menu_->menuAction(), reset_layout_}) {
    action->setEnabled(true);
  }
  if (!panels().stage()) {
    // The panels take their shares of the room that the window has now.
    centralWidget()->layout()->activate();
    enter(lastStage(settings_));
  }
  save_map_->setEnabled(open.model.inputs.size() > 1);
  showFeel();
  showTitle();
  if (open.warnings.isEmpty()) {
    banner_->hide();
  } else {
    banner_->showNote(tr("Parts of the file were not used: %1").arg(open.warnings.join(QStringLiteral("; "))));
  }
}

void MainWindow::showStudy(const QString& name) {
  const QString shown = harmless(name);
  if (shown == study_) return;
  study_ = shown;
  bench_->header().showStudy(shown);
  showTitle();
}

ModelHeader& MainWindow::header() { return bench_->header(); }

void MainWindow::showTitle() {
  const QString study = study_.isEmpty() ? QString() : tr(" – study %1").arg(study_);
  if (!models_.current()) {
    setWindowTitle(tr("Tactus Workbench") + study);
    return;
  }
  const OpenModel& open = *models_.current();
  const QString file = shownFileName(open.path);
  const QString name = harmless(text(open.model.name));
  // Of a model that the study keeps the file is the study's.
  setWindowTitle(file == study_ ? name + study + QStringLiteral("[*]")
                                : QStringLiteral("%1 – %2%3[*]").arg(name, file, study));
  // One that was left by its study has no file yet.
  if (QFileInfo::exists(open.path)) recent_.add(open.path);
}

void MainWindow::showFailure(const QString& path, const QString& sentence) {
  banner_->showError(sentence);
  if (!QFileInfo::exists(path)) recent_.remove(path);
}

void MainWindow::listRecent() {
  recent_menu_->clear();
  for (const QString& path : recent_.paths()) {
    QAction* action = recent_menu_->addAction(QString(path).replace(QLatin1Char('&'), QLatin1String("&&")));
    // Queued, because opening the file rebuilds this menu and with it the action.
    connect(
        action, &QAction::triggered, this, [this, path] { openFile(path); }, Qt::QueuedConnection);
  }
  recent_menu_->setEnabled(!recent_menu_->isEmpty());
}

void MainWindow::listPanels() {
  panel_menu_->clear();
  panel_menu_->addActions(panels().toggleActions());
}

void MainWindow::listLooks() {
  auto* group = new QActionGroup(look_menu_);
  const std::pair<theme::Look, QString> looks[] = {{theme::Look::kLight, tr("&Light")},
                                                   {theme::Look::kDark, tr("&Dark")}};
  const theme::Look now = theme::storedLook(settings_);
  for (const auto& [look, name] : looks) {
    QAction* action = look_menu_->addAction(name);
    action->setCheckable(true);
    action->setChecked(look == now);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, chosen = look] {
      theme::storeLook(settings_, chosen);
      theme::changeLook(*qApp, chosen);
    });
  }
}

void MainWindow::showShortcuts() {
  ShortcutSheet sheet(*menuBar(), this);
  sheet.exec();
}

void MainWindow::showAbout() {
  const QString version = QString::fromUtf8(kVersion.data(), static_cast<qsizetype>(kVersion.size()));
  QMessageBox::about(
      this, tr("About Tactus Workbench"),
      tr("<h3>Tactus Workbench %1</h3>"
         "<p>Turns what expert nurses know by feel into a force model that a haptic simulator can run.</p>"
         "<p>Free software under the GNU General Public License, version 3 or later, without any "
         "warranty. It uses Qt %2 and QCustomPlot.</p>")
          .arg(version, QString::fromLatin1(qVersion())));
}

}  // namespace tactus::workbench
