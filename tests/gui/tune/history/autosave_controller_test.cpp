#include "app/workbench/tune/history/autosave_controller.h"

#include <QDir>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>
#include <memory>

#include "app/editing/membership_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"

#include "tests/gui/crashed.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

const editing::VertexPlace kNearShoulder{{"depth", ""}, "near", 2};
constexpr int kPatience = 10'000;  // ms, for a busy machine

class AutosaveControllerTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  void edit(double to) { ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearShoulder, to))); }
  QStringList parts() {
    return QDir(autosave->folder()).entryList({QStringLiteral("part-*.json")}, QDir::Files, QDir::Name);
  }
  editing::Autosave content(const QString& part) {
    QFile file(QDir(autosave->folder()).filePath(part));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return editing::parseAutosave(file.readAll().toStdString(), part.toStdString()).value();
  }

  tests::ModelFolder folder;
  const QString root = folder.path(QStringLiteral("autosave"));
  ModelController models;
  EditController edits{models};
  std::unique_ptr<AutosaveController> autosave = std::make_unique<AutosaveController>(models, edits, root);
};

TEST_F(AutosaveControllerTest, WritesSoonAfterAnEditWithoutBeingAsked) {
  QSignalSpy written(autosave.get(), &AutosaveController::written);
  edit(3);
  EXPECT_TRUE(autosave->folder().isEmpty());
  ASSERT_TRUE(written.wait(kPatience));
  ASSERT_EQ(parts().size(), 1);
  const auto saved = content(parts()[0]);
  EXPECT_EQ(saved.document, models.current()->path.toStdString());
  EXPECT_EQ(saved.versions, editing::unstoredVersions(edits.history()));
  // A living process has lost nothing.
  EXPECT_TRUE(lostWork(root).empty());
}

TEST_F(AutosaveControllerTest, WritesTheGestureThatGoesOn) {
  edits.begin();
  edits.update(editing::moveVertex(edits.base(), kNearShoulder, 3));
  autosave->flush();
  const auto saved = content(parts().value(0));
  ASSERT_TRUE(saved.unfinished);
  EXPECT_EQ(saved.unfinished->model.inputs[1].terms[0].points[2], 3);
  edits.cancel();
  autosave->flush();
  EXPECT_TRUE(autosave->folder().isEmpty());
}

TEST_F(AutosaveControllerTest, AModelThatIsOnlyLookedAtLeavesNothing) {
  autosave->flush();
  EXPECT_TRUE(autosave->folder().isEmpty());
  EXPECT_FALSE(QFileInfo::exists(root));
}

TEST_F(AutosaveControllerTest, WhatIsStoredInAStudyIsNotKept) {
  edit(3);
  autosave->flush();
  const QString path = autosave->folder();
  ASSERT_TRUE(QFileInfo::exists(path));
  const auto events = edits.history().events();
  for (const auto& event : events) edits.markStored(event.id);
  autosave->flush();
  EXPECT_FALSE(QFileInfo::exists(path));
}

TEST_F(AutosaveControllerTest, WhatAStudyHasNotStoredIsNotSaved) {
  OpenModel open = *models.current();
  open.path = folder.path(QStringLiteral("ward.tactus"));
  open.in_study = true;
  models.openRead(open);
  edit(3);
  autosave->flush();
  tests::crashedCopy(autosave->folder());
  const auto lost = lostWork(root);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_FALSE(lost[0].saved);
}

TEST_F(AutosaveControllerTest, AnOrderlyEndAndAnotherDocumentLeaveNothing) {
  edit(3);
  autosave->flush();
  const QString path = autosave->folder();
  models.reopen();
  autosave->flush();
  EXPECT_FALSE(QFileInfo::exists(path));
  edit(2);
  autosave->flush();
  const QString second = autosave->folder();
  ASSERT_TRUE(QFileInfo::exists(second));
  autosave.reset();
  EXPECT_FALSE(QFileInfo::exists(second));
}

