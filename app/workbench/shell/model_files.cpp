#include "app/workbench/shell/model_files.h"

#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QUrl>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/model/shown_procedure.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/recent_files.h"

namespace tactus::workbench {
namespace {

// The one file that is dragged, a model, a study or a model of another program, or an empty path.
QString draggedFile(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls.first().isLocalFile()) return {};
  const QString path = urls.first().toLocalFile();
  const bool known =
      path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive) || isStudyPath(path) || isImportPath(path);
  return known ? path : QString();
}

}  // namespace

FileDrop::FileDrop(QWidget& window) : QObject(&window), window_(window) {
  window_.setAcceptDrops(true);
  qApp->installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
  const bool enters = event->type() == QEvent::DragEnter;
  if (!enters && event->type() != QEvent::Drop) return QObject::eventFilter(watched, event);
  auto& drag = static_cast<QDropEvent&>(*event);
  if (watched == &window_) return takes(drag);
  if (!enters || qobject_cast<QLineEdit*>(watched) == nullptr || draggedFile(*drag.mimeData()).isEmpty()) {
    return QObject::eventFilter(watched, event);
  }
  // The window is asked next.
  event->ignore();
  return true;
}

bool FileDrop::takes(QDropEvent& event) {
  const QString path = draggedFile(*event.mimeData());
  if (path.isEmpty()) return false;
  event.acceptProposedAction();
  if (event.type() == QEvent::Drop) {
    QMetaObject::invokeMethod(
        this, [this, path] { emit dropped(path); }, Qt::QueuedConnection);
  }
  return true;
}

ModelFiles::ModelFiles(MainWindow& window, ModelController& models, RecentFiles& recent)
    : window_(window), models_(models), recent_(recent) {
  connect(new FileDrop(window_), &FileDrop::dropped, this, &ModelFiles::open);
  window_.addCloseGuard([this] { return mayLoseChanges(); });
  buildMenu();
  listRecent();
  connectAll();
}

