#include "app/workbench/tune/history/recovery_controller.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/editing/membership_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "core/store/model_versions.h"

#include "tests/gui/crashed.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using tests::kNearShoulder;
using tests::kPatience;

/// One run of the program. It has looked for lost work when it is made.
struct SecondRun {
  explicit SecondRun(const QString& root) : autosave(models, edits, root), recovery(models, edits, autosave, root) {
    settle();
  }

  /// Lets the worker and the window finish what they do.
  void settle() {
    for (int i = 0; i < 3; ++i) {
      autosave.wait();
      QCoreApplication::processEvents();
    }
  }
  void open(const QString& path) {
    models.open(path);
    settle();
  }
  /// Restores what is offered, and waits for the end.
  void restore() {
    QSignalSpy restored(&recovery, &RecoveryController::restored);
    recovery.restore();
    EXPECT_TRUE(restored.count() > 0 || restored.wait(kPatience));
    settle();
  }
  double shoulder() const { return edits.model().inputs[1].terms[0].points[2]; }

  ModelController models;
  EditController edits{models};
  AutosaveController autosave;
  RecoveryController recovery;
};

class RecoveryControllerTest : public testing::Test {
 protected:
  /// Two edits, one undone, another one, a snapshot, and a drag that is in progress when the process dies.
  void crash() {
    SecondRun run(root);
    run.open(path);
    edit(run);
    at_the_end = run.edits.model();
    history = run.edits.history();
    run.autosave.flush();
    left = tests::crashedCopy(root);
  }
  static void edit(SecondRun& run) {
    const auto edit = [&](double to) { run.edits.apply(editing::moveVertex(run.edits.model(), kNearShoulder, to)); };
    edit(3);
    edit(2);
    run.edits.undo();
    edit(1);
    run.edits.snapshot(QStringLiteral("short"));
    run.edits.begin();
    run.edits.update(editing::moveVertex(run.edits.base(), kNearShoulder, 0.5));
  }
  void expectRestored(SecondRun& next) const {
    EXPECT_FALSE(next.recovery.offered());
    EXPECT_TRUE(editing::sameBits(next.models.current()->model, at_the_end));
    EXPECT_EQ(next.models.current()->path, path);
    EXPECT_TRUE(next.models.isModified());
    EXPECT_TRUE(next.edits.undoText().endsWith(QStringLiteral("(recovered)"))) << next.edits.undoText().toStdString();
    // The branch that was left is there too.
    EXPECT_EQ(next.edits.history().states().size(), 5U);
    next.edits.returnTo(2);
    EXPECT_EQ(next.shoulder(), 2);
    next.edits.undo();
    next.edits.undo();
    EXPECT_TRUE(editing::sameBits(next.models.current()->model, tests::twoExperts()));
    EXPECT_FALSE(next.edits.canUndo());
  }
  tests::ModelFolder folder;
  const QString root = folder.path(QStringLiteral("autosave"));
  const QString path = folder.write(tests::twoExperts());
  fuzzy::ForceModel at_the_end;
  editing::EditHistory history = editing::EditHistory::open(tests::twoExperts(), "", {}, study::RecordIds()).value();
  QString left;  ///< the folder that the crash left
};

TEST_F(RecoveryControllerTest, BringsBackEveryBitAndEveryStep) {
  crash();
  SecondRun next(left);
  const auto offer = next.recovery.offered();
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->document, path);
  EXPECT_EQ(offer->edits, 4);
  next.restore();
  expectRestored(next);
}

TEST_F(RecoveryControllerTest, TheSameWhereTheDocumentWasOpenedFirst) {
  crash();
  SecondRun next(left);
  next.open(path);
  const auto offer = next.recovery.offered();
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->edits, 4);
  EXPECT_EQ(next.recovery.others(), 0);
  EXPECT_TRUE(editing::sameBits(next.models.current()->model, tests::twoExperts()));
  next.restore();
  expectRestored(next);
}

TEST_F(RecoveryControllerTest, ASecondCrashLosesNothingEither) {
  crash();
  SecondRun next(left);
  next.restore();
  next.autosave.flush();
  const QString again = tests::crashedCopy(left);
  SecondRun third(again);
  ASSERT_TRUE(third.recovery.offered());
  third.restore();
  EXPECT_TRUE(editing::sameBits(third.models.current()->model, at_the_end));
}

TEST_F(RecoveryControllerTest, WhatWasSavedNeedsNoOffer) {
  {
    SecondRun run(root);
    run.open(path);
    run.edits.apply(editing::moveVertex(run.edits.model(), kNearShoulder, 3));
    run.models.save();
    run.autosave.flush();
    left = tests::crashedCopy(root);
  }
  SecondRun next(left);
  EXPECT_FALSE(next.recovery.offered());
  next.open(path);
  EXPECT_FALSE(next.recovery.offered());
  EXPECT_TRUE(next.edits.canUndo());
}

TEST_F(RecoveryControllerTest, LaterMeansWhenTheDocumentIsOpenedOrAtTheNextStart) {
  crash();
  {
    SecondRun next(left);
    ASSERT_TRUE(next.recovery.offered());
    next.recovery.later();
    EXPECT_FALSE(next.recovery.offered());
    next.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
    EXPECT_FALSE(next.recovery.offered());
  }
  {
    SecondRun next(left);
    ASSERT_TRUE(next.recovery.offered());
    next.recovery.later();
    next.open(path);
    EXPECT_TRUE(next.recovery.offered());
    next.recovery.later();
    EXPECT_FALSE(next.recovery.offered());
  }
  SecondRun next(left);
  next.open(path);
  EXPECT_TRUE(next.recovery.offered());
}

