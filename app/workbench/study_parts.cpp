#include "app/workbench/study_parts.h"

#include <QAction>
#include <QFileInfo>
#include <QMessageBox>
#include <chrono>
#include <memory>
#include <utility>

#include "app/report/study_report.h"
#include "app/session/data_checks.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/feel_parts.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/recent_files.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

// Takes a second for four participants and half a minute for 200.
base::Result<void> writeStudyReport(const session::StudyView& view, const session::StudyAside& aside,
                                    elicitation::BuildSettings settings, const QString& study_name,
                                    const std::string& path) {
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  const auto data = session::dataFindings(view.study);
  if (auto ok = study::refuseData(data); !ok) return ok;
  const auto forms = session::knownForms();
  TACTUS_TRY(auto built, elicitation::hasRules(view.study) ? elicitation::buildModel(view.study, forms, settings)
                                                           : elicitation::buildTerms(view.study, settings));
  built.notes.insert(built.notes.begin(), view.notes.begin(), view.notes.end());
  TACTUS_TRY(const auto page, report::studyReport({.study = view.study,
                                                   .built = built,
                                                   .build_settings = settings,
                                                   .forms = forms,
                                                   .data = data,
                                                   .settings = {{"Study", study_name.toStdString()},
                                                                {"Program", std::string(kGenerator)},
                                                                {"Created (UTC)", settings.created_utc}},
                                                   .usability = aside.usability}));
  return base::writeFileAtomically(path, page);
}

}  // namespace

ReportParts::ReportParts(MainWindow& window, StudyConnection& study, const LabData& labs)
    : window_(window),
      study_(study),
      labs_(labs),
      action_(window.menus().addAction(MenuSlot::kFilePictures, tr("Write the repor&t of the study…"))) {
  connect(action_, &QAction::triggered, this, &ReportParts::choose);
  connect(&study_, &StudyConnection::opened, this, &ReportParts::showState);
  connect(&study_, &StudyConnection::closed, this, [this] {
    busy_ = false;
    background_.drop();
    showState();
  });
  connect(this, &ReportParts::written, &window_,
          [this](const QString& path) { window_.say(tr("The report is written: %1").arg(shownFileName(path))); });
  connect(this, &ReportParts::failed, &window_, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The report was not written. %1").arg(sentence),
                                {tr("Choose another file…"), [this] { choose(); }});
  });
  showState();
}

void ReportParts::showState() { action_->setEnabled(study_.isOpen() && !busy_); }

void ReportParts::choose() {
  const QFileInfo study(study_.path());
  const QString proposed =
      study.absolutePath() + QLatin1Char('/') + study.completeBaseName() + QStringLiteral("-report.html");
  const QString path =
      file_dialog::getSaveFileName(&window_, tr("Report of the study"), proposed, tr("Web page (*.html)"));
  if (!path.isEmpty()) write(path);
}

void ReportParts::write(const QString& path) {
  if (busy_ || !study_.isOpen()) return;
  busy_ = true;
  showState();
  window_.say(tr("Writing the report…"));
  study_.read(*this, [this, path, settings = labs_.settings(), name = study_.fileName()](const store::StudyFile& file) {
    auto read = std::make_shared<base::Result<session::StudyView>>(session::studyForElicitation(file));
    auto aside = std::make_shared<base::Result<session::StudyAside>>(session::asideOf(file));
    return [this, path, settings, name, read, aside] {
      if (!*read) return end(path, text(read->error().message()));
      if (!*aside) return end(path, text(aside->error().message()));
      background_.run([this, path, settings, name, read, aside](const std::stop_token&) -> Background::Deliver {
        const auto done = writeStudyReport(**read, **aside, settings, name, path.toStdString());
        return [this, path, failure = done ? QString() : text(done.error().message())] { end(path, failure); };
      });
    };
  });
}

void ReportParts::end(const QString& path, const QString& failure) {
  busy_ = false;
  showState();
  if (failure.isEmpty()) {
    emit written(path);
  } else {
    emit failed(failure);
  }
}

StudyParts::StudyParts(MainWindow& window, ModelFiles& files, StudyConnection& study, StudyModels& study_models,
                       FeelController& feel, FeelPanel& panel, FeelStore& store, const ModelController& models,
                       RecentFiles& recent)
    : window_(window),
      files_(files),
      study_(study),
      study_models_(study_models),
      feel_(feel),
      store_(store),
      models_(models),
      recent_(recent) {
  buildMenu();
  addRecordings(panel);
  window_.addCloseGuard([this] { return mayEnd(); });
  connectAll();
  showState();
}

