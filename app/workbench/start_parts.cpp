#include "app/workbench/start_parts.h"

#include <QDir>
#include <QFileInfo>

#include "app/workbench/base/documents.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/collect_parts.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/start_view.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"

namespace tactus::workbench {

StartParts::StartParts(MainWindow& window, ModelFiles& files, CollectParts& collect, ModelController& models,
                       const RecentFiles& recent, Panel& rule_editor, const StudyConnection& study,
                       StudyModels& study_models)
    : window_(window),
      files_(files),
      collect_(collect),
      models_(models),
      rule_editor_(rule_editor),
      study_(study),
      study_models_(study_models),
      demo_(documentsFolder()),
      view_(new StartView(recent, demo_)) {
  window_.setStartScreen(view_);
  connectAll();
}

void StartParts::connectAll() {
  connect(view_, &StartView::demoRequested, this, &StartParts::exploreDemo);
  connect(view_, &StartView::freshDemoRequested, &demo_, &DemoMaker::makeFresh);
  connect(view_, &StartView::tourRequested, this, &StartParts::tourRequested);
  connect(view_, &StartView::guideRequested, this, &StartParts::guideRequested);
  connect(view_, &StartView::newStudyRequested, &collect_, &CollectParts::makeStudy);
  connect(view_, &StartView::newModelRequested, this, &StartParts::makeModel);
  connect(view_, &StartView::tablesRequested, this, &StartParts::chooseTables);
  connect(view_, &StartView::importRequested, &files_, &ModelFiles::chooseImport);
  connect(view_, &StartView::openRequested, &files_, &ModelFiles::choose);
  connect(view_, &StartView::recentRequested, &files_, &ModelFiles::open);
  connect(&demo_, &DemoMaker::ready, this, &StartParts::onDemoReady);
  connect(&study_, &StudyConnection::opened, this, &StartParts::onStudyOpened);
  connect(&models_, &ModelController::opened, this, &StartParts::onModelOpened);
  connect(&demo_, &DemoMaker::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(sentence, {tr("Choose another folder…"), [this] { chooseDemoFolder(); }});
  });
  connect(&tables_, &TableImport::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The tables were not imported. %1").arg(sentence),
                                {tr("Choose another folder…"), [this] { chooseTables(); }});
  });
  connect(&tables_, &TableImport::doubted, this,
          [this](const QString& folder, const QString& path, const QString& sentence) {
            window_.banner().showRemedy(tr("The tables were not imported. %1").arg(sentence),
                                        {tr("Import as they are"), [=, this] { tables_.run(folder, path, true); }});
          });
  connect(&tables_, &TableImport::imported, this, [this](const QString& path, const QString& notes) {
    files_.open(path);
    window_.banner().showNote(notes);
  });
}

void StartParts::exploreDemo() { demo_.explore(); }

void StartParts::chooseDemoFolder() {
  const QString folder =
      file_dialog::getExistingDirectory(&window_, tr("Folder for the demo study"), documentsFolder());
  if (folder.isEmpty()) return;
  demo_.setDocuments(folder);
  demo_.explore();
}

void StartParts::onDemoReady(const QString& study) {
  demo_study_ = study;
  files_.open(study);
}

// What is explored is the model: a fresh copy of the demo has only the answers yet.
void StartParts::onStudyOpened() {
  const bool asked = !demo_study_.isEmpty() && QFileInfo(study_.path()) == QFileInfo(demo_study_);
  if (asked && !study_models_.hasModel()) study_models_.buildModel();
}

// The study opens with its people first; what is to be explored is the model.
void StartParts::onModelOpened() {
  if (demo_study_.isEmpty() || QFileInfo(models_.current()->path) != QFileInfo(demo_study_)) return;
  demo_study_.clear();
  window_.enter(Stage::kUnderstand);
  emit demoShown();
}

void StartParts::makeModel() {
  if (!files_.makeFromTemplate()) return;
  window_.enter(Stage::kTune);
  rule_editor_.reveal();
  window_.banner().showNote(tr("A new model without rules: answer what force the experts feel in each situation."));
}

void StartParts::chooseTables() {
  const QString folder = file_dialog::getExistingDirectory(&window_, tr("Folder with the tables"), documentsFolder());
  if (folder.isEmpty()) return;
  const QString proposal = folder + QLatin1Char('/') + QDir(folder).dirName() + QStringLiteral(".tactus");
  QString path = file_dialog::getSaveFileName(&window_, tr("Make a study of the tables"), proposal,
                                              tr("Studies (*.tactus)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  tables_.run(folder, path, false);
}

}  // namespace tactus::workbench
