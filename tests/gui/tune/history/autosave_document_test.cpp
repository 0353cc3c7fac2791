// What becomes of the history where the document itself changed, moved, was copied or is open twice.
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/edit.h"

#include "tests/gui/tune/history/autosave_test.h"

namespace tactus::workbench {
namespace {

using AutosaveDocumentTest = AutosaveTest;

TEST_F(AutosaveDocumentTest, AFileThatAnotherProgramChangedIsSaidAndUndoLeadsBack) {
  editAndSave();
  fuzzy::ForceModel theirs = tests::twoExperts();
  theirs.name = "from elsewhere";
  folder.write(theirs);
  AutosavedRun run(root);
  const QSignalSpy said(&run.autosave, &AutosaveController::said);
  run.open(path);
  ASSERT_EQ(said.count(), 1);
  EXPECT_EQ(run.edits.model().name, "from elsewhere");
  EXPECT_FALSE(run.models.isModified());
  EXPECT_FALSE(run.autosave.lost());
  run.edits.undo();
  EXPECT_EQ(run.shoulder(), 3);
}

TEST_F(AutosaveDocumentTest, AFileWithOtherInputsBeginsAHistoryAndTheOldOneOpensAsAStudy) {
  editAndSave();
  fuzzy::ForceModel other = tests::twoExperts();
  other.inputs.push_back(other.inputs.back());
  other.inputs.back().id = "angle";
  folder.write(other);
  AutosavedRun run(root);
  const QSignalSpy failed(&run.autosave, &AutosaveController::setAside);
  run.open(path);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("-before-1.tactus")))
      << failed[0][0].toString().toStdString();
  EXPECT_EQ(run.edits.history().events().size(), 1U);
  ASSERT_EQ(files().size(), 1);
  const auto aside = HistoryFile::read(QDir(root).filePath(files()[0]), true);
  ASSERT_TRUE(aside);
  EXPECT_EQ(aside->kept.versions.size(), 2U);
}

TEST_F(AutosaveDocumentTest, TwoWindowsKeepBothHistories) {
  {
    AutosavedRun one(root);
    one.open(path);
    one.edit(3);
    one.autosave.flush();
    AutosavedRun other(root);
    other.open(path);
    EXPECT_EQ(other.edits.history().events().size(), 1U) << "the history is in the hands of the first window";
    other.edit(2);
    other.autosave.flush();
    EXPECT_EQ(files().size(), 2);
    one.models.save();
  }
  AutosavedRun run(root);
  run.open(path);
  EXPECT_EQ(files().size(), 1);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_EQ(run.shoulder(), 3);
  EXPECT_FALSE(run.models.isModified());
  const auto& states = run.edits.history().states();
  const bool has_other = std::any_of(states.begin(), states.end(), [&](const editing::State& state) {
    const auto at = static_cast<editing::StateId>(&state - states.data());
    return run.edits.history().modelOf(at)->inputs[1].terms[0].points[2] == 2;
  });
  EXPECT_TRUE(has_other);
}

TEST_F(AutosaveDocumentTest, TheHistoryFollowsAFileThatWasMoved) {
  editAndSave();
  const QString moved = folder.path(QStringLiteral("moved.tactus.json"));
  ASSERT_TRUE(QFile::rename(path, moved));
  AutosavedRun run(root);
  run.open(moved);
  EXPECT_EQ(run.edits.history().states().size(), 2U);
  ASSERT_EQ(files().size(), 1);
  EXPECT_TRUE(files()[0].startsWith(QStringLiteral("moved-")));
}

TEST_F(AutosaveDocumentTest, ACopyOfAFileHasAHistoryOfItsOwn) {
  editAndSave();
  const QString copy = folder.path(QStringLiteral("copy.tactus.json"));
  ASSERT_TRUE(QFile::copy(path, copy));
  AutosavedRun run(root);
  run.open(copy);
  EXPECT_EQ(run.edits.history().states().size(), 1U);
}

TEST_F(AutosaveDocumentTest, SaveAsTakesTheHistoryAlongAndLeavesTheFirstFileInOrder) {
  {
    AutosavedRun run(root);
    run.open(path);
    run.edit(3);
    run.models.saveAs(folder.path(QStringLiteral("second.tactus.json")));
    run.edit(2);
    run.models.save();
  }
  EXPECT_EQ(files().size(), 2);
  {
    AutosavedRun run(root);
    run.open(folder.path(QStringLiteral("second.tactus.json")));
    EXPECT_EQ(run.edits.history().states().size(), 3U);
    EXPECT_EQ(run.shoulder(), 2);
    EXPECT_FALSE(run.autosave.lost());
  }
  AutosavedRun run(root);
  run.open(path);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_TRUE(editing::sameBits(run.edits.model(), tests::twoExperts()));
  EXPECT_EQ(run.edits.history().states().size(), 2U);
}

TEST_F(AutosaveDocumentTest, ADamagedHistoryIsReportedAndStays) {
  editAndSave();
  const QString first = QDir(root).filePath(files().value(0));
  QFile file(first);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray(5000, 'x'));
  file.close();
  AutosavedRun run(root);
  const QSignalSpy failed(&run.autosave, &AutosaveController::notRead);
  run.open(path);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(first)) << failed[0][0].toString().toStdString();
  run.edit(2);
  run.autosave.flush();
  EXPECT_EQ(QFileInfo(first).size(), 5000);
  EXPECT_NE(run.autosave.file(), first);
  EXPECT_TRUE(QFileInfo::exists(run.autosave.file()));
}

}  // namespace
}  // namespace tactus::workbench
