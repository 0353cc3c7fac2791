#include "app/workbench/study/study_models.h"

#include <QFileInfo>
#include <QSignalSpy>
#include <gtest/gtest.h>

#include "app/session/session_notes.h"
#include "core/store/entries.h"
#include "core/store/study_info.h"

#include "tests/gui/study/study_models_fixture.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

TEST_F(StudyModelsTest, OpensTheLatestModelWithItsHistory) {
  makeTuned();
  ASSERT_TRUE(open(path)) << failed.toStdString();
  EXPECT_EQ(shoulder(), 3);
  EXPECT_TRUE(kept->keepsModel());
  EXPECT_EQ(kept->savedText(), QStringLiteral("Stored in sample.tactus"));
  EXPECT_FALSE(models.isModified());
  EXPECT_EQ(edits.history().line().size(), 3U);
  ASSERT_TRUE(edits.canUndo());
  ASSERT_TRUE(edits.canRedo());
  // The texts of older states arrive in the background.
  ASSERT_TRUE(comesTrue([this] {
    edits.undo();
    return shoulder() == 4;
  }));
  edits.redo();
  edits.redo();
  EXPECT_EQ(shoulder(), 2);
}

TEST_F(StudyModelsTest, ANursesOwnModelIsNoStateOfTheResearchersModel) {
  makeTuned();
  {
    auto file = *store::StudyFile::open(path.toStdString());
    study::RecordIds ids;
    study::ModelVersion own = **store::latestModelVersion(file);
    own.id = ids.next();
    own.parent.reset();
    own.label = session::kOwnModelLabel;
    ASSERT_TRUE(store::append(file, own));
  }
  ASSERT_TRUE(open(path)) << failed.toStdString();
  EXPECT_EQ(edits.history().line().size(), 3U);
  EXPECT_TRUE(edits.canUndo());
}

TEST_F(StudyModelsTest, EveryEditBecomesAVersion) {
  makeTuned();
  ASSERT_TRUE(open(path));
  move(2.5);
  move(1.5);
  const auto version = kept->modelVersion();
  ASSERT_TRUE(allWritten());
  EXPECT_FALSE(models.isModified());
  end();
  const auto stored = versions();
  ASSERT_EQ(stored.size(), 6U);
  EXPECT_EQ(stored.back().id, version);
  EXPECT_EQ(stored.back().parent, stored[4].id);
  EXPECT_TRUE(stored.back().label.starts_with("edit: ")) << stored.back().label;
  EXPECT_EQ(storedShoulder(), 1.5);
  EXPECT_TRUE(store::checkStudy(tests::lookInto(path))->empty());
}

TEST_F(StudyModelsTest, WhatIsWrongIsOneSentenceAndTheStudyBeforeStays) {
  makeTuned();
  ASSERT_TRUE(open(path));
  EXPECT_FALSE(open(folder.path(QStringLiteral("nowhere.tactus"))));
  EXPECT_TRUE(failed.contains(QStringLiteral("nowhere.tactus"))) << failed.toStdString();
  EXPECT_FALSE(open(folder.writeText("no study", QStringLiteral("note.tactus"))));
  EXPECT_EQ(study->path(), path);
  move(2.5);
  ASSERT_TRUE(allWritten());
  end();
  EXPECT_EQ(storedShoulder(), 2.5);
}

TEST_F(StudyModelsTest, AnEmptyStudySaysWhatToDoAndTakesAModelIn) {
  study->create(path);
  ASSERT_TRUE(comesTrue([this] { return study->isOpen(); })) << failed.toStdString();
  EXPECT_TRUE(said.contains(QStringLiteral("holds neither a model nor answers"))) << said.toStdString();
  EXPECT_FALSE(kept->hasModel());
  EXPECT_EQ(models.current(), nullptr);

  models.open(folder.write(tests::twoExperts()));
  move(3);
  EXPECT_TRUE(models.isModified());
  EXPECT_FALSE(kept->keepsModel());
  kept->putModel();
  EXPECT_TRUE(kept->keepsModel());
  EXPECT_FALSE(models.isModified());
  move(2);
  ASSERT_TRUE(allWritten());
  end();
  EXPECT_EQ(versions().size(), 3U);
  EXPECT_EQ(storedShoulder(), 2);
}

TEST_F(StudyModelsTest, AFileThatIsOpenedBesideTheStudyStaysAFile) {
  makeTuned();
  ASSERT_TRUE(open(path));
  models.open(folder.write(tests::twoExperts()));
  EXPECT_FALSE(kept->keepsModel());
  EXPECT_TRUE(kept->savedText().isEmpty());
  move(2.5);
  EXPECT_TRUE(models.isModified());
  kept->openModel();
  ASSERT_TRUE(comesTrue([this] { return kept->keepsModel(); }));
  EXPECT_EQ(shoulder(), 3);
  end();
  EXPECT_EQ(versions().size(), 4U);
}

TEST_F(StudyModelsTest, SaveAsWritesACopy) {
  makeTuned();
  ASSERT_TRUE(open(path));
  models.saveAs(folder.path(QStringLiteral("copy.tactus.json")));
  EXPECT_TRUE(QFileInfo::exists(folder.path(QStringLiteral("copy.tactus.json"))));
  EXPECT_TRUE(kept->keepsModel());
  EXPECT_TRUE(said.contains(QStringLiteral("copy.tactus.json"))) << said.toStdString();
  models.save();
  EXPECT_TRUE(said.contains(QStringLiteral("Everything is stored"))) << said.toStdString();
}