void StudyParts::addRecordings(FeelPanel& panel) {
  auto* recordings = new RecordingsCard(store_, study_, feel_);
  panel.addCard(tr("Recordings"), recordings);
  connect(recordings, &RecordingsCard::studyRequested, this, &StudyParts::recordIntoStudy);
  connect(&store_, &FeelStore::notReplayable, this, [this, recordings](const QString& sentence) {
    const MessageAct another{tr("Choose another recording"), [this, recordings] {
                               window_.enterLayout(FeelParts::layoutId());
                               recordings->chooseRecording();
                             }};
    window_.banner().showRemedy(sentence, another);
  });
  recordings->setRoomy(panel.isRoomy());
  connect(&panel, &FeelPanel::roomChanged, recordings, &RecordingsCard::setRoomy);
  const auto show_recording = [this, &panel] {
    const bool runs = feel_.isRunning();
    panel.showRecording(store_.isRecording() && !runs, store_.isRecording() && runs
                                                           ? std::optional(static_cast<int>(store_.recordedS()))
                                                           : std::nullopt);
  };
  connect(&store_, &FeelStore::changed, &panel, show_recording);
  connect(&feel_, &FeelController::stateChanged, &panel, show_recording);
}

void StudyParts::buildMenu() {
  WindowMenus& menus = window_.menus();
  make_ = menus.addAction(MenuSlot::kStudyOpen, tr("&New study…"), QKeySequence::New);
  show_ = menus.addAction(MenuSlot::kStudyOpen, tr("Show the study's &model"));
  copy_ = menus.addAction(MenuSlot::kStudyOpen, tr("Sa&ve a copy of the study…"));
  put_ = menus.addAction(MenuSlot::kStudyModel, tr("&Put the open model into the study"));
  build_ = menus.addAction(MenuSlot::kStudyModel, tr("&Build the averaged model from the answers"));
  close_ = menus.addAction(MenuSlot::kStudyClose, tr("&Close the study"));
}

void StudyParts::connectAll() {
  connect(make_, &QAction::triggered, this, &StudyParts::chooseNew);
  connect(show_, &QAction::triggered, this, [this] {
    if (files_.mayLoseChanges()) study_models_.openModel();
  });
  connect(put_, &QAction::triggered, &study_models_, &StudyModels::putModel);
  connect(build_, &QAction::triggered, this, &StudyParts::buildModel);
  connect(copy_, &QAction::triggered, this, &StudyParts::chooseCopy);
  connect(&study_, &StudyConnection::copied, this, [this](const QString& copy) {
    // Whoever could only read goes on with the copy.
    if (study_.isReadOnly()) files_.open(copy);
    window_.banner().showNote(tr("A copy of the study was saved as %1.").arg(harmless(copy)));
  });
  connect(&study_, &StudyConnection::copyFailed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The copy was not saved. %1").arg(sentence),
                                {tr("Save elsewhere…"), [this] { chooseCopy(); }});
  });
  connect(close_, &QAction::triggered, &study_, &StudyConnection::close);
  connect(&files_, &ModelFiles::studyChosen, &study_, &StudyConnection::open);
  connect(&study_models_, &StudyModels::savedChanged, this, &StudyParts::showState);
  connect(&study_, &StudyConnection::contentsChanged, this, &StudyParts::showState);
  connect(&study_, &StudyConnection::closed, this, &StudyParts::showState);
  connect(&study_, &StudyConnection::opened, this, &StudyParts::onOpened);
  connect(&study_, &StudyConnection::failed, this,
          [this](const QString& path, const QString& sentence) { onFailed(path, sentence); });
  const auto note = [this](const QString& sentence) { window_.banner().showNote(sentence); };
  connect(&study_, &StudyConnection::said, this, note);
  connect(&study_models_, &StudyModels::failed, this, &StudyParts::onFailed);
  connect(&study_models_, &StudyModels::said, this, [this, note](const QString& sentence) {
    if (isToRecord() && !study_models_.hasModel()) return;  // the model that is felt is open already
    study_.isReadOnly() && !study_models_.hasModel() ? showReadOnly({sentence, {}}) : note(sentence);
  });
  connect(&study_models_, &StudyModels::backOffered, this, [this](const QString& sentence, const MessageAct& act) {
    study_.isReadOnly() ? showReadOnly({sentence, act}) : window_.banner().showOffer(sentence, act);
  });
  connect(&study_models_, &StudyModels::buildOffered, this, [this](const QString& sentence) {
    const MessageAct build{tr("Build the averaged model"), [this] { buildModel(); }};
    study_.isReadOnly() ? showReadOnly({sentence, build}) : window_.banner().showOffer(sentence, build);
  });
  connect(&study_, &StudyConnection::leaving, this, [this] { beside_ = {}; });
  connect(&store_, &FeelStore::said, this, [this](const QString& sentence) { window_.say(sentence); });
  connect(&store_, &FeelStore::failed, this,
          [this](const QString& sentence, const MessageAct& act) { window_.banner().showRemedy(sentence, act); });
}

