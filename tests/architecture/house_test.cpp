// The size of the house: what hurts whoever works in it may only fall. docs: CONTRIBUTING.md, "How the code looks".
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tactus {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestFile = 500;
/// Lower it when it falls.
constexpr std::size_t kMostHeadersWithOneUser = 49;

struct SourceFile {
  std::size_t lines = 0;
  std::set<std::string> includes;  ///< headers of the project
};

using Sources = std::map<std::string, SourceFile>;

Sources sourcesOf(const std::vector<const char*>& folders) {
  const fs::path root = TACTUS_SOURCE_DIR;
  Sources sources;
  for (const char* folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto extension = entry.path().extension();
      if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp")) continue;
      SourceFile& file = sources[fs::relative(entry.path(), root).generic_string()];
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line); ++file.lines) {
        if (!line.starts_with("#include \"")) continue;
        const std::size_t begin = line.find('"') + 1;
        file.includes.insert(line.substr(begin, line.find('"', begin) - begin));
      }
    }
  }
  return sources;
}

/// Headers that a single source includes, beside their own .cpp file.
std::vector<std::string> headersWithOneUser(const Sources& sources) {
  std::map<std::string, std::vector<std::string>> users;
  for (const auto& [name, file] : sources) {
    for (const auto& header : file.includes) users[header].push_back(name);
  }
  std::vector<std::string> found;
  for (const auto& [name, file] : sources) {
    if (!name.ends_with(".h")) continue;
    const std::string own = name.substr(0, name.size() - 1) + "cpp";
    const auto& all = users[name];
    if (std::count_if(all.begin(), all.end(), [&](const auto& user) { return user != own; }) == 1)
      found.push_back(name);
  }
  return found;
}

TEST(House, FilesHeadersAndLinesDoNotGrowBeyondTheirLimits) {
  const Sources sources = sourcesOf({"app", "core", "elicitation", "experiments", "questionnaires"});
  const Sources tests = sourcesOf({"tests"});
  const auto lonely = headersWithOneUser(sources);
  EXPECT_LE(lonely.size(), kMostHeadersWithOneUser)
      << "a header with one user belongs into that user; the last of the list: " << lonely.back();

  std::size_t lines = 0;
  std::size_t test_lines = 0;
  std::vector<std::size_t> lengths;
  std::pair<std::size_t, std::string> longest;
  for (const auto& [name, file] : sources) {
    lines += file.lines;
    lengths.push_back(file.lines);
    longest = std::max(longest, {file.lines, name});
    EXPECT_LE(file.lines, kLongestFile) << name;
  }
  for (const auto& [name, file] : tests) test_lines += file.lines;
  ASSERT_FALSE(lengths.empty());
  std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2), lengths.end());
  std::cout << "House: " << sources.size() << " source files, " << lines << " lines, median "
            << lengths[lengths.size() / 2] << ", longest " << longest.first << " (" << longest.second << "), "
            << lonely.size() << " headers with one user; " << tests.size() << " files of tests, " << test_lines
            << " lines\n";
}

}  // namespace
}  // namespace tactus