TEST_F(RecoveryControllerTest, DiscardKeepsTheFileAndLeavesTheEditsInItsHistory) {
  crash();
  {
    SecondRun next(left);
    next.recovery.discard();
    EXPECT_FALSE(next.recovery.offered());
  }
  SecondRun next(left);
  EXPECT_FALSE(next.recovery.offered());
  next.open(path);
  EXPECT_FALSE(next.recovery.offered());
  EXPECT_TRUE(editing::sameBits(next.models.current()->model, tests::twoExperts()));
  EXPECT_EQ(next.edits.history().states().size(), 4U);
}

TEST_F(RecoveryControllerTest, AWindowThatHasTheDocumentOpenKeepsItsWork) {
  crash();
  SecondRun one(left);
  SecondRun other(left);
  ASSERT_TRUE(one.recovery.offered());
  ASSERT_TRUE(other.recovery.offered());
  one.restore();
  const QSignalSpy failed(&other.recovery, &RecoveryController::notRestored);
  other.recovery.restore();
  other.settle();
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(RecoveryControllerTest, AModelWhoseFileIsGoneComesBackToo) {
  crash();
  ASSERT_TRUE(QFile::remove(path));
  SecondRun next(left);
  next.restore();
  EXPECT_EQ(next.models.current()->model, at_the_end);
  EXPECT_TRUE(next.models.isModified());
  // Not even the model that was opened is in a file.
  while (next.edits.canUndo()) next.edits.undo();
  EXPECT_TRUE(next.models.isModified());
  next.models.save();
  EXPECT_FALSE(next.models.isModified());
  EXPECT_TRUE(QFileInfo::exists(path));
  next.autosave.flush();
  EXPECT_EQ(QDir(left).entryList({QStringLiteral("*.tactus")}).size(), 1) << "the history goes on in its file";
}

TEST_F(RecoveryControllerTest, AStudyGoesOnWhereItsHistoryEnds) {
  // A study has its history itself, and stores every edit; a drag in progress is all that can be lost.
  const QString study = folder.path(QStringLiteral("ward.tactus"));
  OpenModel open = readOpenModel(path).value();
  open.path = study;
  open.in_study = true;
  {
    SecondRun run(root);
    run.models.openRead(open);
    run.edits.apply(editing::moveVertex(run.edits.model(), kNearShoulder, 3));
    for (const auto& event : std::vector(run.edits.history().events())) run.edits.markStored(event.id);
    run.edits.snapshot(QStringLiteral("not stored yet"));
    run.edits.begin();
    run.edits.update(editing::moveVertex(run.edits.base(), kNearShoulder, 2));
    run.autosave.flush();
    left = tests::crashedCopy(root);
  }
  SecondRun next(left);
  const QSignalSpy needed(&next.recovery, &RecoveryController::studyNeeded);
  QSignalSpy restored(&next.recovery, &RecoveryController::restored);
  next.recovery.restore();
  ASSERT_EQ(needed.count(), 1);
  EXPECT_EQ(needed[0][0].toString(), study);
  next.models.openRead(open);
  next.edits.apply(editing::moveVertex(next.edits.model(), kNearShoulder, 3));  // as the study has it
  ASSERT_TRUE(restored.count() > 0 || restored.wait(kPatience));
  EXPECT_EQ(next.shoulder(), 2);
  EXPECT_EQ(next.models.current()->path, study);
  const auto& events = next.edits.history().events();
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(events[2].kind, editing::EventKind::kSnapshot);
  EXPECT_EQ(events[2].label, "not stored yet");
  next.edits.undo();
  EXPECT_EQ(next.shoulder(), 3);
}

TEST_F(RecoveryControllerTest, WorkOfANewerTactusStaysInPlaceWithASentence) {
  const QString study = folder.path(QStringLiteral("ward.tactus"));
  OpenModel open = readOpenModel(path).value();
  open.path = study;
  open.in_study = true;
  {
    SecondRun run(root);
    run.models.openRead(open);
    run.edits.apply(editing::moveVertex(run.edits.model(), kNearShoulder, 3));
    run.autosave.flush();
    left = tests::crashedCopy(root);
  }
  // A newer program has written one more state into what the crash left.
  const QStringList files = QDir(left).entryList({QStringLiteral("*.tactus")}, QDir::Files);
  ASSERT_EQ(files.size(), 1);
  const QString kept = QDir(left).filePath(files[0]);
  {
    auto file = store::StudyFile::open(kept.toStdString());
    ASSERT_TRUE(file) << file.error().message();
    study::ModelVersion newer = store::latestModelVersion(*file).value().value();
    newer.parent = newer.id;
    newer.id = study::RecordIds().next();
    newer.label = "edit: of a newer program";
    const std::size_t at = newer.text.find("\"version\": 1");
    ASSERT_NE(at, std::string::npos);
    newer.text.replace(at, 12, "\"version\": 99");
    newer.sha256.clear();
    ASSERT_TRUE(store::append(*file, newer));
    left = tests::crashedCopy(left);
  }
  const QString left_work = QDir(left).filePath(files[0]);
  SecondRun next(left);
  QSignalSpy failed(&next.recovery, &RecoveryController::notRestored);
  next.recovery.restore();
  next.models.openRead(open);
  ASSERT_TRUE(failed.count() > 0 || failed.wait(kPatience));
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("99"))) << failed[0][0].toString().toStdString();
  EXPECT_TRUE(QFileInfo::exists(left_work));
  EXPECT_TRUE(editing::sameBits(next.edits.model(), open.model)) << "nothing of it is shown";
}

}  // namespace
}  // namespace tactus::workbench