void ModelFiles::buildMenu() {
  WindowMenus& menus = window_.menus();
  open_ = menus.addAction(MenuSlot::kFileOpen, tr("&Open…"), QKeySequence::Open);
  recent_menu_ = menus.addMenu(MenuSlot::kFileOpen, tr("Open &recent"));
  reopen_ = menus.addAction(MenuSlot::kFileOpen, tr("Reop&en"), Qt::Key_F5);
  notes_ = menus.addAction(MenuSlot::kFileOpen, tr("Show the &notes of the file"));
  save_ = menus.addAction(MenuSlot::kFileSave, tr("&Save"), QKeySequence::Save);
  save_as_ = menus.addAction(MenuSlot::kFileSave, tr("Save &as…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S);
  for (QAction* action : {reopen_, save_, save_as_, notes_}) action->setEnabled(false);
}

void ModelFiles::connectAll() {
  connect(open_, &QAction::triggered, this, &ModelFiles::choose);
  connect(reopen_, &QAction::triggered, this, &ModelFiles::reopen);
  connect(notes_, &QAction::triggered, this, &ModelFiles::showNotes);
  connect(save_, &QAction::triggered, this, &ModelFiles::save);
  connect(save_as_, &QAction::triggered, this, &ModelFiles::chooseCopy);
  connect(&recent_, &RecentFiles::changed, this, &ModelFiles::listRecent);
  connect(&models_, &ModelController::openFailed, this, &ModelFiles::showFailure);
  connect(&models_, &ModelController::saveFailed, this, [this](const QString& path, const QString& sentence) {
    window_.banner().showRemedy(tr("%1 was not saved. %2").arg(shownFileName(path), sentence),
                                {tr("Save elsewhere…"), [this] { chooseCopy(); }});
  });
  connect(&models_, &ModelController::saved, this, &ModelFiles::showTitle);
  connect(&models_, &ModelController::modifiedChanged, &window_, &QWidget::setWindowModified);
  connect(&models_, &ModelController::opened, this, &ModelFiles::showModel);
}

QString ModelFiles::folder() const {
  const auto open = models_.current();
  return open ? QFileInfo(open->path).absolutePath() : documentsFolder();
}

void ModelFiles::chooseImport() {
  const QString path = file_dialog::getOpenFileName(&window_, tr("Import a model of another program"), folder(),
                                                    tr("Models of other programs (*.fll *.fcl *.fis *.txt)"));
  if (!path.isEmpty()) open(path);
}

bool ModelFiles::makeFromTemplate() {
  if (!mayLoseChanges()) return false;
  const ProcedurePtr about = shownProcedure() != nullptr ? shownProcedure() : procedure::defaultProcedure();
  auto model = templateModel(*about, tr("New model"), folder());
  if (!model) {
    window_.banner().showRemedy(tr("No new model was made. %1").arg(text(model.error().message())),
                                {tr("Open a file…"), [this] { choose(); }});
    return false;
  }
  unnamed_ = model->path;
  models_.openUnsaved(std::move(*model));
  return true;
}

void ModelFiles::choose() {
  const QString path = file_dialog::getOpenFileName(
      &window_, tr("Open a model or a study"), folder(),
      tr("Models and studies (*.json *.tactus *.fll *.fcl *.fis);;Force models (*.json);;Studies (*.tactus);;"
         "Models of other programs (*.fll *.fcl *.fis *.txt);;All files (*)"));
  if (!path.isEmpty()) this->open(path);
}

void ModelFiles::chooseCopy() {
  const OpenModel& open = *models_.current();
  const QFileInfo file(open.path);
  const QString proposal =
      open.in_study ? file.absolutePath() + QLatin1Char('/') + file.completeBaseName() + QStringLiteral(".tactus.json")
                    : open.path;
  QString path =
      file_dialog::getSaveFileName(&window_, tr("Save the model"), proposal, tr("Force models (*.tactus.json)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) path += QStringLiteral(".tactus.json");
  models_.saveAs(path);
}

void ModelFiles::open(const QString& path) {
  if (!mayLoseChanges()) return;
  if (isStudyPath(path)) {
    emit studyChosen(path);
  } else if (isImportPath(path) || path.endsWith(QLatin1String(".txt"), Qt::CaseInsensitive)) {
    import(path);
  } else {
    models_.open(path);
  }
}

void ModelFiles::import(const QString& path) {
  const auto refuse = [&](const base::Error& error) { showFailure(path, text(error.message())); };
  const auto file = readImport(path);
  if (!file) return refuse(file.error());
  std::string output;
  if (const std::vector<std::string> outputs = file->outputs(); outputs.size() > 1) {
    QStringList names;
    for (const std::string& name : outputs) names << harmless(text(name));
    bool chosen = false;
    const QString name = QInputDialog::getItem(&window_, tr("Several outputs"), tr("Which output is the force?"), names,
                                               0, false, &chosen);
    if (!chosen) return;
    output = outputs[static_cast<std::size_t>(names.indexOf(name))];
  }
  auto model = importedModel(*file, QFileInfo(path).absoluteFilePath(), output);
  if (!model) return refuse(model.error());
  unnamed_ = model->path;
  models_.openUnsaved(std::move(*model));
  recent_.add(QFileInfo(path).absoluteFilePath());
}

bool ModelFiles::isUnnamed() const {
  return !unnamed_.isEmpty() && models_.current() && !models_.current()->in_study &&
         models_.current()->path == unnamed_;
}

void ModelFiles::save() {
  const auto open = models_.current();
  // An imported model, a new one, or one beside a study that is open for reading: it is asked for a place.
  if (open && !open->in_study && !QFileInfo::exists(open->path)) {
    chooseCopy();
  } else {
    models_.save();
  }
}

void ModelFiles::reopen() {
  if (mayLoseChanges()) models_.reopen();
}

bool ModelFiles::mayLoseChanges() {
  if (!models_.isModified()) return true;
  const auto answer =
      QMessageBox::question(&window_, tr("Changes not saved"),
                            tr("%1 has changes that are not saved.").arg(text(models_.current()->model.name)),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) save();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && !models_.isModified());
}

void ModelFiles::showModel() {
  const OpenModel& open = *models_.current();
  for (QAction* action : {save_, save_as_}) action->setEnabled(true);
  notes_->setEnabled(!open.warnings.isEmpty());
  if (open.path != unnamed_) unnamed_.clear();
  showTitle();
  if (open.warnings.isEmpty()) {
    window_.banner().hide();
  } else if (isUnnamed()) {
    const QString more = open.warnings.size() == 1
                             ? QString()
                             : QLatin1Char(' ') + tr("File, Show the notes of the file, lists %n more.", nullptr,
                                                     static_cast<int>(open.warnings.size()) - 1);
    window_.banner().showNote(tr("The model was imported. %1.").arg(harmless(open.warnings.first())) + more);
  } else {
    window_.banner().showNote(tr("Parts of the file were not used: %1").arg(open.warnings.join(QStringLiteral("; "))));
  }
}

void ModelFiles::showStudy(const QString& name, const QString& read_only) {
  const QString shown = harmless(name);
  if (shown == study_ && study_read_only_ == !read_only.isEmpty()) return;
  study_ = shown;
  study_read_only_ = !read_only.isEmpty();
  window_.header().showStudy(shown, read_only);
  showTitle();
}

void ModelFiles::showNotes() {
  const OpenModel& open = *models_.current();
  QStringList sentences;
  for (const QString& warning : open.warnings) sentences << harmless(warning);
  const QMenuBar* bar = window_.menuBar();
  showNotesPopup(window_, bar->mapToGlobal(QPoint(theme::kGrid, bar->height() + 4)),
                 {{tr("Notes of the file"), sentences}});
}

void ModelFiles::showTitle() {
  const QString of_study = study_.isEmpty()   ? QString()
                           : study_read_only_ ? tr("study %1 (read-only)").arg(study_)
                                              : tr("study %1").arg(study_);
  // The window system adds the name of the program.
  if (!models_.current()) {
    window_.setWindowTitle(of_study.isEmpty() ? tr("Tactus Workbench") : of_study);
    return;
  }
  const QString study = of_study.isEmpty() ? of_study : QStringLiteral(" – ") + of_study;
  const OpenModel& open = *models_.current();
  const QString file = shownFileName(open.path);
  const QString name = harmless(text(open.model.name));
  // Of a model that the study keeps the file is the study's.
  window_.setWindowTitle(file == study_ ? name + study + QStringLiteral("[*]")
                                        : QStringLiteral("%1 – %2%3[*]").arg(name, file, study));
  // One that was left by its study or imported has no file yet.
  const bool has_file = QFileInfo::exists(open.path);
  if (has_file) recent_.add(open.path, name);
  if (has_file) unnamed_.clear();
  reopen_->setEnabled(has_file);
}

void ModelFiles::showFailure(const QString& path, const QString& sentence) {
  window_.banner().showRemedy(sentence, {tr("Open another file…"), [this] { choose(); }});
  if (!QFileInfo::exists(path)) recent_.remove(path);
}

void ModelFiles::listRecent() {
  recent_menu_->clear();
  for (const QString& path : recent_.paths()) {
    QAction* action = recent_menu_->addAction(QString(path).replace(QLatin1Char('&'), QLatin1String("&&")));
    // Queued, because opening the file rebuilds this menu and with it the action.
    connect(
        action, &QAction::triggered, this, [this, path] { open(path); }, Qt::QueuedConnection);
  }
  recent_menu_->setEnabled(!recent_menu_->isEmpty());
}

}  // namespace tactus::workbench
