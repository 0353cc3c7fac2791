// `tactus` as a process: standard input and output in the place of files, and Ctrl-C.
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;

class Process : public testing::Test {
 protected:
  Process() { fs::copy(TACTUS_GOLDEN_DIR "/models/averaged.tactus.json", model_); }

  /// What `sh` says of `line`; `tactus` in it is the program.
  static std::string said(const std::string& line) {
    const std::string shell = "tactus() { " TACTUS_PROGRAM " \"$@\"; }; { " + line + "; } 2>&1";
    FILE* const pipe = ::popen(shell.c_str(), "r");
    std::string text;
    std::array<char, 4096> part{};
    for (std::size_t got = 0; (got = std::fread(part.data(), 1, part.size(), pipe)) > 0;) text.append(part.data(), got);
    ::pclose(pipe);
    return text;
  }

  support::TempFolder folder_;
  std::string model_ = folder_.file("m.tactus.json");
};

constexpr const char* kPoints = "printf 'lubrication,neck_flexion,depth,speed\\n1,45,130,50\\n' | ";

TEST_F(Process, AHyphenIsStandardInputAndOutput) {
  writeText(folder_.file("points.csv"), "lubrication,neck_flexion,depth,speed\n1,45,130,50\n");
  const std::string from_file = said("tactus eval " + model_ + " --in " + folder_.file("points.csv"));
  EXPECT_NE(from_file.find("1,45,130,50,0."), std::string::npos) << from_file;
  EXPECT_EQ(said(kPoints + ("tactus eval " + model_) + " --in -"), from_file);
  EXPECT_EQ(said(kPoints + ("tactus eval " + model_) + " --in - --out -"), from_file);
  EXPECT_NE(said("cat " + model_ + " | tactus check -").find("reachable force"), std::string::npos);
  EXPECT_NE(said("cat " + model_ + " | tactus diff - " + model_).find("no difference"), std::string::npos);
  for (const char* command :
       {"demo -", "bundle m --out -", "convert m --to fll --out -", "study form s --to print --out -"})
    EXPECT_NE(said(std::string("tactus ") + command).find("wanted the name of a folder"), std::string::npos) << command;
  EXPECT_FALSE(fs::exists("-")) << "no file of that name is made";
}

TEST_F(Process, WhatGoesToStandardOutputIsTheFileAlone) {
  const std::string study = folder_.file("study");
  fs::create_directory(study);
  writeText(study + "/participants.csv", "participant\nA\n");
  writeText(study + "/rules.csv",
            "participant,lubrication,depth,then,form\nA,poor,esophagus,large,ngt-a2-five-regions\n");
  const std::string text = said("tactus build " + study + " --out - 2>/dev/null");
  EXPECT_EQ(nlohmann::json::parse(text, nullptr, false)["format"], "tactus-force-model") << text;
  EXPECT_NE(said("tactus build " + study + " --out - --json").find("one of them"), std::string::npos);
  EXPECT_NE(said("tactus build " + study + " --out - 2>/dev/null | tactus diff - -").find("tactus"), std::string::npos)
      << "nothing is left for the second";
}

// Ctrl-C at any time leaves the folder as it was, or with the whole bundle.
TEST_F(Process, CtrlCLeavesNothingHalfMade) {
  const std::string place = folder_.file("place");
  const std::string bundle = place + "/bundle";
  int stopped = 0;
  for (int round = 0; round < 8; ++round) {
    fs::create_directory(place);
    const pid_t child = ::fork();
    if (child == 0) {
      for (FILE* const stream : {stdout, stderr}) {
        if (std::freopen("/dev/null", "w", stream) == nullptr) ::_exit(126);
      }
      ::execl(TACTUS_PROGRAM, "tactus", "bundle", model_.c_str(), "--table-error", "0.3", "--out", bundle.c_str(),
              static_cast<char*>(nullptr));
      ::_exit(127);
    }
    // Half of the rounds stop it while it writes.
    int status = 0;
    bool ended = false;
    for (int ms = 0; ms < 20'000 && !ended; ++ms) {
      if (round % 2 == 0 ? ms >= 20 * round + 20 : !fs::is_empty(place)) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ended = ::waitpid(child, &status, WNOHANG) == child;
    }
    if (!ended) {
      ::kill(child, SIGINT);
      ASSERT_EQ(::waitpid(child, &status, 0), child);
    }
    if (!fs::exists(bundle + "/manifest.json")) {
      ++stopped;
      // Before the program listens for it, the signal itself ends it.
      const bool ended_by_it = WIFSIGNALED(status) && WTERMSIG(status) == SIGINT;
      EXPECT_TRUE(ended_by_it || WEXITSTATUS(status) == 128 + SIGINT) << "round " << round << ": " << status;
      EXPECT_TRUE(fs::is_empty(place)) << "round " << round << ": " << fs::directory_iterator(place)->path();
    } else {
      EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 1) << "round " << round;
    }
    fs::remove_all(place);
  }
  EXPECT_GT(stopped, 0);
}

}  // namespace
}  // namespace tactus::cli
