#include "app/workbench/study/study_models.h"

#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <semaphore>

#include "app/editing/history_versions.h"
#include "app/editing/membership_edits.h"
#include "app/session/session_notes.h"
#include "core/model_io/model_file.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/study_info.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

const editing::VertexPlace kNearShoulder{{"depth", ""}, "near", 2};

class StudyModelsTest : public testing::Test {
 protected:
  StudyModelsTest() {
    const auto on_said = [this](const QString& sentence) { said = sentence; };
    const auto on_failed = [this](const QString&, const QString& sentence) { failed = sentence; };
    QObject::connect(study.get(), &StudyConnection::said, on_said);
    QObject::connect(kept.get(), &StudyModels::said, on_said);
    QObject::connect(kept.get(), &StudyModels::buildOffered, [this](const QString& sentence) { offered = sentence; });
    QObject::connect(study.get(), &StudyConnection::failed, on_failed);
    QObject::connect(kept.get(), &StudyModels::failed, on_failed);
  }

  // A study with the sample model, opened and moved to 3 and 2, then back to 3.
  void makeTuned() {
    tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
      auto history = *editing::EditHistory::open(tests::twoExperts(), "Opened", {"anna", 1}, ids);
      for (const double to : {3.0, 2.0}) {
        history.apply(*editing::moveVertex(history.model(), kNearShoulder, to), {"anna", 2});
      }
      ASSERT_TRUE(history.undo({"anna", 3}));
      for (const auto& version : editing::unstoredVersions(history)) ASSERT_TRUE(store::append(file, version));
    });
  }
  void end() {
    kept.reset();
    study.reset();
  }
  bool open(const QString& file) {
    failed.clear();
    study->open(file);
    return comesTrue([this] { return !study->isOpening(); }) && failed.isEmpty();
  }
  // Until `disk` is released, nothing more is written; from the moment on at which the study is left.
  void hangOnLeaving(const std::shared_ptr<std::binary_semaphore>& disk) {
    QObject::connect(study.get(), &StudyConnection::leaving, [this, disk] {
      left = true;
      study->order([disk](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
        disk->acquire();
        return {};
      });
    });
  }
  // Nothing is written until the disk is told not to be full any more.
  std::shared_ptr<std::atomic<bool>> fillDisk() {
    auto full = std::make_shared<std::atomic<bool>>(true);
    study->order([full](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
      if (*full) return base::fail(base::ErrorCode::kIo, "disk", "no space left", "free space");
      return {};
    });
    return full;
  }
  void move(double to) { ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearShoulder, to))); }
  double shoulder() const { return models.current()->model.inputs[1].terms[0].points[2]; }
  bool allWritten() {
    return comesTrue([this] { return !study->isBusy(); });
  }
  std::vector<study::ModelVersion> versions(const QString& file) {
    return *store::modelVersions(tests::lookInto(file));
  }
  std::vector<study::ModelVersion> versions() { return versions(path); }
  double storedShoulder() {
    const auto version = *store::latestModelVersion(tests::lookInto(path));
    return model_io::parseModel(version->text, "stored")->model.inputs[1].terms[0].points[2];
  }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("sample.tactus"));
  ModelController models;
  EditController edits{models};
  std::unique_ptr<StudyConnection> study = std::make_unique<StudyConnection>();
  std::unique_ptr<StudyModels> kept = std::make_unique<StudyModels>(*study, models, edits);
  QString said;
  QString offered;
  QString failed;
  bool left = false;
};

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

TEST_F(StudyModelsTest, WhatWasOrderedIsWrittenBeforeTheEnd) {
  makeTuned();
  ASSERT_TRUE(open(path));
  for (int i = 0; i < 50; ++i) move(2 + 0.01 * i);
  end();
  EXPECT_EQ(versions().size(), 54U);
}