TEST_F(AutosaveControllerTest, ALongHistoryIsWrittenInPartsThatAreNotWrittenAgain) {
  for (int i = 0; i < 60; ++i) edit(i % 2 == 0 ? 3 : 2);
  autosave->flush();
  ASSERT_EQ(parts().size(), 2);
  const QString first = QDir(autosave->folder()).filePath(parts()[0]);
  EXPECT_EQ(content(parts()[0]).versions.size(), 50U);
  EXPECT_EQ(content(parts()[1]).versions.size(), 11U);
  // Nobody may touch it any more.
  QFile marked(first);
  ASSERT_TRUE(marked.open(QIODevice::Append));
  marked.write("\n");
  marked.close();
  const qint64 size = QFileInfo(first).size();
  for (int i = 0; i < 40; ++i) edit(i % 2 == 0 ? 1 : 2);
  autosave->flush();
  EXPECT_EQ(parts().size(), 3);
  EXPECT_EQ(QFileInfo(first).size(), size);
  EXPECT_EQ(content(parts()[2]).versions.size(), 1U);
}

TEST_F(AutosaveControllerTest, PartsOfALargeModelAreClosedSooner) {
  fuzzy::ForceModel large = models.current()->model;
  large.provenance.emplace().notes = std::string(std::size_t{3} << 20U, 'x');
  models.open(folder.write(large));
  edit(3);
  edit(2);  // 9 MB with the model that was opened
  autosave->flush();
  ASSERT_EQ(parts().size(), 1);
  edit(1);
  autosave->flush();
  ASSERT_EQ(parts().size(), 2);
  EXPECT_EQ(content(parts()[0]).versions.size(), 3U);
  EXPECT_EQ(content(parts()[1]).versions.size(), 1U);
  // A drag does not begin parts of its own.
  edits.begin();
  for (const double to : {2.0, 3.0, 2.5}) {
    edits.update(editing::moveVertex(edits.base(), kNearShoulder, to));
    autosave->flush();
  }
  EXPECT_EQ(parts().size(), 2);
  tests::crashedCopy(autosave->folder());
  const auto taken = TakenWork::take(lostWork(root)[0]);
  const auto all = (*taken)->read();
  ASSERT_TRUE(all) << all.error().message();
  EXPECT_EQ(all->versions.size(), 4U);
  EXPECT_TRUE(all->unfinished);
}

TEST_F(AutosaveControllerTest, SaysOnceWhereNothingCanBeKept) {
  // A file stands where the folder has to be.
  folder.writeText("", QStringLiteral("autosave"));
  const QSignalSpy failed(autosave.get(), &AutosaveController::failed);
  for (int i = 0; i < 3; ++i) {
    edit(3 - i);
    autosave->flush();
    QCoreApplication::processEvents();
  }
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(root));
}

TEST_F(AutosaveControllerTest, TriesAgainWhereItFailed) {
  folder.writeText("", QStringLiteral("autosave"));
  autosave = std::make_unique<AutosaveController>(models, edits, root, AutosaveController::Times{10, 10, 10});
  QSignalSpy failed(autosave.get(), &AutosaveController::failed);
  QSignalSpy written(autosave.get(), &AutosaveController::written);
  edit(3);
  ASSERT_TRUE(failed.wait(kPatience));
  // The disk has room again; nothing is edited any more.
  ASSERT_TRUE(QFile::remove(root));
  ASSERT_TRUE(written.count() > 0 || written.wait(kPatience));
  EXPECT_EQ(content(parts().value(0)).versions, editing::unstoredVersions(edits.history()));
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(AutosaveControllerTest, TellsWhichWritingHoldsTheState) {
  const QSignalSpy written(autosave.get(), &AutosaveController::written);
  edit(3);
  const quint64 first = autosave->flush();
  edit(2);
  const quint64 second = autosave->flush();
  EXPECT_LT(first, second);
  QCoreApplication::processEvents();
  ASSERT_FALSE(written.isEmpty());
  EXPECT_EQ(written.back()[0].toULongLong(), second);
}

}  // namespace
}  // namespace tactus::workbench
