
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "app/session/export_folder.h"
#include "app/session/study_export.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/store/copies.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

namespace fs = std::filesystem;

/// Runs `work` in a process of its own, which ends as by kill -9.
template <class Work>
void inAProcessThatIsKilled(Work work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

class Leftovers : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(path(""))) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }

  support::TempFolder folder_;
  store::SampleRecords records_;
  store::OpenStudy study_ = store::makeStudy(path("s.tactus"), records_);
};

TEST_F(Leftovers, OfACrashAreFoundAndTheNextExportDeletesThem) {
  ASSERT_TRUE(exportStudy(study_.file, path("out")));
  const auto before = names();
  inAProcessThatIsKilled([&] {
    auto half = ExportFolder::beside(path("out"));
    (void)base::writeFileAtomically(half->path() + "/participants.csv", "participant\n");
    auto copy = base::makeUnfinishedFile(path("s.tactus"), 0600);
    std::ofstream(copy.path + "-journal") << "data";
    auto import = base::makeUnfinishedFolder(path("s.tactus"), ".import-");
    std::ofstream(import.path + "/tables") << "data";
    ::kill(::getpid(), SIGKILL);  // before the destructors
  });
  const auto left = leftoversOfStudy(path("s.tactus"));
  EXPECT_EQ(left.size(), 4U);
  EXPECT_TRUE(std::all_of(left.begin(), left.end(), [](const Leftover& one) { return one.is_ours; }));
  EXPECT_EQ(leftoversOfExport(path("out")).size(), 1U);

  const auto done = exportStudy(study_.file, path("out"));
  ASSERT_TRUE(done);
  EXPECT_EQ(names(), before);
  for (const auto& one : left) {
    EXPECT_EQ(std::count(done->notes.begin(), done->notes.end(), one.path + ": left by a crash; deleted"), 1)
        << one.path;
  }
}

TEST_F(Leftovers, WhatIsInUseOrNotOursStays) {
  auto half = ExportFolder::beside(path("out"));
  ASSERT_TRUE(half);
  auto copy = base::makeUnfinishedFile(path("s.tactus"), 0600);
  std::ofstream(copy.path + "-journal") << "data";
  for (const char* name : {"s.tactus.backup", "s.tactus.before-v2", "s.tactus.a1B2c3", "out.old-1", "t.tactus-abcde"}) {
    std::ofstream(path(name)) << "a text of a person";
  }
  EXPECT_EQ(leftoversOfStudy(path("s.tactus")), std::vector<Leftover>{});
  EXPECT_EQ(leftoversOfExport(path("out")), std::vector<Leftover>{});
  const auto before = names();
  ASSERT_TRUE(exportStudy(study_.file, path("other")));
  auto after = before;
  after.insert(std::lower_bound(after.begin(), after.end(), "other"), "other");
  EXPECT_EQ(names(), after);
}

TEST_F(Leftovers, OfAnOlderTactusAreListedAndLeftToThePerson) {
  ASSERT_TRUE(store::backUp(study_.file, path("s.tactus.a1B2c3")));
  for (const char* name : {"out.new-1", "out.old-2"}) ASSERT_TRUE(exportStudy(study_.file, path(name)));
  const std::vector<Leftover> left = {
      {path("out.new-1"), false}, {path("out.old-2"), false}, {path("s.tactus.a1B2c3"), false}};
  EXPECT_EQ(leftoversOfStudy(path("s.tactus")), left);
  ASSERT_TRUE(exportStudy(study_.file, path("out")));
  EXPECT_EQ(leftoversOfStudy(path("s.tactus")), left);
  EXPECT_NE(sentence(left[0]).find("delete it unless you made it"), std::string::npos);
}

TEST_F(Leftovers, AnExportIsPrivateAndItsPlaceKeepsItsMode) {
  for (const Swap swap : {Swap::kAtOnce, Swap::kInTwoSteps}) {
    const std::string out = path(swap == Swap::kAtOnce ? "at-once" : "two-steps");
    ASSERT_TRUE(exportStudy(study_.file, out));
    EXPECT_EQ(static_cast<unsigned>(fs::status(out).permissions()), 0700U);
    fs::permissions(out, static_cast<fs::perms>(0750));
    auto again = ExportFolder::beside(out);
    ASSERT_TRUE(again);
    std::ofstream(again->path() + "/speeds.csv") << "new";
    ASSERT_TRUE(again->place(swap));
    EXPECT_EQ(base::readFile(out + "/speeds.csv", 10), "new");
    EXPECT_FALSE(fs::exists(out + "/codebook.json")) << "the earlier export is gone";
    EXPECT_EQ(static_cast<unsigned>(fs::status(out).permissions()), 0750U);
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"at-once", "s.tactus", "s.tactus-wal", "two-steps"}));
}

TEST_F(Leftovers, AnExportIsNeverAbsent) {
  const std::string out = path("out");
  ASSERT_TRUE(exportStudy(study_.file, out));
  std::atomic<bool> ends{false};
  std::atomic<int> absent{0};
  std::thread watcher([&] {
    while (!ends) absent += ::access((out + "/codebook.json").c_str(), F_OK) == 0 ? 0 : 1;
  });
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(exportStudy(study_.file, out));
  ends = true;
  watcher.join();
  EXPECT_EQ(absent, 0);
}

}  // namespace
}  // namespace tactus::session
