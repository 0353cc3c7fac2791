#include "app/workbench/study_parts.h"

#include <QAction>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include "app/workbench/base/study_path.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/kit/message_banner.h"
#include "app/workbench/main_window.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/recent_files.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"

namespace tactus::workbench {

StudyParts::StudyParts(MainWindow& window, StudyConnection& study, StudyModels& study_models, FeelController& feel,
                       FeelStore& store, const ModelController& models, RecentFiles& recent)
    : window_(window),
      study_(study),
      study_models_(study_models),
      feel_(feel),
      store_(store),
      models_(models),
      recent_(recent) {
  buildMenu();
  FeelPanel& panel = window_.feelPanel();
  auto* recordings = new RecordingsCard(store, study, feel);
  panel.addCard(recordings);
  recordings->setRoomy(panel.isRoomy());
  connect(&panel, &FeelPanel::roomChanged, recordings, &RecordingsCard::setRoomy);
  const auto show_recording = [&panel, &store, &feel] {
    const bool runs = feel.isRunning();
    panel.showRecording(store.isRecording() && !runs, store.isRecording() && runs
                                                          ? std::optional(static_cast<int>(store.recordedS()))
                                                          : std::nullopt);
  };
  connect(&store, &FeelStore::changed, &panel, show_recording);
  connect(&feel, &FeelController::stateChanged, &panel, show_recording);
  window_.installEventFilter(this);
  connectAll();
  showState();
}

void StudyParts::buildMenu() {
  menu_ = new QMenu(tr("&Study"), &window_);
  make_ = menu_->addAction(tr("&New study…"));
  make_->setShortcut(QKeySequence::New);
  show_ = menu_->addAction(tr("Show the study's &model"));
  menu_->addSeparator();
  put_ = menu_->addAction(tr("&Put the open model into the study"));
  build_ = menu_->addAction(tr("&Build the averaged model from the answers"));
  menu_->addSeparator();
  close_ = menu_->addAction(tr("&Close the study"));
  const QList<QAction*> menus = window_.menuBar()->actions();
  window_.menuBar()->insertMenu(menus.value(2), menu_);
}

void StudyParts::connectAll() {
  connect(make_, &QAction::triggered, this, &StudyParts::chooseNew);
  connect(show_, &QAction::triggered, this, [this] {
    if (window_.mayLoseChanges()) study_models_.openModel();
  });
  connect(put_, &QAction::triggered, &study_models_, &StudyModels::putModel);
  connect(build_, &QAction::triggered, this, [this] {
    if (window_.mayLoseChanges()) study_models_.buildModel();
  });
  connect(close_, &QAction::triggered, &study_, &StudyConnection::close);
  connect(&window_, &MainWindow::studyChosen, &study_, &StudyConnection::open);
  connect(&study_models_, &StudyModels::savedChanged, this, &StudyParts::showState);
  connect(&study_, &StudyConnection::contentsChanged, this, &StudyParts::showState);
  connect(&study_, &StudyConnection::closed, this, &StudyParts::showState);
  connect(&study_, &StudyConnection::opened, this, &StudyParts::onOpened);
  connect(&study_, &StudyConnection::failed, this, &StudyParts::onFailed);
  const auto note = [this](const QString& sentence) { window_.banner().showNote(sentence); };
  connect(&study_, &StudyConnection::said, this, note);
  connect(&study_models_, &StudyModels::failed, this, &StudyParts::onFailed);
  connect(&study_models_, &StudyModels::said, this, note);
  connect(&store_, &FeelStore::said, this, [this](const QString& sentence) { window_.say(sentence); });
  connect(&store_, &FeelStore::failed, this, [this](const QString& sentence) { window_.banner().showError(sentence); });
}

void StudyParts::chooseNew() {
  const auto open = models_.current();
  const QString folder = open ? QFileInfo(open->path).absolutePath() : QString();
  QString path = QFileDialog::getSaveFileName(&window_, tr("Make a study"), folder, tr("Studies (*.tactus)"), nullptr,
                                              QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  study_.create(path);
}

void StudyParts::showState() {
  const bool open = study_.isOpen() && !study_.isOpening();
  const bool kept = study_models_.keepsModel();
  put_->setEnabled(open && models_.current() && !kept);
  show_->setEnabled(open && study_models_.hasModel() && !kept);
  build_->setEnabled(open);
  close_->setEnabled(open);
  window_.showStudy(study_.isOpen() ? study_.fileName() : QString());
  window_.strip().showStored(study_models_.savedText(), !study_.failure().isEmpty());
  // The end is asked for anew: what comes up then may take it back.
  if (ending_ && (!study_.isBusy() || !study_.failure().isEmpty())) {
    ending_ = false;
    window_.close();
  }
}

void StudyParts::onOpened() {
  recent_.add(study_.path());
  showState();
}

void StudyParts::onFailed(const QString& path, const QString& sentence) {
  window_.banner().showError(sentence);
  if (!QFileInfo::exists(path)) recent_.remove(path);
  showState();
}

bool StudyParts::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &window_ || event->type() != QEvent::Close || mayEnd()) return QObject::eventFilter(watched, event);
  event->ignore();
  return true;
}

bool StudyParts::mayEnd() {
  if (!study_.isOpen()) return true;
  // The placement and the recording that go on end, and are stored.
  feel_.stop();
  store_.setRecording(false);
  ending_ = false;
  if (study_.failure().isEmpty()) {
    ending_ = study_.isBusy();
    return !ending_;
  }
  const auto answer =
      QMessageBox::warning(&window_, tr("Not stored"),
                           tr("What was done last is not stored in %1: %2").arg(study_.fileName(), study_.failure()),
                           QMessageBox::Retry | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Retry);
  if (answer == QMessageBox::Discard) return true;
  if (answer == QMessageBox::Retry) {
    study_.storeNow();
    ending_ = true;
  }
  return false;
}

}  // namespace tactus::workbench
