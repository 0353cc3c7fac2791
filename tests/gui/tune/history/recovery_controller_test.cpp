#include "app/workbench/tune/history/recovery_controller.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/editing/same_bits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"

#include "tests/gui/crashed.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

const editing::VertexPlace kNearShoulder{{"depth", ""}, "near", 2};
constexpr int kPatience = 10'000;  // ms, for a busy machine

/// One run of the program.
struct Program {
  explicit Program(const QString& root) : root_(root) {}

  QString root_;
  ModelController models;
  EditController edits{models};
  AutosaveController autosave{models, edits, root_};
  RecoveryController recovery{models, edits, autosave, root_};
};

class RecoveryControllerTest : public testing::Test {
 protected:
  /// Two edits, one undone, another one, a snapshot, and a drag that goes on when the process dies.
  void crash() {
    Program run(root);
    run.models.open(path);
    const auto edit = [&](double to) { run.edits.apply(editing::moveVertex(run.edits.model(), kNearShoulder, to)); };
    edit(3);
    edit(2);
    run.edits.undo();
    edit(1);
    run.edits.snapshot(QStringLiteral("short"));
    run.edits.begin();
    run.edits.update(editing::moveVertex(run.edits.base(), kNearShoulder, 0.5));
    at_the_end = run.edits.model();
    run.autosave.flush();
    left = tests::crashedCopy(run.autosave.folder());
  }

  tests::ModelFolder folder;
  const QString root = folder.path(QStringLiteral("autosave"));
  const QString path = folder.write(tests::twoExperts());
  fuzzy::ForceModel at_the_end;
  QString left;
};

TEST_F(RecoveryControllerTest, BringsBackEveryBitAndEveryStep) {
  crash();
  Program next(root);
  const auto offer = next.recovery.offered();
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->document, path);
  EXPECT_EQ(offer->edits, 4);
  EXPECT_FALSE(offer->saved);
  QSignalSpy restored(&next.recovery, &RecoveryController::restored);
  next.recovery.restore();
  ASSERT_TRUE(restored.wait(kPatience));
  EXPECT_FALSE(next.recovery.offered());
  EXPECT_TRUE(editing::sameBits(next.models.current()->model, at_the_end));
  EXPECT_EQ(next.models.current()->path, path);
  EXPECT_TRUE(next.models.isModified());
  EXPECT_TRUE(next.edits.undoText().endsWith(QStringLiteral("(recovered)")));
  // The branch that was left is there too.
  EXPECT_EQ(next.edits.history().states().size(), 5U);
  next.edits.returnTo(2);
  EXPECT_EQ(next.models.current()->model.inputs[1].terms[0].points[2], 2);
  next.edits.undo();
  next.edits.undo();
  EXPECT_TRUE(editing::sameBits(next.models.current()->model, tests::twoExperts()));
  EXPECT_FALSE(next.edits.canUndo());
  // It is autosaved again before the old files go.
  ASSERT_TRUE(QTest::qWaitFor([&] { return !QFileInfo::exists(left); }, kPatience));
  EXPECT_TRUE(QFileInfo::exists(next.autosave.folder()));
  const QString again = tests::crashedCopy(next.autosave.folder());
  EXPECT_EQ(lostWork(root).size(), 1U);
}

TEST_F(RecoveryControllerTest, TheFilesStayUntilTheRestoredStateItselfIsWritten) {
  crash();
  // The disk of the autosaves is full: a file stands where the folder has to be.
  const QString full = folder.path(QStringLiteral("full"));
  folder.writeText("", QStringLiteral("full"));
  ModelController models;
  EditController edits{models};
  AutosaveController autosave{models, edits, full};
  RecoveryController recovery{models, edits, autosave, root};
  QSignalSpy restored(&recovery, &RecoveryController::restored);
  recovery.restore();
  ASSERT_TRUE(restored.wait(kPatience));
  QCoreApplication::processEvents();
  EXPECT_TRUE(QFileInfo::exists(left));
  // There is room again, but for another document: its autosave holds nothing of the restored work.
  ASSERT_TRUE(QFile::remove(full));
  models.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
  QSignalSpy written(&autosave, &AutosaveController::written);
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3));
  autosave.flush();
  ASSERT_TRUE(written.count() > 0 || written.wait(kPatience));
  EXPECT_TRUE(QFileInfo::exists(left));
  ASSERT_EQ(lostWork(root).size(), 1U) << "and it is offered again";
}