TEST_F(StudyModelsTest, ADiskThatHangsHoldsNobodyUp) {
  makeTuned();
  ASSERT_TRUE(open(path));
  std::binary_semaphore disk(0);
  study->order([&disk](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
    disk.acquire();
    return {};
  });
  move(2.5);
  EXPECT_EQ(shoulder(), 2.5);
  ASSERT_TRUE(comesTrue([this] { return kept->savedText() == QStringLiteral("Saving in sample.tactus…"); }));
  EXPECT_TRUE(study->isBusy());
  disk.release();
  ASSERT_TRUE(allWritten());
  EXPECT_EQ(kept->savedText(), QStringLiteral("Stored in sample.tactus"));
}

TEST_F(StudyModelsTest, WhatTheDiskRefusesIsSaidAndDoneAgain) {
  makeTuned();
  ASSERT_TRUE(open(path));
  auto full = std::make_shared<std::atomic<bool>>(true);
  bool done = false;
  study->order(
      [full](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
        if (*full) return base::fail(base::ErrorCode::kIo, "disk", "no space left", "free space");
        return {};
      },
      [&done] { done = true; });
  move(2.5);
  ASSERT_TRUE(comesTrue([this] { return !study->failure().isEmpty(); }));
  EXPECT_TRUE(failed.contains(QStringLiteral("no space left"))) << failed.toStdString();
  EXPECT_TRUE(kept->savedText().contains(QStringLiteral("Not stored"))) << kept->savedText().toStdString();
  // Nobody gets away from it by accident.
  study->open(folder.path(QStringLiteral("other.tactus")));
  EXPECT_FALSE(study->isOpening());

  *full = false;
  study->storeNow();
  ASSERT_TRUE(allWritten());
  EXPECT_TRUE(done);
  EXPECT_TRUE(study->failure().isEmpty());
  end();
  EXPECT_EQ(storedShoulder(), 2.5);
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

TEST_F(StudyModelsTest, AnEditWhileTheStudyClosesIsStored) {
  makeTuned();
  ASSERT_TRUE(open(path));
  const auto disk = std::make_shared<std::binary_semaphore>(0);
  hangOnLeaving(disk);
  study->close();
  move(2.5);
  disk->release();
  ASSERT_TRUE(comesTrue([this] { return !study->isOpen(); }));
  EXPECT_EQ(shoulder(), 2.5);
  EXPECT_EQ(storedShoulder(), 2.5);
  EXPECT_TRUE(store::checkStudy(tests::lookInto(path))->empty());
}

TEST_F(StudyModelsTest, AnEditWhileAnotherStudyOpensStaysInItsOwn) {
  const QString other = folder.path(QStringLiteral("other.tactus"));
  tests::makeStudyFile(other);
  makeTuned();
  ASSERT_TRUE(open(path));
  const auto disk = std::make_shared<std::binary_semaphore>(0);
  hangOnLeaving(disk);
  study->open(other);
  ASSERT_TRUE(comesTrue([this] { return left; }));
  move(2.5);
  disk->release();
  ASSERT_TRUE(comesTrue([&] { return study->path() == other; })) << failed.toStdString();
  ASSERT_TRUE(allWritten());
  EXPECT_TRUE(failed.isEmpty()) << failed.toStdString();
  end();
  EXPECT_EQ(storedShoulder(), 2.5);
  EXPECT_TRUE(versions(other).empty());
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

TEST_F(StudyModelsTest, WhatTheDiskRefusesIsNotReplacedByWhatItHas) {
  makeTuned();
  ASSERT_TRUE(open(path));
  const auto full = fillDisk();
  move(2.5);
  ASSERT_TRUE(comesTrue([this] { return !study->failure().isEmpty(); }));
  kept->openModel();
  ASSERT_TRUE(comesTrue([this] { return !study->isOpening(); }));
  EXPECT_EQ(shoulder(), 2.5);
  kept->buildModel();
  ASSERT_TRUE(comesTrue([this] { return !study->isOpening(); }));
  EXPECT_EQ(shoulder(), 2.5);
  *full = false;
  study->storeNow();
  ASSERT_TRUE(allWritten());
  end();
  EXPECT_EQ(storedShoulder(), 2.5);
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
  end();
  ASSERT_EQ(versions().size(), 1U);
  EXPECT_TRUE(versions()[0].label.starts_with("opened: Built from the study")) << versions()[0].label;
}

}  // namespace
}  // namespace tactus::workbench
