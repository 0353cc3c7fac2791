// ARCHITECTURE.md and the README of each folder lead people to files, types and functions by name. Each name must
// exist.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace tactus {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The texts between backticks, without those of blocks of code.
std::vector<std::string> namesIn(const std::string& document) {
  std::vector<std::string> names;
  std::istringstream lines(document);
  bool block = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) block = !block;
    if (block) continue;
    for (std::size_t from = line.find('`'); from != std::string::npos;) {
      const std::size_t to = line.find('`', from + 1);
      if (to == std::string::npos) break;
      names.push_back(line.substr(from + 1, to - from - 1));
      from = line.find('`', to + 1);
    }
  }
  return names;
}

/// The files and folders of the repository by path, and every word of its sources.
class Repository {
 public:
  Repository() {
    const fs::path root = TACTUS_SOURCE_DIR;
    for (const auto& entry : fs::directory_iterator(root)) {
      if (entry.is_regular_file()) add(entry.path().filename().generic_string(), entry.path());
    }
    for (const char* top : {".ci", "app", "cmake", "core", "docs", "elicitation", "experiments", "packaging",
                            "questionnaires", "tests"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
        if (entry.is_regular_file()) add(fs::relative(entry.path(), root).generic_string(), entry.path());
        if (entry.is_directory()) places_.insert(fs::relative(entry.path(), root).generic_string());
      }
      places_.insert(top);
    }
  }

  bool hasWord(const std::string& word) const { return words_.contains(word) || stems_.contains(word); }
  /// A file or a folder by the end of its path, a file also without its extension.
  bool hasPath(const std::string& path) const {
    return std::any_of(places_.begin(), places_.end(),
                       [&path](const std::string& place) { return place == path || place.ends_with('/' + path); });
  }

 private:
  void add(const std::string& path, const fs::path& file) {
    places_.insert({path, path.substr(0, path.rfind('.'))});
    stems_.insert(file.stem().string());
    static const std::set<std::string> kSources = {".h", ".cpp", ".hpp", ".cs", ".cmake", ".txt", ".json", ".sql"};
    // Golden data are no sources.
    if (!kSources.contains(file.extension().string()) || path.starts_with("tests/golden")) return;
    std::string word;
    for (const char c : textOf(file) + ' ') {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
        word += c;
      } else if (!word.empty()) {
        words_.insert(std::move(word));
        word.clear();
      }
    }
  }

  std::set<std::string> places_;
  std::set<std::string> stems_;
  std::set<std::string> words_;
};

/// The page of the whole, and that of each folder with sources.
std::vector<fs::path> pages() {
  const fs::path root = TACTUS_SOURCE_DIR;
  std::vector<fs::path> all = {root / "ARCHITECTURE.md", root / "tests" / "README.md"};
  for (const char* top : {"app", "core", "elicitation", "experiments", "questionnaires"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      // That of the package for Unity speaks of projects there.
      const bool elsewhere = entry.path().generic_string().find("/unity/") != std::string::npos;
      if (entry.path().filename() == "README.md" && !elsewhere) all.push_back(entry.path());
    }
  }
  return all;
}

TEST(NamedPlaces, EveryNameExists) {
  const Repository repository;
  const std::regex name("[A-Za-z]\\w*(::[A-Za-z]\\w*)*");
  const std::regex path("\\.?[A-Za-z][\\w-]*([./][\\w-]+)+");
  const std::regex placeholder(".*\\b[\\w]*[A-Z]{4,}\\b.*");
  int checked = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& each : namesIn(textOf(page))) {
      if (std::regex_match(each, placeholder)) continue;
      if (std::regex_match(each, name)) {
        for (std::size_t from = 0; from < each.size();) {
          const std::size_t to = std::min(each.find("::", from), each.size());
          const std::string part = each.substr(from, to - from);
          EXPECT_TRUE(repository.hasWord(part) || repository.hasPath(part))
              << page << ": `" << each << "`: there is no " << part;
          from = to + 2;
        }
        ++checked;
      } else if (std::regex_match(each, path)) {
        EXPECT_TRUE(repository.hasPath(each)) << page << ": `" << each << "`: there is no such file or folder";
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 300);
}

// Who needs an index has too many places.
TEST(NamedPlaces, ThePagesAreShort) {
  for (const fs::path& page : pages()) {
    const std::string text = textOf(page);
    const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    EXPECT_LE(lines, page.filename() == "ARCHITECTURE.md" ? 90 : 25) << page;
  }
}

}  // namespace
}  // namespace tactus
