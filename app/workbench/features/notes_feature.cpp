// What there is to say about the open study, and about work that was left behind.
#include <QAction>
#include <QCoreApplication>
#include <QMenuBar>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/study/study_notice_strip.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/terms/membership_editor.h"

namespace tactus::workbench {
namespace {

struct NotesFeature {
  Q_DECLARE_TR_FUNCTIONS(NotesFeature)
};

/// Below the menu bar.
void popUp(MainWindow& window, const QVector<NoteGroup>& groups) {
  const QMenuBar* bar = window.menuBar();
  showNotesPopup(window, bar->mapToGlobal(QPoint(theme::kGrid, bar->height() + 4)), groups);
}

}  // namespace

void addNotes(Bench& bench) {
  MainWindow& window = bench.window;
  QObject* const context = &bench.features;
  auto* strip = new StudyNoticeStrip(bench.study, &window);
  window.addStrip(strip);
  WindowMenus& menus = window.menus();
  QAction* const notices = menus.addAction(MenuSlot::kStudyNotes, NotesFeature::tr("Show what &happened to the study"));
  QAction* const data = menus.addAction(MenuSlot::kStudyNotes, NotesFeature::tr("&Look at the data first"));
  QAction* const build = menus.addAction(MenuSlot::kStudyNotes, NotesFeature::tr("Show the n&otes of the build"));
  QObject::connect(notices, &QAction::triggered, context, [&bench, strip] {
    strip->showAll();
    if (!bench.study.notices().before.isEmpty()) popUp(bench.window, noticeGroups(bench.study.notices()));
  });
  QObject::connect(data, &QAction::triggered, context,
                   [&bench] { popUp(bench.window, {dataGroup(bench.study_models.notes())}); });
  QObject::connect(build, &QAction::triggered, context,
                   [&bench] { popUp(bench.window, {buildGroup(bench.study_models.notes())}); });
  const auto show_notes = [&bench, data, build] {
    BuildNotes notes = bench.study_models.notes();
    data->setEnabled(!notes.data.empty());
    build->setEnabled(!notes.build.empty());
    const bool of_study = bench.study_models.keepsModel();
    if (!of_study) notes.build.clear();
    bench.window.header().showNotes(notes);
    // What is odd in the data of the study says nothing of terms that are of another model.
    bench.views.membership_editor->setNotes(of_study ? std::move(notes) : BuildNotes());
  };
  const auto show_notices = [&bench, notices] {
    const StudyNotices& told = bench.study.notices();
    notices->setEnabled(!told.now.empty() || !told.before.isEmpty());
    bench.window.header().showNotices(told);
  };
  QObject::connect(&bench.study_models, &StudyModels::notesChanged, context, show_notes);
  QObject::connect(&bench.study, &StudyConnection::noticesChanged, context, show_notices);
  // The notes of the build are of the study's model alone.
  QObject::connect(&bench.study_models, &StudyModels::savedChanged, context, show_notes);
  show_notes();
  show_notices();
}

namespace {

struct RecoveryFeature {
  Q_DECLARE_TR_FUNCTIONS(RecoveryFeature)

 public:
  static void connectRecovery(Bench& bench);
  static void connectAutosave(Bench& bench);
};

void RecoveryFeature::connectRecovery(Bench& bench) {
  RecoveryController& recovery = bench.recovery;
  QObject* const context = &bench.features;
  QObject::connect(&recovery, &RecoveryController::studyNeeded, &bench.study, &StudyConnection::open);
  QObject::connect(&recovery, &RecoveryController::restored, &bench.edits, &EditController::reported);
  QObject::connect(&recovery, &RecoveryController::notRestored, context,
                   [&bench](const QString& sentence, const LostWork& work) {
                     bench.window.banner().showRemedy(sentence, {tr("Try again"), [&bench, work] {
                                                                   if (bench.files.mayLoseChanges())
                                                                     bench.recovery.restoreWork(work);
                                                                 }});
                   });
  QObject::connect(&recovery, &RecoveryController::notDiscarded, context,
                   [&bench](const QString& sentence, const LostWork& work) {
                     bench.window.banner().showRemedy(
                         sentence, {tr("Try again"), [&bench, work] { bench.recovery.discardWork(work); }});
                   });
}

void RecoveryFeature::connectAutosave(Bench& bench) {
  AutosaveController& autosave = bench.autosave;
  MessageBanner& banner = bench.window.banner();
  QObject* const context = &bench.features;
  QObject::connect(&autosave, &AutosaveController::said, &banner, &MessageBanner::showNote);
  QObject::connect(&autosave, &AutosaveController::failed, context, [&bench, &banner](const QString& sentence) {
    banner.showRemedy(sentence, {tr("Save the model"), [&bench] { bench.files.save(); }}, &bench.autosave);
  });
  QObject::connect(&autosave, &AutosaveController::worksAgain, context,
                   [&bench, &banner] { banner.takeBack(bench.autosave); });
  const auto open = [&bench](const QString& path) { return [&bench, path] { bench.files.open(path); }; };
  QObject::connect(&autosave, &AutosaveController::notRead, context,
                   [&banner, open](const QString& sentence, const QString& document) {
                     banner.showRemedy(sentence, {tr("Open the model again"), open(document)});
                   });
  QObject::connect(&autosave, &AutosaveController::setAside, context,
                   [&banner, open](const QString& sentence, const QString& aside) {
                     banner.showRemedy(sentence, {tr("Open the earlier history"), open(aside)});
                   });
}

}  // namespace

void addRecovery(Bench& bench) {
  auto* strip = new RecoveryStrip(bench.recovery);
  bench.window.addStrip(strip);
  QObject::connect(strip, &RecoveryStrip::restoreRequested, &bench.features, [&bench] {
    if (bench.files.mayLoseChanges()) bench.recovery.restore();
  });
  RecoveryFeature::connectRecovery(bench);
  RecoveryFeature::connectAutosave(bench);
}

}  // namespace tactus::workbench
