// Versions of a model on a disk that is slow, hangs or refuses, and while the study is left.
#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <semaphore>

#include "app/workbench/study/study_models.h"
#include "core/store/study_info.h"

#include "tests/gui/study/study_models_fixture.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

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

}  // namespace
}  // namespace tactus::workbench
