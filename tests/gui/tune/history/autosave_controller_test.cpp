#include "app/workbench/tune/history/autosave_controller.h"

#include <QDir>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

#include "app/editing/membership_edits.h"
#include "app/editing/same_bits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"

#include "tests/gui/crashed.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using tests::kNearShoulder;
using tests::kPatience;

/// One run of the program.
struct Program {
  explicit Program(const QString& root) : autosave(models, edits, root) {}

  /// Opens `path`, and waits until its earlier history was looked for.
  void open(const QString& path) {
    QSignalSpy looked_up(&autosave, &AutosaveController::lookedUp);
    models.open(path);
    ASSERT_TRUE(looked_up.count() > 0 || looked_up.wait(kPatience));
  }
  void edit(double to) { ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearShoulder, to))); }
  double shoulder() const { return edits.model().inputs[1].terms[0].points[2]; }

  ModelController models;
  EditController edits{models};
  AutosaveController autosave;
};

class AutosaveControllerTest : public testing::Test {
 protected:
  QStringList files() const { return QDir(root).entryList({QStringLiteral("*.tactus")}, QDir::Files, QDir::Name); }
  /// The versions in the only history file, which no program has open.
  std::vector<study::ModelVersion> versions() const {
    EXPECT_EQ(files().size(), 1);
    const auto work = HistoryFile::read(QDir(root).filePath(files().value(0)), true);
    EXPECT_TRUE(work) << work.error().message();
    return work ? work->kept.versions : std::vector<study::ModelVersion>();
  }

  tests::ModelFolder folder;
  const QString root = folder.path(QStringLiteral("autosave"));
  const QString path = folder.write(tests::twoExperts());
};

TEST_F(AutosaveControllerTest, WritesSoonAfterAnEditWithoutBeingAsked) {
  std::vector<study::ModelVersion> wanted;
  {
    Program run(root);
    run.open(path);
    QSignalSpy written(&run.autosave, &AutosaveController::written);
    run.edit(3);
    EXPECT_TRUE(run.autosave.file().isEmpty());
    ASSERT_TRUE(written.wait(kPatience));
    EXPECT_TRUE(QFileInfo::exists(run.autosave.file()));
    wanted = editing::unstoredVersions(run.edits.history());
    run.models.save();
  }
  EXPECT_EQ(versions(), wanted);
  EXPECT_TRUE(HistoryFile::leftByCrash(root).empty()) << "an orderly end leaves no journal";
}

TEST_F(AutosaveControllerTest, AModelThatIsOnlyLookedAtLeavesNothing) {
  {
    Program run(root);
    run.open(path);
    run.autosave.flush();
  }
  EXPECT_FALSE(QFileInfo::exists(root));
}

TEST_F(AutosaveControllerTest, TheHistoryOutlivesTheProgram) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.edits.undo();
    run.edit(1);
    run.edits.snapshot(QStringLiteral("short"));
    run.models.save();
  }
  Program run(root);
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

TEST_F(AutosaveControllerTest, ChangesThatWereGivenUpStayInTheHistoryAndAreNotOffered) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
    run.edit(2);
  }
  EXPECT_EQ(versions().back().label.substr(0, 6), "return");
  Program run(root);
  run.open(path);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_EQ(run.shoulder(), 3);
  run.edits.returnTo(2);
  EXPECT_EQ(run.shoulder(), 2);
}

TEST_F(AutosaveControllerTest, ReopeningAndAnotherDocumentKeepTheHistoryToo) {
  Program run(root);
  run.open(path);
  run.edit(3);
  run.open(path);
  EXPECT_TRUE(editing::sameBits(run.edits.model(), tests::twoExperts())) << "as its file has it";
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_EQ(run.edits.history().states().size(), 2U);
  run.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
  EXPECT_EQ(run.edits.history().states().size(), 1U);
}

TEST_F(AutosaveControllerTest, ACrashIsOfferedWhenTheDocumentIsOpened) {
  QString left;
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.edit(2);
    run.edits.begin();
    run.edits.update(editing::moveVertex(run.edits.base(), kNearShoulder, 1.5));
    run.autosave.flush();
    left = tests::crashedCopy(root);
  }
  EXPECT_EQ(HistoryFile::leftByCrash(left).size(), 1);
  {
    Program run(left);
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
    Program run(left);
    run.open(path);
    ASSERT_TRUE(run.autosave.lost());
    run.autosave.settleLost();
  }
  Program run(left);
  run.open(path);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_EQ(run.edits.history().states().size(), 3U);
}

TEST_F(AutosaveControllerTest, ADragThatWasTakenBackIsNotOffered) {
  Program run(root);
  run.open(path);
  run.edits.begin();
  run.edits.update(editing::moveVertex(run.edits.base(), kNearShoulder, 3));
  run.autosave.flush();
  run.edits.cancel();
  run.autosave.flush();
  const QString left = tests::crashedCopy(root);
  Program next(left);
  next.open(path);
  EXPECT_FALSE(next.autosave.lost());
}

