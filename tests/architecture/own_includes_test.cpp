// A file includes what it names from other namespaces of the project, by itself or through what it includes. Where
// several files are compiled at once, the compiler does not miss an include that another of them has; one by one, as
// the library is built elsewhere, it does.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tactus {
namespace {

namespace fs = std::filesystem;

using Name = std::pair<std::string, std::string>;  // the last part of a namespace, and what is declared there

struct Source {
  std::vector<std::string> includes;
  std::map<Name, bool> declares;  ///< true: it is no `class Name;` alone
  std::set<Name> names;           ///< `part::name`, wherever it stands
};

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string wordAt(std::string_view line, std::size_t begin) {
  std::size_t end = begin;
  while (end < line.size() && isWord(line[end])) ++end;
  return std::string(line.substr(begin, end - begin));
}

std::string wordBefore(std::string_view line, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && isWord(line[begin - 1])) --begin;
  return std::string(line.substr(begin, end - begin));
}

/// What a line at the left margin declares: a type, an alias, a constant or a function; empty for anything else.
std::string declaredIn(std::string_view line) {
  if (line.empty() || std::isalpha(static_cast<unsigned char>(line[0])) == 0) return {};
  for (const std::string_view kind : {"enum class ", "class ", "struct ", "using "}) {
    if (!line.starts_with(kind)) continue;
    std::size_t at = kind.size();
    if (line.substr(at).starts_with("[[")) at = line.find("]] ", at) + 3;
    return wordAt(line, at);
  }
  const std::size_t ends = line.find_first_of("={;(");
  if (ends == std::string_view::npos) return {};
  const std::size_t last = line.find_last_not_of(' ', ends - 1);
  return ends == 0 || last == std::string_view::npos ? std::string() : wordBefore(line, last + 1);
}

std::string withoutTexts(std::string_view line) {
  std::string out;
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) inside = !inside;
    if (!inside) out += line[i];
  }
  return out;
}

/// The last part of the namespace that a line opens, with braces; empty without a name.
std::string opened(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" {");
  return last < std::string_view("namespace").size() ? std::string() : wordBefore(line, last + 1);
}

Source read(const fs::path& path) {
  Source out;
  std::vector<std::pair<std::string, int>> spaces;  // with the line that opens each
  std::ifstream in(path);
  int number = 0;
  for (std::string line; std::getline(in, line); ++number) {
    if (line.starts_with("#include \"")) out.includes.push_back(line.substr(10, line.find('"', 10) - 10));
    const bool closes = line.starts_with("}  // namespace");
    line = line.substr(0, line.find("//"));
    if (line.starts_with("namespace ") && line.ends_with('{')) {
      spaces.emplace_back(opened(line), number);
    } else if (!spaces.empty() && (closes || (line == "}" && number == spaces.back().second + 2))) {
      spaces.pop_back();
    } else if (!spaces.empty() && !spaces.back().first.empty()) {
      const std::string name = declaredIn(line);
      const bool ahead = line.ends_with(';') && (line.starts_with("class ") || line.starts_with("struct "));
      if (!name.empty()) out.declares[{spaces.back().first, name}] |= !ahead;
    }
    line = withoutTexts(line);
    for (std::size_t at = line.find("::"); at != std::string::npos; at = line.find("::", at + 2)) {
      Name name = {wordBefore(line, at), wordAt(line, at + 2)};
      if (!name.first.empty() && !name.second.empty()) out.names.insert(std::move(name));
    }
  }
  return out;
}

std::map<std::string, Source> allSources() {
  const fs::path root = TACTUS_SOURCE_DIR;
  std::map<std::string, Source> out;
  for (const char* folder : {"app", "core", "elicitation", "experiments", "questionnaires", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto extension = entry.path().extension();
      if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
        out.emplace(fs::relative(entry.path(), root).generic_string(), read(entry.path()));
    }
  }
  return out;
}

/// The file and all that it includes.
std::set<std::string> reachedFrom(const std::string& name, const std::map<std::string, Source>& sources) {
  std::set<std::string> reached = {name};
  std::vector<std::string> open = {name};
  while (!open.empty()) {
    const Source& source = sources.at(open.back());
    open.pop_back();
    for (const std::string& include : source.includes) {
      if (sources.contains(include) && reached.insert(include).second) open.push_back(include);
    }
  }
  return reached;
}

TEST(OwnIncludes, AFileReachesAHeaderOfEachNameFromAnotherNamespace) {
  const auto sources = allSources();
  std::map<Name, std::string> homes;  // the header of each name
  for (const auto& [file, source] : sources) {
    if (!file.ends_with(".h")) continue;
    for (const auto& [name, defined] : source.declares) {
      if (defined) homes.emplace(name, file);
    }
  }
  // So that a check that reads nothing is noticed.
  ASSERT_EQ(homes.at({"base", "formatNumber"}), "core/base/text.h");
  ASSERT_EQ(homes.at({"base", "JsonMembers"}), "core/base/json/json_members.h");
  std::size_t checked = 0;
  for (const auto& [file, source] : sources) {
    const auto reached = reachedFrom(file, sources);
    for (const Name& name : source.names) {
      const auto home = homes.find(name);
      if (home == homes.end()) continue;
      ++checked;
      EXPECT_TRUE(std::any_of(reached.begin(), reached.end(),
                              [&](const auto& other) { return sources.at(other).declares.contains(name); }))
          << file << " names " << name.first << "::" << name.second << " of " << home->second;
    }
  }
  EXPECT_GT(checked, 5000U);
}

}  // namespace
}  // namespace tactus
