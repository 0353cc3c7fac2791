#include <QAction>
#include <QComboBox>
#include <QDesktopServices>
#include <QFileInfo>
#include <QMessageBox>
#include <QUrl>
#include <chrono>
#include <memory>
#include <random>
#include <utility>

#include "app/report/study_report.h"
#include "app/session/data_checks.h"
#include "app/session/study_export.h"
#include "app/session/study_procedure.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/kit/form_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/tune/history/carry_dialog.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

// Takes a second for four participants and half a minute for 200.
/// What the report shows beside the way to the model.
struct Beside {
  session::StudyAside aside;
  std::vector<experiments::DoneInOrder> in_order;
  std::vector<experiments::JudgedDuel> duels;
  std::vector<elicitation::SealedCurve> sealed;
};

base::Result<Beside> besideOf(const store::StudyFile& file, const session::StudyView& view) {
  Beside out;
  TACTUS_TRY(out.aside, session::asideOf(file));
  TACTUS_TRY(out.in_order, session::doneInOrder(file, view));
  TACTUS_TRY(out.duels, session::judgedDuels(file));
  TACTUS_TRY(out.sealed, session::sealedCurves(file));
  return out;
}

base::Result<void> writeStudyReport(const session::StudyView& view, const Beside& beside,
                                    elicitation::BuildSettings settings, const QString& study_name,
                                    const std::string& path) {
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  const auto data = session::dataFindings(view.study);
  if (auto ok = study::refuseData(data); !ok) return ok;
  const auto forms = session::knownForms(procedure::of(view.study));
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
                                                   .usability = beside.aside.usability,
                                                   .usability_simulated = beside.aside.usability_simulated,
                                                   .in_order = beside.in_order,
                                                   .duels = beside.duels,
                                                   .sealed = beside.sealed}));
  return base::writeFileAtomically(path, page);
}

}  // namespace

ReportFeature::ReportFeature(Bench& bench)
    : QObject(&bench.features),
      bench_(bench),
      action_(bench.window.menus().addAction(MenuSlot::kFilePictures, tr("Write the repor&t of the study…"))) {
  connect(action_, &QAction::triggered, this, &ReportFeature::choose);
  connect(&bench_.study, &StudyConnection::opened, this, &ReportFeature::showState);
  connect(&bench_.study, &StudyConnection::closed, this, [this] {
    busy_ = false;
    background_.drop();
    showState();
  });
  connect(this, &ReportFeature::written, &bench_.window, [this](const QString& path) {
    bench_.window.banner().showOffer(
        tr("The report is written: %1").arg(shownFileName(path)),
        {tr("Open the report"), [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); }});
  });
  connect(this, &ReportFeature::failed, &bench_.window, [this](const QString& sentence) {
    bench_.window.banner().showRemedy(tr("The report was not written. %1").arg(sentence),
                                      {tr("Choose another file…"), [this] { choose(); }});
  });
  showState();
}

void ReportFeature::showState() { action_->setEnabled(bench_.study.isOpen() && !busy_); }

void ReportFeature::choose() {
  const QFileInfo study(bench_.study.path());
  const QString proposed =
      study.absolutePath() + QLatin1Char('/') + study.completeBaseName() + QStringLiteral("-report.html");
  const QString path =
      file_dialog::getSaveFileName(&bench_.window, tr("Report of the study"), proposed, tr("Web page (*.html)"));
  if (!path.isEmpty()) write(path);
}

void ReportFeature::write(const QString& path) {
  if (busy_ || !bench_.study.isOpen()) return;
  busy_ = true;
  showState();
  bench_.window.say(tr("Writing the report…"));
  bench_.study.read(*this, [this, path, settings = bench_.labs.data.settings(),
                            name = bench_.study.fileName()](const store::StudyFile& file) {
    auto read = std::make_shared<base::Result<session::StudyView>>(session::studyForElicitation(file));
    auto beside = std::make_shared<base::Result<Beside>>();
    if (*read) *beside = besideOf(file, **read);
    return [this, path, settings, name, read, beside] {
      if (!*read) return end(path, text(read->error().message()));
      if (!*beside) return end(path, text(beside->error().message()));
      background_.run([this, path, settings, name, read, beside](const std::stop_token&) -> Background::Deliver {
        const auto done = writeStudyReport(**read, **beside, settings, name, path.toStdString());
        return [this, path, failure = done ? QString() : text(done.error().message())] { end(path, failure); };
      });
    };
  });
}