void StudyParts::chooseNew() {
  const auto open = models_.current();
  const QString folder = open ? QFileInfo(open->path).absolutePath() : QString();
  QString path = file_dialog::getSaveFileName(&window_, tr("Make a study"), folder, tr("Studies (*.tactus)"), nullptr,
                                              QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  study_.create(path);
}

void StudyParts::recordIntoStudy() {
  const auto open = models_.current();
  const QString folder = open ? QFileInfo(open->path).absolutePath() : documentsFolder();
  const QString name = open ? QFileInfo(open->path).baseName() : tr("recordings");
  QString path = file_dialog::getSaveFileName(&window_, tr("Record into a study: a new one, or one that is there"),
                                              folder + QLatin1Char('/') + name + QStringLiteral(".tactus"),
                                              tr("Studies (*.tactus)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  recorded_path_ = QFileInfo(path).absoluteFilePath();
  QFileInfo::exists(path) ? files_.open(path) : study_.create(path);
}

bool StudyParts::isToRecord() const { return study_.isOpen() && study_.path() == recorded_path_; }

void StudyParts::showState() {
  const bool open = study_.isOpen() && !study_.isOpening();
  const bool kept = study_models_.keepsModel();
  const bool writable = open && study_.takesOrders();
  put_->setEnabled(writable && models_.current() && !kept);
  put_->setStatusTip(study_.isReadOnly() ? tr("%1 is open for reading only.").arg(study_.fileName()) : QString());
  copy_->setEnabled(open);
  show_->setEnabled(open && study_models_.hasModel() && !kept);
  build_->setEnabled(open);
  close_->setEnabled(open);
  files_.showStudy(study_.isOpen() ? study_.fileName() : QString(), study_.readOnlyReason());
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
  if (study_.isReadOnly()) {
    showReadOnly(beside_);
  } else if (isToRecord()) {
    window_.enterLayout(FeelParts::layoutId());
    store_.setRecording(true);
    window_.say(tr("Armed: Start (F9), and what you feel is recorded into %1.").arg(study_.fileName()));
  }
}

// What else is said of such a study does not take the place of the copy.
void StudyParts::showReadOnly(ReadOnlyReason beside) {
  beside_ = std::move(beside);
  const QString locked =
      tr("%1 is open for reading only, because %2. Nothing can be stored in it; a copy can be changed.")
          .arg(study_.fileName(), study_.readOnlyReason());
  window_.banner().showOffer(beside_.sentence.isEmpty() ? locked : locked + QLatin1Char(' ') + beside_.sentence,
                             {tr("Save a copy…"), [this] { chooseCopy(); }}, beside_.act);
}

void StudyParts::chooseCopy(bool go_on_there) {
  const QFileInfo file(study_.path());
  const QString folder = study_.isReadOnly() ? documentsFolder() : file.absolutePath();
  QString path =
      file_dialog::getSaveFileName(&window_, tr("Save a copy of the study"),
                                   folder + QLatin1Char('/') + file.completeBaseName() + QStringLiteral("-copy.tactus"),
                                   tr("Studies (*.tactus)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  go_on_there ? study_.moveTo(path) : study_.saveCopy(path);
}

void StudyParts::buildModel() {
  if (files_.mayLoseChanges()) study_models_.buildModel();
}

void StudyParts::onFailed(const QString& path, const QString& sentence, const MessageAct& act) {
  if (path == recorded_path_) recorded_path_.clear();
  if (!study_.failure().isEmpty()) {
    window_.banner().showRemedy(sentence, {tr("Try again"), [this] { study_.storeNow(); }}, nullptr,
                                {tr("Go on in a copy…"), [this] { chooseCopy(true); }});
  } else if (!study_.isOpen()) {
    window_.banner().showRemedy(sentence, {tr("Open another file…"), [this] { files_.choose(); }});
  } else {
    const MessageAct look{tr("Look at the study"), [this] { window_.enter(Stage::kCollect); }};
    window_.banner().showRemedy(sentence, act.text.isEmpty() ? look : act);
  }
  if (!QFileInfo::exists(path)) recent_.remove(path);
  showState();
}

bool StudyParts::mayEnd() {
  if (!study_.isOpen()) return true;
  // The current placement and recording end and are stored.
  feel_.stop();
  store_.setRecording(false);
  ending_ = false;
  if (study_.failure().isEmpty()) {
    ending_ = study_.isBusy();
    return !ending_;
  }
  const auto answer =
      QMessageBox::warning(&window_, tr("Not stored"),
                           tr("The last changes are not stored in %1: %2").arg(study_.fileName(), study_.failure()),
                           QMessageBox::Retry | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Retry);
  if (answer == QMessageBox::Discard) return true;
  if (answer == QMessageBox::Retry) {
    study_.storeNow();
    ending_ = true;
  }
  return false;
}

}  // namespace tactus::workbench
