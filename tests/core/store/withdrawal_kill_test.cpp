// A withdrawal that is killed at any of its operations on the disk can be done again, and leaves no byte of the person.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/faulty_disk.h"
#include "tests/core/store/naming_model.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/day.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// 15 a day, 60 in the soak.
const int kKills = std::max(15, support::rounds(60));

class KilledWithdrawals : public testing::Test {
 protected:
  void SetUp() override {
    SampleRecords records;
    auto study = makeStudy(original_, records);
    person_ = study.person.id;
    session_ = study.session.id;
    other_ = records.person("calm-fox");
    const auto other_session = records.session(other_.id);
    ASSERT_TRUE(append(study.file, other_) && append(study.file, other_session));
    for (int item = 1; item <= 12; ++item) {
      auto answer = records.answer(session_, item);
      answer.value = "secretopinion";
      ASSERT_TRUE(append(study.file, answer) && append(study.file, records.answer(other_session.id, item)));
      ASSERT_TRUE(append(study.file, records.stroke(session_, 800)));
      ASSERT_TRUE(append(study.file, records.stroke(other_session.id, 800)));
      auto version = records.model(namingModel({"velvet-otter", "calm-fox"}));
      version.label = "edit: velvet-otter: 1 rule";
      ASSERT_TRUE(append(study.file, version));
    }
    auto felt = records.event(other_session.id);
    felt.detail = R"({"model":"mean: velvet-otter alone"})";
    ASSERT_TRUE(append(study.file, felt));
    others_answers_ = *answers(study.file, {.person = other_.id});
    ASSERT_TRUE(study.file.close());
  }

  void freshCopy() const {
    for (const auto& entry : fs::directory_iterator(fs::path(path_).parent_path())) fs::remove_all(entry.path());
    fs::copy_file(original_, path_);
  }

  /// What of the person stands in any file of the folder, whatever its name is.
  std::string traces() const {
    const std::vector<std::string> wanted = {
        "velvet-otter", "secretopinion", ruleWeightOf("velvet-otter"), {session_.bytes.begin(), session_.bytes.end()}};
    std::string found;
    for (const auto& entry : fs::directory_iterator(fs::path(path_).parent_path())) {
      std::ostringstream bytes;
      bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      const std::string all = bytes.str();
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (all.find(wanted[i]) != std::string::npos) {
          found += entry.path().filename().string() + " holds trace " + std::to_string(i) + "; ";
        }
      }
    }
    return found;
  }

  /// Operations of opening, withdrawing and closing.
  long long operationsOfAll() {
    freshCopy();
    FaultyDisk disk("counting");
    auto file = StudyFile::open(path_, {Access::kReadWrite, disk.name()});
    EXPECT_TRUE(file && withdraw(*file, person_, 5) && file->close());
    EXPECT_EQ(traces(), "");
    return disk.operations();
  }

  /// Whether the child was killed on its way.
  bool killAt(long long operation) const {
    const pid_t child = ::fork();
    if (child == 0) {
      FaultyDisk disk("killing");
      disk.killAt(operation);
      auto file = StudyFile::open(path_, {Access::kReadWrite, disk.name()});
      const bool done = file && withdraw(*file, person_, 5) && file->close();
      ::_exit(done ? 0 : 1);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  }

  support::TempFolder folder_;
  support::TempFolder work_;
  std::string original_ = folder_.file("original.tactus");
  std::string path_ = work_.file("study.tactus");
  study::RecordId person_;
  study::RecordId session_;
  study::Person other_;
  std::vector<study::AnswerRecord> others_answers_;
};

TEST_F(KilledWithdrawals, LeaveNoByteOnceTheErasureIsFinished) {
  const long long all = operationsOfAll();
  ASSERT_GT(all, kKills);
  base::Random random(20261122);
  int not_withdrawn = 0;
  int unfinished = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    // One in each sixtieth of the way.
    const long long first = all * kill / kKills;
    const long long at = first + 1 + random.below(static_cast<int>(all / kKills));
    freshCopy();
    ASSERT_TRUE(killAt(at)) << "operation " << at << " of " << all;
    auto file = StudyFile::open(path_);
    ASSERT_TRUE(file) << file.error().message();
    const auto findings = *checkStudy(*file);
    ASSERT_TRUE(findings.empty() || (findings.size() == 1 && findings[0].starts_with("erasure: "))) << findings[0];
    EXPECT_EQ(findings.empty(), unfinishedErasures(*file)->empty());
    if (tombstones(*file)->empty()) {
      ++not_withdrawn;
      ASSERT_EQ(answers(*file, {.session = session_})->size(), 12U);  // all or nothing
      ASSERT_TRUE(withdraw(*file, person_, 5));
    } else {
      unfinished += unfinishedErasures(*file)->empty() ? 0 : 1;
      const auto erased = erase(*file);
      ASSERT_TRUE(erased) << erased.error().message();
    }
    EXPECT_EQ(traces(), "") << "open, after operation " << at;
    EXPECT_TRUE(unfinishedErasures(*file)->empty());
    EXPECT_EQ(*answers(*file), others_answers_);
    ASSERT_TRUE(file->close());
    EXPECT_EQ(traces(), "") << "closed, after operation " << at;
    EXPECT_TRUE(checkStudy(*StudyFile::open(path_))->empty());
  }
  std::cout << kKills << " kills within " << all << " operations: " << not_withdrawn << " before the withdrawal, "
            << unfinished << " with an unfinished erasure\n";
  EXPECT_GT(not_withdrawn, 0);
  EXPECT_GT(unfinished, 0);
}

}  // namespace
}  // namespace tactus::store
