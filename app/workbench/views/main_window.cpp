#include "app/workbench/views/main_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/version.h"
#include "app/workbench/controllers/model_controller.h"
#include "app/workbench/controllers/recent_files.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/display_text.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/explore_view.h"
#include "app/workbench/views/message_banner.h"
#include "app/workbench/views/start_view.h"

namespace tactus::workbench {
namespace {

constexpr auto kGeometryKey = "window_geometry";

// The one model file that is dragged, or an empty path.
QString draggedModel(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls.first().isLocalFile()) return {};
  const QString path = urls.first().toLocalFile();
  return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive) ? path : QString();
}

}  // namespace

MainWindow::MainWindow(ModelController& models, SceneController& scene, RecentFiles& recent, QSettings& settings)
    : models_(models),
      scene_(scene),
      recent_(recent),
      settings_(settings),
      banner_(new MessageBanner(this)),
      screens_(new QStackedWidget(this)),
      start_(new StartView(recent, this)),
      explore_(new ExploreView(scene, this)) {
  screens_->addWidget(start_);
  screens_->addWidget(explore_);
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(banner_);
  layout->addWidget(screens_, 1);
  setCentralWidget(content);
  setAcceptDrops(true);
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
  save_picture_ = file->addAction(tr("Save &picture…"));
  save_picture_->setShortcut(Qt::CTRL | Qt::Key_E);
  save_picture_->setEnabled(false);
  file->addSeparator();
  quit_ = file->addAction(tr("&Quit"));
  quit_->setShortcut(Qt::CTRL | Qt::Key_Q);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  about_ = help->addAction(tr("&About Tactus Workbench"));
}

void MainWindow::connectAll() {
  connect(open_, &QAction::triggered, this, &MainWindow::chooseModel);
  connect(reopen_, &QAction::triggered, &models_, &ModelController::reopen);
  connect(save_picture_, &QAction::triggered, this, &MainWindow::choosePicture);
  connect(quit_, &QAction::triggered, this, &QWidget::close);
  connect(about_, &QAction::triggered, this, &MainWindow::showAbout);
  connect(start_, &StartView::openRequested, this, &MainWindow::chooseModel);
  connect(start_, &StartView::recentRequested, &models_, &ModelController::open);
  connect(explore_, &ExploreView::savePictureRequested, this, &MainWindow::choosePicture);
  connect(&recent_, &RecentFiles::changed, this, &MainWindow::listRecent);
  connect(&models_, &ModelController::openFailed, this, &MainWindow::showFailure);
  connect(&scene_, &SceneController::modelChanged, this, &MainWindow::showModel);
}

void MainWindow::restorePlace() {
  setMinimumSize(960, 600);
  resize(1280, 800);
  restoreGeometry(settings_.value(QLatin1String(kGeometryKey)).toByteArray());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedModel(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = draggedModel(*event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  models_.open(path);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  settings_.setValue(QLatin1String(kGeometryKey), saveGeometry());
  QMainWindow::closeEvent(event);
}

void MainWindow::chooseModel() {
  const auto open = models_.current();
  const QString folder = open ? QFileInfo(open->path).absolutePath() : QString();
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a model file"), folder, tr("Force models (*.json);;All files (*)"));
  if (!path.isEmpty()) models_.open(path);
}

void MainWindow::choosePicture() {
  const auto open = models_.current();
  if (!open) return;
  const QFileInfo model_file(open->path);
  const QString proposal =
      model_file.absolutePath() + QLatin1Char('/') + model_file.baseName() + QStringLiteral(".png");
  QString path = QFileDialog::getSaveFileName(this, tr("Save the curves as a picture"), proposal,
                                              tr("Pictures (*.png *.svg *.pdf)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".png");
  const auto saved = explore_->savePicture(path);
  if (!saved) banner_->showError(text(saved.error().message()));
}

void MainWindow::showModel() {
  const OpenModel& open = *scene_.model();
  screens_->setCurrentWidget(explore_);
  reopen_->setEnabled(true);
  save_picture_->setEnabled(true);
  setWindowTitle(QStringLiteral("%1 – %2").arg(text(open.model.name), QFileInfo(open.path).fileName()));
  recent_.add(open.path);
  if (open.warnings.isEmpty()) {
    banner_->hide();
  } else {
    banner_->showNote(tr("Parts of the file were not used: %1").arg(open.warnings.join(QStringLiteral("; "))));
  }
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
        action, &QAction::triggered, &models_, [this, path] { models_.open(path); }, Qt::QueuedConnection);
  }
  recent_menu_->setEnabled(!recent_menu_->isEmpty());
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