TEST_F(StudyModelsTest, AClosedStudyLeavesItsModelOnTheScreen) {
  makeTuned();
  ASSERT_TRUE(open(path));
  move(2.5);
  study->close();
  ASSERT_TRUE(comesTrue([this] { return !study->isOpen(); }));
  EXPECT_EQ(shoulder(), 2.5);
  EXPECT_EQ(storedShoulder(), 2.5);
  EXPECT_EQ(models.current()->path, folder.path(QStringLiteral("sample.tactus.json")));
  move(2);
  EXPECT_TRUE(models.isModified());
}

TEST_F(StudyModelsTest, AModelOfOneStudyIsPutIntoAnother) {
  const QString other = folder.path(QStringLiteral("other.tactus"));
  makeTuned();
  ASSERT_TRUE(open(path));
  study->close();
  ASSERT_TRUE(comesTrue([this] { return !study->isOpen(); }));
  study->create(other);
  ASSERT_TRUE(comesTrue([this] { return study->isOpen(); }));
  kept->putModel();
  move(2.5);
  ASSERT_TRUE(allWritten());
  EXPECT_TRUE(failed.isEmpty()) << failed.toStdString();
  end();
  const auto stored = versions(other);
  ASSERT_EQ(stored.size(), 2U);
  EXPECT_TRUE(stored[0].label.starts_with("opened: ")) << stored[0].label;
  EXPECT_EQ(stored[1].parent, stored[0].id);
  const auto last = *store::latestModelVersion(tests::lookInto(other));
  EXPECT_EQ(model_io::parseModel(last->text, "stored")->model, models.current()->model);
}

TEST_F(StudyModelsTest, LookingAtTheHistoryComplainsOfNothing) {
  makeTuned();
  ASSERT_TRUE(open(path));
  QSignalSpy refused(&edits, &EditController::refused);
  // The texts of old states may not have been read yet; what an edit did is told as soon as they are.
  edits.effectOf(1);
  EXPECT_EQ(refused.count(), 0);
  EXPECT_TRUE(comesTrue([this] { return !edits.effectOf(1).isEmpty(); }));
  EXPECT_EQ(refused.count(), 0);
}

TEST_F(StudyModelsTest, AnswersWithoutAModelGiveTheAveragedOneWhenItIsAskedFor) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    // Whoever only felt models is no expert of the averaged model.
    tests::addVisit(file, ids, "calm-fox", false, study::SessionKind::kUsability);
    study::RuleRecord rule;
    rule.entry.id = ids.next();
    rule.entry.session = tests::addVisit(file, ids, "velvet-otter", true);
    rule.rule.conditions = {{"speed", "fast"}, {"lubrication", "poor"}};
    rule.rule.then = "large";
    ASSERT_TRUE(store::append(file, rule));
  });
  // Opening the study changes nothing in it.
  ASSERT_TRUE(open(path)) << failed.toStdString();
  EXPECT_EQ(offered, QStringLiteral("sample.tactus holds answers, but no model yet."));
  EXPECT_EQ(models.current(), nullptr);
  EXPECT_FALSE(kept->hasModel());
  EXPECT_FALSE(study->isBusy());
  study->close();
  ASSERT_TRUE(comesTrue([this] { return !study->isOpen(); }));
  EXPECT_TRUE(versions().empty());

  ASSERT_TRUE(open(path)) << failed.toStdString();
  kept->buildModel();
  ASSERT_TRUE(comesTrue([this] { return models.current() != nullptr; })) << failed.toStdString();
  EXPECT_TRUE(said.contains(QStringLiteral("1 expert, SIMULATED"))) << said.toStdString();
  ASSERT_EQ(models.current()->model.experts.size(), 1U);
  EXPECT_EQ(models.current()->model.experts[0].id, "velvet-otter");
  EXPECT_EQ(study->people().size(), 2U);
  ASSERT_TRUE(allWritten());
  // What is tuned stays in sight when the model is built anew, and the way back is a button.
  const auto state_of = [this] { return edits.history().current(); };
  fuzzy::ForceModel tuned = edits.model();
  tuned.default_force_n = 0.125;
  ASSERT_TRUE(edits.apply(editing::finished(tuned, "my tuned version")));
  const auto before = state_of();
  std::optional<MessageAct> back;
  QObject::connect(kept.get(), &StudyModels::backOffered, [&](const QString&, const MessageAct& act) { back = act; });
  kept->buildModel();
  ASSERT_TRUE(comesTrue([&] { return back.has_value(); })) << failed.toStdString();
  EXPECT_EQ(edits.history().states().size(), 3U);
  EXPECT_EQ(edits.model().default_force_n, 0);
  EXPECT_EQ(edits.history().states()[state_of()].parent, before);
  EXPECT_EQ(back->text, QStringLiteral("Back to my tuned version"));
  back->run();
  EXPECT_EQ(state_of(), before);
  EXPECT_EQ(edits.model().default_force_n, 0.125);
  ASSERT_TRUE(allWritten());
  end();
  ASSERT_EQ(versions().size(), 4U);
  EXPECT_TRUE(versions()[0].label.starts_with("opened: Built from the study")) << versions()[0].label;
}

}  // namespace
}  // namespace tactus::workbench