TEST_F(RecoveryControllerTest, LaterMeansWhenTheDocumentIsOpenedOrAtTheNextStart) {
  crash();
  {
    Program next(root);
    ASSERT_TRUE(next.recovery.offered());
    next.recovery.later();
    EXPECT_FALSE(next.recovery.offered());
    next.models.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
    EXPECT_FALSE(next.recovery.offered());
    next.models.open(path);
    EXPECT_TRUE(next.recovery.offered());
    next.recovery.later();
  }
  EXPECT_TRUE(QFileInfo::exists(left));
  EXPECT_TRUE(Program(root).recovery.offered());
}

TEST_F(RecoveryControllerTest, DiscardDeletesIt) {
  crash();
  Program next(root);
  next.recovery.discard();
  EXPECT_FALSE(next.recovery.offered());
  EXPECT_FALSE(QFileInfo::exists(left));
}

TEST_F(RecoveryControllerTest, OnlyOneWindowTakesIt) {
  crash();
  Program one(root);
  Program other(root);
  ASSERT_TRUE(one.recovery.offered());
  ASSERT_TRUE(other.recovery.offered());
  one.recovery.restore();
  const QSignalSpy failed(&other.recovery, &RecoveryController::failed);
  other.recovery.restore();
  EXPECT_EQ(failed.count(), 1);
  EXPECT_FALSE(other.recovery.offered());
  QSignalSpy restored(&one.recovery, &RecoveryController::restored);
  ASSERT_TRUE(restored.wait(kPatience));
}

TEST_F(RecoveryControllerTest, AModelWhoseFileIsGoneComesBackToo) {
  crash();
  ASSERT_TRUE(QFile::remove(path));
  Program next(root);
  QSignalSpy restored(&next.recovery, &RecoveryController::restored);
  next.recovery.restore();
  ASSERT_TRUE(restored.wait(kPatience));
  EXPECT_EQ(next.models.current()->model, at_the_end);
  EXPECT_TRUE(next.models.isModified());
  // Not even the model that was opened is in a file.
  while (next.edits.canUndo()) next.edits.undo();
  EXPECT_TRUE(next.models.isModified());
  next.models.save();
  EXPECT_FALSE(next.models.isModified());
  EXPECT_TRUE(QFileInfo::exists(path));
}

TEST_F(RecoveryControllerTest, AStudyGoesOnWhereItsHistoryEnds) {
  // A study has its history itself, and stores every edit; a drag that went on is all that can be lost.
  const QString study = folder.path(QStringLiteral("ward.tactus"));
  OpenModel open = readOpenModel(path).value();
  open.path = study;
  {
    Program run(root);
    run.models.openRead(open);
    run.edits.apply(editing::moveVertex(run.edits.model(), kNearShoulder, 3));
    for (const auto& event : std::vector(run.edits.history().events())) run.edits.markStored(event.id);
    run.edits.snapshot(QStringLiteral("not stored yet"));
    run.edits.begin();
    run.edits.update(editing::moveVertex(run.edits.base(), kNearShoulder, 2));
    run.autosave.flush();
    left = tests::crashedCopy(run.autosave.folder());
  }
  Program next(root);
  const QSignalSpy needed(&next.recovery, &RecoveryController::studyNeeded);
  QSignalSpy restored(&next.recovery, &RecoveryController::restored);
  next.recovery.restore();
  ASSERT_EQ(needed.count(), 1);
  EXPECT_EQ(needed[0][0].toString(), study);
  next.models.openRead(open);
  next.edits.apply(editing::moveVertex(next.edits.model(), kNearShoulder, 3));  // as the study has it
  ASSERT_TRUE(restored.wait(kPatience));
  EXPECT_EQ(next.models.current()->model.inputs[1].terms[0].points[2], 2);
  EXPECT_EQ(next.models.current()->path, study);
  const auto& events = next.edits.history().events();
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(events[2].kind, editing::EventKind::kSnapshot);
  EXPECT_EQ(events[2].label, "not stored yet");
  next.edits.undo();
  EXPECT_EQ(next.models.current()->model.inputs[1].terms[0].points[2], 3);
}

TEST_F(RecoveryControllerTest, WhatIsDamagedStaysWhereItIs) {
  crash();
  QFile part(QDir(left).filePath(QStringLiteral("part-00000.json")));
  ASSERT_TRUE(part.open(QIODevice::WriteOnly));
  part.write("{}");
  part.close();
  Program next(root);
  QSignalSpy failed(&next.recovery, &RecoveryController::failed);
  next.recovery.restore();
  ASSERT_TRUE(failed.wait(kPatience));
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("part-00000.json")));
  EXPECT_TRUE(QFileInfo::exists(left));
  EXPECT_FALSE(next.models.current());
}

}  // namespace
}  // namespace tactus::workbench
