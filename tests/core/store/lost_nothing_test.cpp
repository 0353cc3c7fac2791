// What was acknowledged is there after the program was killed, after the machine crashed, and after the disk failed.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>

#include "core/store/copies.h"
#include "core/store/entries.h"
#include "core/store/study_info.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/disk_rounds.h"
#include "tests/core/store/disk_script.h"
#include "tests/core/store/faulty_disk.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

void report(const char* what, const RoundsOutcome& outcome) {
  std::cout << what << ": " << outcome.rounds << " rounds, " << outcome.acknowledged << " records acknowledged, "
            << outcome.unacknowledged_kept << " kept beyond that, slowest opening " << outcome.slowest_opening_s
            << " s\n";
}

TEST(LostNothing, KilledProgram) {
  const auto outcome = killRounds(TACTUS_KILL_CHILD, 20, 20261121);
  report("killed", outcome);
  EXPECT_EQ(outcome.complaint, "");
  EXPECT_EQ(outcome.rounds, 20);
  EXPECT_GT(outcome.acknowledged, 20);
}

TEST(LostNothing, CrashedMachine) {
  const auto outcome = crashRounds(80, 12, 40, 5);
  report("crashed", outcome);
  EXPECT_EQ(outcome.complaint, "");
  EXPECT_EQ(outcome.rounds, 80);
}