void ReportFeature::end(const QString& path, const QString& failure) {
  busy_ = false;
  showState();
  if (failure.isEmpty()) {
    emit written(path);
  } else {
    emit failed(failure);
  }
}

StudyFeature::StudyFeature(Bench& bench) : QObject(&bench.features), bench_(bench) {
  buildMenu();
  addRecordings();
  bench_.window.addCloseGuard([this] { return mayEnd(); });
  connectAll();
  showState();
}

void StudyFeature::addRecordings() {
  FeelPanel& panel = *bench_.views.feel;
  auto* recordings = new RecordingsCard(bench_.feel_store, bench_.study, bench_.feel);
  panel.addCard(tr("Recordings"), recordings);
  connect(recordings, &RecordingsCard::studyRequested, this, &StudyFeature::recordIntoStudy);
  connect(&bench_.feel_store, &FeelStore::notReplayable, this, [this, recordings](const QString& sentence) {
    const MessageAct another{tr("Choose another recording"), [this, recordings] {
                               bench_.window.enterLayout(feelLayout());
                               recordings->chooseRecording();
                             }};
    bench_.window.banner().showRemedy(sentence, another);
  });
  recordings->setRoomy(panel.isRoomy());
  connect(&panel, &FeelPanel::roomChanged, recordings, &RecordingsCard::setRoomy);
  const auto show_recording = [this, &panel] {
    const bool runs = bench_.feel.isRunning();
    panel.showRecording(bench_.feel_store.isRecording() && !runs,
                        bench_.feel_store.isRecording() && runs
                            ? std::optional(static_cast<int>(bench_.feel_store.recordedS()))
                            : std::nullopt);
  };
  connect(&bench_.feel_store, &FeelStore::changed, &panel, show_recording);
  connect(&bench_.feel, &FeelController::stateChanged, &panel, show_recording);
}

void StudyFeature::buildMenu() {
  WindowMenus& menus = bench_.window.menus();
  make_ = menus.addAction(MenuSlot::kStudyOpen, tr("&New study…"), QKeySequence::New);
  show_ = menus.addAction(MenuSlot::kStudyOpen, tr("Show the study's &model"));
  copy_ = menus.addAction(MenuSlot::kStudyOpen, tr("Sa&ve a copy of the study…"));
  put_ = menus.addAction(MenuSlot::kStudyModel, tr("&Put the open model into the study"));
  build_ = menus.addAction(MenuSlot::kStudyModel, tr("&Build the averaged model from the answers"));
  close_ = menus.addAction(MenuSlot::kStudyClose, tr("&Close the study"));
}

