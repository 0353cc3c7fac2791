
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/files/file.h"

#include "tests/support/temp_folder.h"

namespace tactus::base {
namespace {

namespace fs = std::filesystem;

TEST(SystemReason, IsNeverEmptyAndNeverOurOwnMistake) {
  for (int number = -1; number < 140; ++number) EXPECT_FALSE(systemReason(number).empty()) << number;
  EXPECT_EQ(systemReason(ENOSPC), "No space left on device");
  for (const int number : {0, EBADF, EINTR}) {
    EXPECT_EQ(systemReason(number), "an error of which the system does not say the reason");
    EXPECT_FALSE(isReason(number));
  }
  EXPECT_NE(systemReason(EFBIG).find("ulimit -f"), std::string::npos);
}

TEST(SystemReason, PipesAndDevicesAreNotReadForFiles) {
  const support::TempFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  // The pipe has no writer: to open it would wait for ever.
  EXPECT_EQ(readFile(pipe, 100).error().message(), pipe + ": found a pipe, wanted a file");
  EXPECT_EQ(readFile("/dev/zero", 100).error().message(), "/dev/zero: found a device, wanted a file");
  EXPECT_EQ(writeFileAtomically(pipe, "text").error().message(),
            pipe + ": found a pipe without a reader, wanted a file that can be written");
  fs::create_symlink(pipe, folder.file("link"));
  EXPECT_EQ(readFile(folder.file("link"), 100).error().message(),
            folder.file("link") + ": found a pipe, wanted a file");
}

TEST(SystemReason, WhatAShellPipesInIsRead) {
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "text", 4), 4);
  ::close(ends[1]);
  EXPECT_EQ(readFile("/dev/fd/" + std::to_string(ends[0]), 100), "text");
  ::close(ends[0]);
}

TEST(SystemReason, ALimitOnTheSizeOfFilesIsASentence) {
  const support::TempFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);  // as the programs do
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto written = writeFileAtomically(folder.file("big"), std::string(5000, 'x'));
    const bool said = !written && written.error().message().find("ulimit -f") != std::string::npos;
    ::_exit(said ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_TRUE(folder.isEmpty());
}

}  // namespace
}  // namespace tactus::base
