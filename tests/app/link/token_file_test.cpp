#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sys/stat.h>

#include "app/link/link_sockets.h"

#include "tests/support/temp_folder.h"

namespace tactus::link {
namespace {

namespace fs = std::filesystem;

unsigned modeOf(const std::string& path) { return static_cast<unsigned>(fs::status(path).permissions()); }

void write(const std::string& path, const std::string& text, mode_t mode) {
  std::ofstream(path) << text;
  ::chmod(path.c_str(), mode);
}

TEST(Token, IsTheSameOnlyIfEveryByteIs) {
  EXPECT_TRUE(isSameToken("0123456789abcdef", "0123456789abcdef"));
  EXPECT_FALSE(isSameToken("0123456789abcdee", "0123456789abcdef"));
  EXPECT_FALSE(isSameToken("1123456789abcdef", "0123456789abcdef"));
  EXPECT_FALSE(isSameToken("0123456789abcdef0123456789abcdef", "0123456789abcdef"));
  EXPECT_FALSE(isSameToken("0123", "0123456789abcdef"));
  EXPECT_FALSE(isSameToken("", "0123456789abcdef"));
  EXPECT_FALSE(isSameToken("", ""));
}

TEST(TokenFile, IsMadeForItsOwnerAloneAndReadAgain) {
  const support::TempFolder folder;
  const std::string path = folder.file("token");
  std::string token;
  {
    const auto file = TokenFile::at(path);
    ASSERT_TRUE(file) << file.error().message();
    token = file->token();
    EXPECT_EQ(modeOf(path), 0600U);
  }
  EXPECT_EQ(token.size(), 32U) << "128 bits in hexadecimal digits";
  const auto again = TokenFile::at(path);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->token(), token);
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path).parent_path()), {}), 1) << "nothing unfinished is left";
}

TEST(TokenFile, TakesATokenOfTheUser) {
  const support::TempFolder folder;
  const std::string path = folder.file("token");
  write(path, "my-own-secret-of-the-lab\r\n", 0600);
  const auto file = TokenFile::at(path);
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(file->token(), "my-own-secret-of-the-lab");
}

TEST(TokenFile, NothingElseIsTakenForATokenOrReplaced) {
  const support::TempFolder folder;
  const std::string path = folder.file("token");
  const auto errorOf = [&] {
    const auto file = TokenFile::at(path);
    return file ? "no error" : file.error().message();
  };
  for (const char* text : {"", "short\n", "two words of a file\n", "{\"format\":\"tactus-force-model\"}\nmore\n"}) {
    write(path, text, 0600);
    EXPECT_NE(errorOf().find("found no token"), std::string::npos) << text;
    std::ifstream file(path);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), text);
  }
  write(path, "0123456789abcdef0123456789abcdef\n", 0644);
  EXPECT_NE(errorOf().find("mode 0644"), std::string::npos);
  fs::remove(path);
  fs::create_directory(path);
  EXPECT_NE(errorOf().find("found a folder"), std::string::npos);
  const auto nowhere = TokenFile::at(folder.file("none/token"));
  ASSERT_FALSE(nowhere);
  EXPECT_NE(nowhere.error().message().find("No such file or directory"), std::string::npos);
}

TEST(TokenFile, APrivateFolderIsRemovedAtTheEnd) {
  std::set<std::string> tokens;
  std::string path;
  for (int i = 0; i < 20; ++i) {
    const auto file = TokenFile::inPrivateFolder();
    ASSERT_TRUE(file) << file.error().message();
    path = file->path();
    tokens.insert(file->token());
    EXPECT_EQ(modeOf(path), 0600U);
    EXPECT_EQ(modeOf(fs::path(path).parent_path()), 0700U);
  }
  EXPECT_EQ(tokens.size(), 20U);
  EXPECT_FALSE(fs::exists(fs::path(path).parent_path()));
}

}  // namespace
}  // namespace tactus::link