void StudyFeature::connectAll() {
  connect(make_, &QAction::triggered, this, &StudyFeature::chooseNew);
  connect(show_, &QAction::triggered, this, [this] {
    if (bench_.files.mayLoseChanges()) bench_.study_models.openModel();
  });
  connect(put_, &QAction::triggered, &bench_.study_models, &StudyModels::putModel);
  connect(build_, &QAction::triggered, this, &StudyFeature::buildModel);
  connect(copy_, &QAction::triggered, this, &StudyFeature::chooseCopy);
  connect(&bench_.study, &StudyConnection::copied, this, [this](const QString& copy) {
    // Whoever could only read goes on with the copy.
    if (bench_.study.isReadOnly()) bench_.files.open(copy);
    bench_.window.banner().showNote(tr("A copy of the study was saved as %1.").arg(harmless(copy)));
  });
  connect(&bench_.study, &StudyConnection::copyFailed, this, [this](const QString& sentence) {
    bench_.window.banner().showRemedy(tr("The copy was not saved. %1").arg(sentence),
                                      {tr("Save elsewhere…"), [this] { chooseCopy(); }});
  });
  connect(close_, &QAction::triggered, &bench_.study, &StudyConnection::close);
  connect(&bench_.files, &ModelFiles::studyChosen, &bench_.study, &StudyConnection::open);
  connect(&bench_.study_models, &StudyModels::savedChanged, this, &StudyFeature::showState);
  connect(&bench_.study, &StudyConnection::contentsChanged, this, &StudyFeature::showState);
  connect(&bench_.study, &StudyConnection::procedureChanged, &bench_.scene,
          [this] { bench_.scene.setStudyProcedure(bench_.study.procedure()); });
  connect(&bench_.study, &StudyConnection::closed, this, &StudyFeature::showState);
  connect(&bench_.study, &StudyConnection::opened, this, &StudyFeature::onOpened);
  connect(&bench_.study, &StudyConnection::failed, this,
          [this](const QString& path, const QString& sentence) { onFailed(path, sentence); });
  const auto note = [this](const QString& sentence) { bench_.window.banner().showNote(sentence); };
  connect(&bench_.study, &StudyConnection::said, this, note);
  connect(&bench_.study_models, &StudyModels::failed, this, &StudyFeature::onFailed);
  connect(&bench_.study_models, &StudyModels::said, this, [this, note](const QString& sentence) {
    if (isToRecord() && !bench_.study_models.hasModel()) return;  // the model that is felt is open already
    bench_.study.isReadOnly() && !bench_.study_models.hasModel() ? showReadOnly({sentence, {}}) : note(sentence);
  });
  connect(&bench_.study_models, &StudyModels::backOffered, this, &StudyFeature::offerBack);
  connect(&bench_.study_models, &StudyModels::buildOffered, this, [this](const QString& sentence) {
    const MessageAct build{tr("Build the averaged model"), [this] { buildModel(); }};
    bench_.study.isReadOnly() ? showReadOnly({sentence, build}) : bench_.window.banner().showOffer(sentence, build);
  });
  connect(&bench_.study, &StudyConnection::leaving, this, [this] { beside_ = {}; });
  connect(&bench_.feel_store, &FeelStore::said, this, [this](const QString& sentence) { bench_.window.say(sentence); });
  connect(&bench_.feel_store, &FeelStore::failed, this,
          [this](const QString& sentence, const MessageAct& act) { bench_.window.banner().showRemedy(sentence, act); });
}

void StudyFeature::offerBack(const QString& sentence, const MessageAct& back) {
  const auto earlier = bench_.carry.earlier();
  if (!earlier) {
    bench_.window.banner().showOffer(tr("%1 What was open before stays in the history.").arg(sentence), back);
    return;
  }
  bench_.compare.choose(CompareSide::kA, {CompareChoice::Kind::kOpen, 0, {}});
  bench_.compare.choose(CompareSide::kB, {CompareChoice::Kind::kState, earlier->state, {}});
  const QString name = harmless(text(bench_.edits.history().nameOf(earlier->state)));
  bench_.window.banner().showOffer(
      tr("%1 %n edit(s) of yours are in “%2”; Ctrl+B shows the new model and that version in turn.", nullptr,
         static_cast<int>(earlier->edits))
          .arg(sentence, name),
      {tr("Carry them over…"), [this, state = earlier->state] { bench_.views.carry->bringUp(state); }}, back);
}

// The question comes first, because the answer may be refused.
void StudyFeature::chooseNew() {
  auto* const which = new QComboBox(&bench_.window);
  const std::string language = programLanguage().toStdString();
  for (const std::string& id : procedure::builtInIds())
    which->addItem(text(procedure::builtIn(id)->titleIn(language)), text(id));
  which->addItem(tr("From a folder…"));
  auto* const dialog = new FormDialog(
      tr("New study"), tr("What is the study about? It keeps the procedure: inputs, words, form and pictures."),
      {{tr("&Procedure"), which}}, tr("Choose its file…"), &bench_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, which] {
    const QString id = which->currentData().toString();
    id.isEmpty() ? chooseProcedure() : makeStudy(procedure::builtIn(id.toStdString()));
  });
  dialog->open();
}

void StudyFeature::chooseProcedure() {
  const QString folder = file_dialog::getExistingDirectory(&bench_.window, tr("Choose the folder of a procedure"));
  if (folder.isEmpty()) return;
  auto read = session::readPack(folder.toStdString());
  if (read) {
    makeStudy(std::move(*read));
    return;
  }
  bench_.window.banner().showRemedy(tr("No study was made. %1").arg(harmless(text(read.error().message()))),
                                    {tr("Choose another folder…"), [this] { chooseProcedure(); }});
}