TEST(LostNothing, CrashedMachineWhileTheJournalIsWorkedIn) {
  // A recording of 5 MB is more than the 1000 pages after which SQLite copies the journal into the file.
  const auto outcome = crashRounds(5, 4, 330'000, 6);
  report("crashed during a checkpoint", outcome);
  EXPECT_EQ(outcome.complaint, "");
  EXPECT_EQ(outcome.rounds, 5);
}

/// Tries everything that writes, with the disk failing at each of its operations in turn.
class FailingDisk : public testing::TestWithParam<std::pair<FaultyDisk::Fault, bool>> {
 protected:
  void SetUp() override {
    SampleRecords ids;
    auto study = makeStudy(original_, ids);
    session_ = study.session.id;
    person_ = study.person.id;
    const DiskScript script(session_);
    for (int number = 0; number < 5; ++number) ASSERT_TRUE(script.write(study.file, number));
    ASSERT_TRUE(study.file.close());
  }

  /// Opens a fresh copy of the study and breaks the disk at operation `at` of `work`, which returns its error.
  /// Returns false when the work ended before.
  template <class Work>
  bool breakAt(long long at, Work&& work, std::string& message) {
    fs::remove(path_ + "-wal");
    fs::copy_file(original_, path_, fs::copy_options::overwrite_existing);
    disk_.heal();
    auto file = StudyFile::open(path_, {Access::kReadWrite, disk_.name()});
    EXPECT_TRUE(file) << file.error().message();
    disk_.failAt(at, GetParam().first, GetParam().second);
    message = work(*file);
    const bool struck = disk_.struck();
    disk_.heal();
    return struck;
  }
  /// The file as it is afterwards, with a disk that works.
  base::Result<StudyFile> reopened() const { return StudyFile::open(path_, {Access::kReadWrite, disk_.name()}); }
  /// Every operation where the disk breaks for good; where it fails once, one in four.
  long long step() const { return GetParam().second ? 1 : 4; }
  void expectClear(const std::string& message, long long at) const {
    if (message.empty()) return;  // the failure was one that could be made good, such as that of a checkpoint
    const bool clear = message.find("found a full disk, wanted room for what is to be saved") != std::string::npos ||
                       message.find("found a disk that reports an error") != std::string::npos;
    EXPECT_TRUE(clear) << "operation " << at << ": " << message;
  }

  support::TempFolder folder_;
  std::string original_ = folder_.file("original.tactus");
  std::string path_ = folder_.file("study.tactus");
  FaultyDisk disk_{"failing"};
  study::RecordId session_;
  study::RecordId person_;
};

TEST_P(FailingDisk, WhatIsAcknowledgedIsThereAndWhatIsNotSaysWhy) {
  const DiskScript script(session_);
  bool struck = true;
  int failures = 0;
  for (long long at = 1; struck; ++at) {
    ASSERT_LT(at, 1000);
    int acknowledged = 5;
    std::string message;
    struck = breakAt(
        at,
        [&](StudyFile& file) {
          std::string first;
          for (int number = 5; number < 11; ++number) {
            if (auto written = script.write(file, number); !written) {
              if (first.empty()) first = written.error().message();
              break;
            }
            ++acknowledged;
          }
          // On a disk that works again the same file continues.
          if (!first.empty() && !GetParam().second) {
            const auto again = script.write(file, acknowledged);
            EXPECT_TRUE(again) << again.error().message();
            ++acknowledged;
          }
          return first;
        },
        message);
    expectClear(message, at);
    failures += message.empty() ? 0 : 1;
    const auto file = reopened();
    ASSERT_TRUE(file) << file.error().message();
    std::string complaint;
    const int there = script.intactRecords(*file, complaint);
    EXPECT_EQ(complaint, "") << "operation " << at;
    EXPECT_TRUE(there == acknowledged || there == acknowledged + 1) << there << " of " << acknowledged << " at " << at;
  }
  EXPECT_GT(failures, 5);
}

TEST_P(FailingDisk, AFailedBackupLeavesNothingBehind) {
  const std::string target = folder_.file("backup.tactus");
  bool struck = true;
  for (long long at = 1; struck; at += step()) {
    ASSERT_LT(at, 1000);
    std::string message;
    struck = breakAt(
        at,
        [&](StudyFile& file) {
          const auto copied = backUp(file, target);
          return copied ? "" : copied.error().message();
        },
        message);
    expectClear(message, at);
    EXPECT_EQ(fs::exists(target), message.empty());
    if (fs::exists(target)) {
      const auto copy = StudyFile::open(target);
      ASSERT_TRUE(copy) << copy.error().message();
      EXPECT_TRUE(checkStudy(*copy)->empty());
    }
    fs::remove(target);
    for (const auto& entry : fs::directory_iterator(fs::path(path_).parent_path())) {
      EXPECT_EQ(entry.path().filename().string().find("backup"), std::string::npos) << entry.path();
    }
  }
}

TEST_P(FailingDisk, AFailedCreationLeavesNothingBehind) {
  const std::string target = folder_.file("created.tactus");
  SampleRecords ids(3);
  bool struck = true;
  for (long long at = 1; struck; at += step()) {
    ASSERT_LT(at, 1000);
    disk_.failAt(at, GetParam().first, GetParam().second);
    const auto made = StudyFile::create(target, ids.study(), {Access::kReadWrite, disk_.name()});
    struck = disk_.struck();
    if (!made) expectClear(made.error().message(), at);
    disk_.heal();
    if (!made && fs::exists(target)) {
      // Made, but it could not be opened at once.
      const auto file = StudyFile::open(target);
      EXPECT_TRUE(file) << file.error().message();
    } else if (!made) {
      for (const auto& entry : fs::directory_iterator(fs::path(path_).parent_path())) {
        EXPECT_EQ(entry.path().filename().string().find("created"), std::string::npos) << entry.path();
      }
    }
    for (const char* tail : {"", "-wal"}) fs::remove(target + tail);
  }
}

TEST_P(FailingDisk, AWithdrawalHappensWhollyOrNotAtAll) {
  bool struck = true;
  for (long long at = 1; struck; at += step()) {
    ASSERT_LT(at, 1000);
    std::string message;
    struck = breakAt(
        at,
        [&](StudyFile& file) {
          const auto withdrawn = withdraw(file, person_, 5);
          return withdrawn ? "" : withdrawn.error().message();
        },
        message);
    expectClear(message, at);
    auto file = reopened();
    ASSERT_TRUE(file) << file.error().message();
    const bool gone = !tombstones(*file)->empty();
    // All that may be left is an erasure to be finished, which the check says.
    const auto findings = *checkStudy(*file);
    EXPECT_EQ(findings.size(), unfinishedErasures(*file)->size());
    EXPECT_TRUE(findings.empty() || gone);
    EXPECT_EQ(answers(*file, {.history = true})->empty(), gone);
    EXPECT_EQ(strokes(*file)->empty(), gone);
    EXPECT_TRUE(gone || !message.empty());
    if (message.find("the records are removed") != std::string::npos) {
      EXPECT_TRUE(gone);
      EXPECT_TRUE(eraseTraces(*file));
      EXPECT_TRUE(checkStudy(*file)->empty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults, FailingDisk,
    testing::Values(std::pair(FaultyDisk::Fault::kDiskFull, true), std::pair(FaultyDisk::Fault::kDiskFull, false),
                    std::pair(FaultyDisk::Fault::kWriteError, true), std::pair(FaultyDisk::Fault::kWriteError, false),
                    std::pair(FaultyDisk::Fault::kSyncError, true), std::pair(FaultyDisk::Fault::kSyncError, false)));

}  // namespace
}  // namespace tactus::store
