#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "core/store/copies.h"
#include "core/store/entries.h"
#include "core/store/study_info.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

class Backups : public testing::Test {
 protected:
  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  std::string copy_ = folder_.file("copy.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
};

TEST_F(Backups, HoldWhatWasCommittedUntilThen) {
  const auto answer = records_.answer(study_.session.id, 1);
  const auto stroke = records_.stroke(study_.session.id, 2000);
  ASSERT_TRUE(append(study_.file, answer));
  ASSERT_TRUE(append(study_.file, stroke));
  const auto copied = backUp(study_.file, copy_);
  ASSERT_TRUE(copied) << copied.error().message();
  ASSERT_TRUE(append(study_.file, records_.answer(study_.session.id, 2)));

  const auto copy = StudyFile::open(copy_);
  ASSERT_TRUE(copy) << copy.error().message();
  EXPECT_EQ(*answers(*copy), std::vector{answer});
  EXPECT_EQ(*strokes(*copy), std::vector{stroke});
  EXPECT_EQ(studyInfo(*copy)->id, studyInfo(study_.file)->id);
  EXPECT_TRUE(checkStudy(*copy)->empty());
  EXPECT_EQ(answers(study_.file)->size(), 2U);
}

TEST_F(Backups, AreOneFileWithoutRests) {
  ASSERT_TRUE(backUp(study_.file, copy_));
  ASSERT_TRUE(study_.file.close());
  for (const auto& entry : fs::directory_iterator(fs::path(path_).parent_path())) {
    EXPECT_EQ(entry.path().extension(), ".tactus") << entry.path();
  }
}

TEST_F(Backups, AreOnlyTheUsersAsStudiesAndJournalsAre) {
  const auto mode = [](const std::string& path) { return static_cast<unsigned>(fs::status(path).permissions()); };
  ASSERT_TRUE(append(study_.file, records_.answer(study_.session.id, 1)));
  ASSERT_TRUE(backUp(study_.file, copy_));
  for (const auto& path : {path_, path_ + "-wal", copy_}) EXPECT_EQ(mode(path), 0600U) << path;
  ASSERT_TRUE(study_.file.close());

  // A mode that a person gave stays, and the journal follows it.
  fs::permissions(path_, static_cast<fs::perms>(0640));
  auto again = StudyFile::open(path_);
  ASSERT_TRUE(again);
  ASSERT_TRUE(append(*again, records_.answer(study_.session.id, 2)));
  for (const auto& path : {path_, path_ + "-wal"}) EXPECT_EQ(mode(path), 0640U) << path;
}

TEST_F(Backups, NeverReplaceAFile) {
  std::ofstream(copy_) << "precious";
  const auto copied = backUp(study_.file, copy_);
  ASSERT_FALSE(copied);
  EXPECT_NE(copied.error().message().find("copy.tactus: found a file of this name"), std::string::npos);
  EXPECT_EQ(fs::file_size(copy_), 8U);
  EXPECT_FALSE(backUp(study_.file, path_));
  EXPECT_FALSE(backUp(study_.file, folder_.file("no folder/copy.tactus")));
  EXPECT_TRUE(answers(study_.file));
}

}  // namespace
}  // namespace tactus::store