void StudyFeature::makeStudy(session::ProcedurePtr procedure) {
  const auto open = bench_.models.current();
  const QString folder = open ? QFileInfo(open->path).absolutePath() : QString();
  QString path = file_dialog::getSaveFileName(&bench_.window, tr("Make a study"), folder, tr("Studies (*.tactus)"),
                                              nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  bench_.study.create(path, std::move(procedure));
}

void StudyFeature::recordIntoStudy() {
  const auto open = bench_.models.current();
  const QString folder = open ? QFileInfo(open->path).absolutePath() : documentsFolder();
  const QString name = open ? QFileInfo(open->path).baseName() : tr("recordings");
  QString path =
      file_dialog::getSaveFileName(&bench_.window, tr("Record into a study: a new one, or one that is there"),
                                   folder + QLatin1Char('/') + name + QStringLiteral(".tactus"),
                                   tr("Studies (*.tactus)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  recorded_path_ = QFileInfo(path).absoluteFilePath();
  QFileInfo::exists(path) ? bench_.files.open(path) : bench_.study.create(path, bench_.scene.procedure());
}

bool StudyFeature::isToRecord() const { return bench_.study.isOpen() && bench_.study.path() == recorded_path_; }

// With its procedure where that is not the usual one.
QString StudyFeature::studyName() const {
  if (!bench_.study.isOpen()) return {};
  const session::ProcedurePtr& about = bench_.study.procedure();
  if (about->id == procedure::defaultProcedure()->id) return bench_.study.fileName();
  return tr("%1 (%2)").arg(bench_.study.fileName(), text(about->titleIn(programLanguage().toStdString())));
}

void StudyFeature::showState() {
  const bool open = bench_.study.isOpen() && !bench_.study.isOpening();
  const bool kept = bench_.study_models.keepsModel();
  const bool writable = open && bench_.study.takesOrders();
  put_->setEnabled(writable && bench_.models.current() && !kept);
  put_->setStatusTip(bench_.study.isReadOnly() ? tr("%1 is open for reading only.").arg(bench_.study.fileName())
                                               : QString());
  copy_->setEnabled(open);
  show_->setEnabled(open && bench_.study_models.hasModel() && !kept);
  build_->setEnabled(open);
  close_->setEnabled(open);
  bench_.files.showStudy(studyName(), bench_.study.readOnlyReason());
  bench_.window.strip().showStored(bench_.study_models.savedText(), !bench_.study.failure().isEmpty());
  // The end is asked for anew: what comes up then may take it back.
  if (ending_ && (!bench_.study.isBusy() || !bench_.study.failure().isEmpty())) {
    ending_ = false;
    bench_.window.close();
  }
}

void StudyFeature::onOpened() {
  bench_.recent.add(bench_.study.path());
  showState();
  if (bench_.study.isReadOnly()) {
    showReadOnly(beside_);
  } else if (isToRecord()) {
    bench_.window.enterLayout(feelLayout());
    bench_.feel_store.setRecording(true);
    bench_.window.say(tr("Armed: Start (F9), and what you feel is recorded into %1.").arg(bench_.study.fileName()));
  }
}

// What else is said of such a study does not take the place of the copy.
void StudyFeature::showReadOnly(ReadOnlyReason beside) {
  beside_ = std::move(beside);
  const QString locked =
      tr("%1 is open for reading only, because %2. Nothing can be stored in it; a copy can be changed.")
          .arg(bench_.study.fileName(), bench_.study.readOnlyReason());
  bench_.window.banner().showOffer(beside_.sentence.isEmpty() ? locked : locked + QLatin1Char(' ') + beside_.sentence,
                                   {tr("Save a copy…"), [this] { chooseCopy(); }}, beside_.act);
}

void StudyFeature::chooseCopy(bool go_on_there) {
  const QFileInfo file(bench_.study.path());
  const QString folder = bench_.study.isReadOnly() ? documentsFolder() : file.absolutePath();
  QString path =
      file_dialog::getSaveFileName(&bench_.window, tr("Save a copy of the study"),
                                   folder + QLatin1Char('/') + file.completeBaseName() + QStringLiteral("-copy.tactus"),
                                   tr("Studies (*.tactus)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  go_on_there ? bench_.study.moveTo(path) : bench_.study.saveCopy(path);
}

void StudyFeature::buildModel() {
  if (bench_.files.mayLoseChanges()) bench_.study_models.buildModel();
}

void StudyFeature::onFailed(const QString& path, const QString& sentence, const MessageAct& act) {
  if (path == recorded_path_) recorded_path_.clear();
  if (!bench_.study.failure().isEmpty()) {
    bench_.window.banner().showRemedy(sentence, {tr("Try again"), [this] { bench_.study.storeNow(); }}, nullptr,
                                      {tr("Go on in a copy…"), [this] { chooseCopy(true); }});
  } else if (!bench_.study.isOpen()) {
    bench_.window.banner().showRemedy(sentence, {tr("Open another file…"), [this] { bench_.files.choose(); }});
  } else {
    const MessageAct look{tr("Look at the study"), [this] { bench_.window.enter(Stage::kCollect); }};
    bench_.window.banner().showRemedy(sentence, act.text.isEmpty() ? look : act);
  }
  if (!QFileInfo::exists(path)) bench_.recent.remove(path);
  showState();
}

bool StudyFeature::mayEnd() {
  if (!bench_.study.isOpen()) return true;
  // The current placement and recording end and are stored.
  bench_.feel.stop();
  bench_.feel_store.setRecording(false);
  ending_ = false;
  if (bench_.study.failure().isEmpty()) {
    ending_ = bench_.study.isBusy();
    return !ending_;
  }
  const auto answer = QMessageBox::warning(
      &bench_.window, tr("Not stored"),
      tr("The last changes are not stored in %1: %2").arg(bench_.study.fileName(), bench_.study.failure()),
      QMessageBox::Retry | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Retry);
  if (answer == QMessageBox::Discard) return true;
  if (answer == QMessageBox::Retry) {
    bench_.study.storeNow();
    ending_ = true;
  }
  return false;
}

void addReport(Bench& bench) { bench.report = new ReportFeature(bench); }

void addStudy(Bench& bench) { bench.study_feature = new StudyFeature(bench); }

namespace {

struct ExportText {
  Q_DECLARE_TR_FUNCTIONS(ExportText)
};

void exportTables(Bench& bench, bool shareable) {
  const QFileInfo study(bench.study.path());
  const QString proposed = study.absolutePath() + QLatin1Char('/') + study.completeBaseName() +
                           (shareable ? QStringLiteral("-shareable") : QStringLiteral("-export"));
  const QString folder = file_dialog::getSaveFileName(&bench.window, ExportText::tr("New folder for the tables"),
                                                      proposed, {}, nullptr, QFileDialog::DontConfirmOverwrite);
  if (folder.isEmpty()) return;
  session::ExportOptions options;
  options.shareable = shareable;
  std::random_device chance;
  options.seed = (std::uint64_t{chance()} << 32U) | chance();
  bench.study.read(bench.features, [&bench, folder, options, shareable](const store::StudyFile& file) {
    return [&bench, folder, shareable, done = session::exportStudy(file, folder.toStdString(), options)] {
      if (!done) {
        bench.window.banner().showRemedy(
            ExportText::tr("Nothing was exported. %1").arg(text(done.error().message())),
            {ExportText::tr("Choose another folder…"), [&bench, shareable] { exportTables(bench, shareable); }});
        return;
      }
      QStringList notes;
      for (const std::string& note : done->notes) notes << text(note);
      bench.window.banner().showOffer(
          ExportText::tr("Exported %n participant(s) into %1. %2", nullptr, static_cast<int>(done->participants))
              .arg(shownFileName(folder), notes.join(QLatin1Char(' '))),
          {ExportText::tr("Open the folder"), [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); }});
    };
  });
}

}  // namespace

void addStudyExport(Bench& bench) {
  const std::pair<QString, bool> ways[] = {{ExportText::tr("Write &everything as tables…"), false},
                                           {ExportText::tr("Write tables &to share…"), true}};
  for (const auto& [name, shareable] : ways) {
    QAction* const action = bench.window.menus().addAction(MenuSlot::kStudyModel, name);
    followStudy(bench, action, [&bench] { return bench.study.isOpen() && !bench.collect.isSessionRunning(); });
    QObject::connect(action, &QAction::triggered, &bench.features,
                     [&bench, shareable = shareable] { exportTables(bench, shareable); });
  }
}

}  // namespace tactus::workbench