TEST_F(AutosaveControllerTest, AFileThatAnotherProgramChangedIsSaidAndUndoLeadsBack) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
  }
  fuzzy::ForceModel theirs = tests::twoExperts();
  theirs.name = "from elsewhere";
  folder.write(theirs);
  Program run(root);
  const QSignalSpy said(&run.autosave, &AutosaveController::said);
  run.open(path);
  ASSERT_EQ(said.count(), 1);
  EXPECT_EQ(run.edits.model().name, "from elsewhere");
  EXPECT_FALSE(run.models.isModified());
  EXPECT_FALSE(run.autosave.lost());
  run.edits.undo();
  EXPECT_EQ(run.shoulder(), 3);
}

TEST_F(AutosaveControllerTest, AFileWithOtherInputsBeginsAHistoryAndTheOldOneOpensAsAStudy) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
  }
  fuzzy::ForceModel other = tests::twoExperts();
  other.inputs.push_back(other.inputs.back());
  other.inputs.back().id = "angle";
  folder.write(other);
  Program run(root);
  const QSignalSpy failed(&run.autosave, &AutosaveController::failed);
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

TEST_F(AutosaveControllerTest, TwoWindowsKeepBothHistories) {
  {
    Program one(root);
    one.open(path);
    one.edit(3);
    one.autosave.flush();
    Program other(root);
    other.open(path);
    EXPECT_EQ(other.edits.history().events().size(), 1U) << "the history is in the hands of the first window";
    other.edit(2);
    other.autosave.flush();
    EXPECT_EQ(files().size(), 2);
    one.models.save();
  }
  Program run(root);
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

TEST_F(AutosaveControllerTest, TheHistoryFollowsAFileThatWasMoved) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
  }
  const QString moved = folder.path(QStringLiteral("moved.tactus.json"));
  ASSERT_TRUE(QFile::rename(path, moved));
  Program run(root);
  run.open(moved);
  EXPECT_EQ(run.edits.history().states().size(), 2U);
  ASSERT_EQ(files().size(), 1);
  EXPECT_TRUE(files()[0].startsWith(QStringLiteral("moved-")));
}

TEST_F(AutosaveControllerTest, ACopyOfAFileHasAHistoryOfItsOwn) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
  }
  const QString copy = folder.path(QStringLiteral("copy.tactus.json"));
  ASSERT_TRUE(QFile::copy(path, copy));
  Program run(root);
  run.open(copy);
  EXPECT_EQ(run.edits.history().states().size(), 1U);
}

TEST_F(AutosaveControllerTest, SaveAsTakesTheHistoryAlongAndLeavesTheFirstFileInOrder) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.models.saveAs(folder.path(QStringLiteral("second.tactus.json")));
    run.edit(2);
    run.models.save();
  }
  EXPECT_EQ(files().size(), 2);
  {
    Program run(root);
    run.open(folder.path(QStringLiteral("second.tactus.json")));
    EXPECT_EQ(run.edits.history().states().size(), 3U);
    EXPECT_EQ(run.shoulder(), 2);
    EXPECT_FALSE(run.autosave.lost());
  }
  Program run(root);
  run.open(path);
  EXPECT_FALSE(run.autosave.lost());
  EXPECT_TRUE(editing::sameBits(run.edits.model(), tests::twoExperts()));
  EXPECT_EQ(run.edits.history().states().size(), 2U);
}

TEST_F(AutosaveControllerTest, WhatIsStoredInAStudyIsNotKept) {
  Program run(root);
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

TEST_F(AutosaveControllerTest, ADamagedHistoryIsReportedAndStays) {
  {
    Program run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
  }
  const QString first = QDir(root).filePath(files().value(0));
  QFile file(first);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray(5000, 'x'));
  file.close();
  Program run(root);
  const QSignalSpy failed(&run.autosave, &AutosaveController::failed);
  run.open(path);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(first)) << failed[0][0].toString().toStdString();
  run.edit(2);
  run.autosave.flush();
  EXPECT_EQ(QFileInfo(first).size(), 5000);
  EXPECT_NE(run.autosave.file(), first);
  EXPECT_TRUE(QFileInfo::exists(run.autosave.file()));
}

TEST_F(AutosaveControllerTest, SaysOnceWhereNothingCanBeKept) {
  // A file stands where the folder has to be.
  folder.writeText("", QStringLiteral("autosave"));
  Program run(root);
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
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3));
  ASSERT_TRUE(failed.wait(kPatience));
  // The disk has room again; nothing is edited any more.
  written.clear();
  ASSERT_TRUE(QFile::remove(root));
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(autosave.file()); }, kPatience));
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(AutosaveControllerTest, TellsWhichWritingHoldsTheState) {
  Program run(root);
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
