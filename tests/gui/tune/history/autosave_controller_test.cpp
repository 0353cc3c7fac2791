#include "app/workbench/tune/history/autosave_controller.h"

#include <QFileInfo>
#include <gtest/gtest.h>

#include "tests/gui/tune/history/autosave_test.h"

namespace tactus::workbench {
namespace {

using AutosaveControllerTest = AutosaveTest;

TEST_F(AutosaveControllerTest, WritesSoonAfterAnEditWithoutBeingAsked) {
  std::vector<study::ModelVersion> wanted;
  {
    AutosavedRun run(root);
    run.open(path);
    QSignalSpy written(&run.autosave, &AutosaveController::written);
    run.edit(3);
    EXPECT_TRUE(run.autosave.file().isEmpty());
    ASSERT_TRUE(written.wait(tests::kPatience));
    EXPECT_TRUE(QFileInfo::exists(run.autosave.file()));
    wanted = editing::unstoredVersions(run.edits.history());
    run.models.save();
  }
  EXPECT_EQ(versions(), wanted);
  EXPECT_TRUE(HistoryFile::leftByCrash(root).empty()) << "an orderly end leaves no journal";
}

TEST_F(AutosaveControllerTest, AModelThatIsOnlyLookedAtLeavesNothing) {
  {
    AutosavedRun run(root);
    run.open(path);
    run.autosave.flush();
  }
  EXPECT_FALSE(QFileInfo::exists(root));
}

TEST_F(AutosaveControllerTest, WhatIsStoredInAStudyIsNotKept) {
  AutosavedRun run(root);
  OpenModel open = readOpenModel(path).value();
  open.path = folder.path(QStringLiteral("ward.tactus"));
  open.in_study = true;
  run.models.openRead(open);
  run.edit(3);
  run.autosave.flush();
  const QString kept = run.autosave.file();
  ASSERT_TRUE(QFileInfo::exists(kept));
  for (const auto& event : std::vector(run.edits.history().events())) run.edits.markStored(event.id);
  run.autosave.flush();
  EXPECT_FALSE(QFileInfo::exists(kept));
  EXPECT_TRUE(files().empty());
}

TEST_F(AutosaveControllerTest, SaysOnceWhereNothingCanBeKept) {
  // A file stands where the folder has to be.
  folder.writeText("", QStringLiteral("autosave"));
  AutosavedRun run(root);
  run.open(path);
  const QSignalSpy failed(&run.autosave, &AutosaveController::failed);
  for (int i = 0; i < 3; ++i) {
    run.edit(3 - i);
    run.autosave.flush();
    QCoreApplication::processEvents();
  }
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(root));
}

TEST_F(AutosaveControllerTest, TriesAgainWhereItFailed) {
  folder.writeText("", QStringLiteral("autosave"));
  ModelController models;
  EditController edits{models};
  models.open(path);
  AutosaveController autosave{models, edits, root, AutosaveController::Times{10, 10, 10}};
  QSignalSpy failed(&autosave, &AutosaveController::failed);
  QSignalSpy written(&autosave, &AutosaveController::written);
  edits.apply(editing::moveVertex(edits.model(), tests::kNearShoulder, 3));
  ASSERT_TRUE(failed.wait(tests::kPatience));
  // The disk has room again; nothing is edited any more.
  written.clear();
  ASSERT_TRUE(QFile::remove(root));
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(autosave.file()); }, tests::kPatience));
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(AutosaveControllerTest, TellsWhichWritingHoldsTheState) {
  AutosavedRun run(root);
  run.open(path);
  const QSignalSpy written(&run.autosave, &AutosaveController::written);
  run.edit(3);
  const quint64 first = run.autosave.flush();
  run.edit(2);
  const quint64 second = run.autosave.flush();
  EXPECT_LT(first, second);
  QCoreApplication::processEvents();
  ASSERT_FALSE(written.isEmpty());
  EXPECT_EQ(written.back()[0].toULongLong(), second);
}

}  // namespace
}  // namespace tactus::workbench
