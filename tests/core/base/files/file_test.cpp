#include "core/base/files/file.h"

#include <array>
#include <atomic>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "tests/support/temp_folder.h"

namespace tactus::base {
namespace {

namespace fs = std::filesystem;

TEST(File, WhatIsWrittenReadsBack) {
  const support::TempFolder folder;
  const std::string path = folder.file("Größe 1.bin");
  const std::string bytes("a\0b\r\n\xFF", 6);
  ASSERT_TRUE(writeFileAtomically(path, bytes).has_value());
  EXPECT_EQ(readFile(path, 6), bytes);
  ASSERT_TRUE(writeFileAtomically(path, "").has_value());
  EXPECT_EQ(readFile(path, 0), "");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("")), fs::directory_iterator()), 1);
}

TEST(File, TheSizeLimitHoldsForSparseFilesAndPipes) {
  const support::TempFolder folder;
  const std::string path = folder.file("huge");
  std::ofstream(path).put('x');
  fs::resize_file(path, 200'000'000);
  EXPECT_EQ(readFile(path, 1000).error().code, ErrorCode::kLimit);
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const std::string text(3000, 'x');
  ASSERT_EQ(::write(ends[1], text.data(), text.size()), 3000);
  ::close(ends[1]);
  EXPECT_EQ(readFile("/dev/fd/" + std::to_string(ends[0]), 1000).error().code, ErrorCode::kLimit);
  ::close(ends[0]);
}

TEST(File, WhatCannotBeReadIsSaid) {
  const support::TempFolder folder;
  EXPECT_EQ(readFile(folder.file("none"), 10).error().message(),
            folder.file("none") + ": found No such file or directory, wanted a readable file");
  EXPECT_EQ(readFile(folder.file(""), 10).error().message(), folder.file("") + ": found a folder, wanted a file");
}

TEST(File, AFailedWriteLeavesNothingBehind) {
  const support::TempFolder folder;
  EXPECT_EQ(writeFileAtomically(folder.file("none/x"), "text").error().code, ErrorCode::kIo);
  ASSERT_TRUE(makeFolder(folder.file("taken")).has_value());
  EXPECT_EQ(writeFileAtomically(folder.file("taken"), "text").error().code, ErrorCode::kIo);
  EXPECT_TRUE(fs::is_empty(folder.file("taken")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("")), fs::directory_iterator()), 1);
}

TEST(File, ALinkStaysALinkAndTheModeStays) {
  const support::TempFolder folder;
  const std::string real = folder.file("real");
  ASSERT_TRUE(writeFileAtomically(real, "old").has_value());
  fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("real", folder.file("link"));
  ASSERT_TRUE(writeFileAtomically(folder.file("link"), "new").has_value());
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_EQ(readFile(real, 10), "new");
  EXPECT_EQ(fs::status(real).permissions(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST(File, ANewFileHasTheUsualMode) {
  const support::TempFolder folder;
  const mode_t before = ::umask(027);
  const auto written = writeFileAtomically(folder.file("x"), "");
  ::umask(before);
  ASSERT_TRUE(written.has_value());
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder.file("x")).permissions()), 0640U);
}

TEST(File, TheMaskOfTheProcessIsNeverTouched) {
  // The mask of the threads that make files meanwhile: with 027 a file of mode 0666 or 0667 would tell of a change.
  const support::TempFolder folder;
  const mode_t before = ::umask(027);
  std::atomic<bool> ends{false};
  std::atomic<int> wrong{0};
  std::thread other([&] {
    for (int i = 0; !ends; ++i) {
      const std::string name = folder.file("other" + std::to_string(i));
      ::close(::open(name.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0666));
      if (static_cast<unsigned>(fs::status(name).permissions()) != 0640U) ++wrong;
      ::unlink(name.c_str());
    }
  });
  for (int i = 0; i < 300; ++i) EXPECT_TRUE(writeFileAtomically(folder.file("x" + std::to_string(i)), ""));
  ends = true;
  other.join();
  ::umask(before);
  EXPECT_EQ(wrong, 0);
}

TEST(File, HashesAreThoseOfSha256sum) {
  const support::TempFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder.file("b.csv"), "abc"));
  ASSERT_TRUE(writeFileAtomically(folder.file("a.csv"), ""));
  EXPECT_EQ(fileSha256(folder.file("b.csv")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  // printf abc > b.csv; : > a.csv; sha256sum b.csv a.csv | sha256sum
  EXPECT_EQ(listingSha256(folder.file(""), {"b.csv", "none.csv", "a.csv"}),
            "a2208d92bf7b7db8cbebb928ab97e09b9753099a97157fa4bd3319e6841491ae");
  EXPECT_FALSE(fileSha256(folder.file("none")));
  EXPECT_FALSE(fileSha256("/dev/zero"));
}

TEST(File, APrivateFolderIsOnlyTheUsers) {
  const support::TempFolder folder;
  ASSERT_TRUE(makeFolder(folder.file("a/b"), FolderMode::kPrivate).has_value());
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder.file("a/b")).permissions()), 0700U);
  fs::permissions(folder.file("a/b"), fs::perms::all);
  ASSERT_TRUE(makeFolder(folder.file("a/b"), FolderMode::kPrivate).has_value());
  EXPECT_EQ(fs::status(folder.file("a/b")).permissions(), fs::perms::all) << "one that is there stays as it is";
  EXPECT_EQ(makeFolder("/dev/null/x", FolderMode::kPrivate).error().code, ErrorCode::kIo);
}

TEST(File, APipeIsWrittenIntoAndStaysAPipe) {
  const support::TempFolder folder;
  const std::string path = folder.file("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  // Opened for both ways, so that neither end waits for the other.
  const int reader = ::open(path.c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(writeFileAtomically(path, "hello").has_value());
  std::array<char, 16> got{};
  EXPECT_EQ(::read(reader, got.data(), got.size()), 5);
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(path));
}

TEST(File, FoldersAreMadeWithTheirParents) {
  const support::TempFolder folder;
  EXPECT_TRUE(makeFolder(folder.file("a/b/c")).has_value());
  EXPECT_TRUE(makeFolder(folder.file("a/b/c")).has_value());
  EXPECT_TRUE(fs::is_directory(folder.file("a/b/c")));
  std::ofstream(folder.file("f")).put('x');
  EXPECT_EQ(makeFolder(folder.file("f")).error().code, ErrorCode::kIo);
  EXPECT_EQ(makeFolder(folder.file("f/g")).error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace tactus::base
