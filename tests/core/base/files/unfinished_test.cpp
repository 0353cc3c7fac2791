#include "core/base/files/unfinished.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "tests/support/temp_folder.h"

namespace tactus::base {
namespace {

namespace fs = std::filesystem;

TEST(Unfinished, NamesTellWhoseTheyAre) {
  EXPECT_TRUE(isUnfinishedName("s.tactus.tactus-aZ09xy", "s.tactus"));
  EXPECT_TRUE(isUnfinishedName("s.tactus.import-aZ09xy", "s.tactus", ".import-"));
  for (const char* const other : {"s.tactus", "s.tactus.backup", "s.tactus.tactus-", "s.tactus.tactus-aZ09x",
                                  "s.tactus.tactus-aZ09xyz", "s.tactus.tactus-aZ09x.", "t.tactus.tactus-aZ09xy"}) {
    EXPECT_FALSE(isUnfinishedName(other, "s.tactus")) << other;
  }
}

TEST(Unfinished, FilesAndFoldersAreNewAndPrivate) {
  const support::TempFolder folder;
  const std::string path = folder.file("s.tactus");
  const auto file = makeUnfinishedFile(path, 0600);
  ASSERT_TRUE(file.descriptor.isOpen());
  EXPECT_TRUE(isUnfinishedName(fs::path(file.path).filename().string(), "s.tactus"));
  EXPECT_EQ(static_cast<unsigned>(fs::status(file.path).permissions()), 0600U);
  const auto made = makeUnfinishedFolder(path, ".import-");
  ASSERT_TRUE(made.descriptor.isOpen());
  EXPECT_EQ(static_cast<unsigned>(fs::status(made.path).permissions()), 0700U);
  EXPECT_FALSE(makeUnfinishedFile(folder.file("none/x"), 0600).descriptor.isOpen());
}

TEST(Unfinished, WhatIsInUseIsNotTaken) {
  const support::TempFolder folder;
  auto made = makeUnfinishedFolder(folder.file("s"), ".import-");
  EXPECT_FALSE(takeUnused(made.path).isOpen());
  made.descriptor.close();
  EXPECT_TRUE(takeUnused(made.path).isOpen());
  EXPECT_FALSE(takeUnused(folder.file("nothing")).isOpen());
  fs::create_symlink(made.path, folder.file("link"));
  EXPECT_FALSE(takeUnused(folder.file("link")).isOpen()) << "what a link names is not ours";
}

}  // namespace
}  // namespace tactus::base
