// What a later run finds of the edits before: the history, and what a crash left.
#include <gtest/gtest.h>

#include "app/editing/edit.h"

#include "tests/gui/crashed.h"
#include "tests/gui/tune/history/autosave_test.h"

namespace tactus::workbench {
namespace {

using AutosaveReturnTest = AutosaveTest;

TEST_F(AutosaveReturnTest, TheHistoryOutlivesTheProgram) {
  {
    AutosavedRun run(root);
    run.open(path);
    run.edit(3);
    run.edits.undo();
    run.edit(1);
    run.edits.snapshot(QStringLiteral("short"));
    run.models.save();
  }
  AutosavedRun run(root);
  run.open(path);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_FALSE(run.models.isModified());
  EXPECT_EQ(run.shoulder(), 1);
  EXPECT_EQ(run.edits.history().states().size(), 3U);
  EXPECT_EQ(run.edits.history().events().size(), 5U);
  run.edits.returnTo(1);
  EXPECT_EQ(run.shoulder(), 3) << "the branch that was left";
  run.edits.undo();
  EXPECT_TRUE(editing::sameBits(run.edits.model(), tests::twoExperts()));
}

TEST_F(AutosaveReturnTest, ChangesThatWereGivenUpStayInTheHistoryAndAreNotOffered) {
  {
    AutosavedRun run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
    run.edit(2);
  }
  EXPECT_EQ(versions().back().label.substr(0, 6), "return");
  AutosavedRun run(root);
  run.open(path);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_EQ(run.shoulder(), 3);
  run.edits.returnTo(2);
  EXPECT_EQ(run.shoulder(), 2);
}

TEST_F(AutosaveReturnTest, ReopeningAndAnotherDocumentKeepTheHistoryToo) {
  AutosavedRun run(root);
  run.open(path);
  run.edit(3);
  run.open(path);
  EXPECT_TRUE(editing::sameBits(run.edits.model(), tests::twoExperts())) << "as its file has it";
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_EQ(run.edits.history().states().size(), 2U);
  run.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
  EXPECT_EQ(run.edits.history().states().size(), 1U);
}

TEST_F(AutosaveReturnTest, ACrashIsOfferedWhenTheDocumentIsOpened) {
  QString left;
  {
    AutosavedRun run(root);
    run.open(path);
    run.edit(3);
    run.edit(2);
    run.edits.begin();
    run.edits.update(editing::moveVertex(run.edits.base(), tests::kNearShoulder, 1.5));
    run.autosave.flush();
    left = tests::crashedCopy(root);
  }
  EXPECT_EQ(HistoryFile::leftByCrash(left).size(), 1);
  {
    AutosavedRun run(left);
    run.open(path);
    ASSERT_TRUE(run.autosave.lost());
    EXPECT_EQ(run.autosave.lost()->edits, 3);
    ASSERT_TRUE(run.autosave.lost()->drag);
    EXPECT_EQ(run.autosave.lost()->drag->model.inputs[1].terms[0].points[2], 1.5);
    EXPECT_TRUE(editing::sameBits(run.edits.model(), tests::twoExperts()));
    EXPECT_FALSE(run.models.isModified());
  }
  // Without an answer it is offered again, with an answer it is not.
  {
    AutosavedRun run(left);
    run.open(path);
    ASSERT_TRUE(run.autosave.lost());
    run.autosave.settleLost();
  }
  AutosavedRun run(left);
  run.open(path);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_EQ(run.edits.history().states().size(), 3U);
}

TEST_F(AutosaveReturnTest, ADragThatWasTakenBackIsNotOffered) {
  AutosavedRun run(root);
  run.open(path);
  run.edits.begin();
  run.edits.update(editing::moveVertex(run.edits.base(), tests::kNearShoulder, 3));
  run.autosave.flush();
  run.edits.cancel();
  run.autosave.flush();
  const QString left = tests::crashedCopy(root);
  AutosavedRun next(left);
  next.open(path);
  EXPECT_FALSE(next.autosave.lost());
}

}  // namespace
}  // namespace tactus::workbench
