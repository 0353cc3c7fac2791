// Who may depend on whom, read off the include lines. The picture of this table: ARCHITECTURE.md.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tactus {
namespace {

namespace fs = std::filesystem;

/// What the files of one folder may include: folders of the project, and libraries by the start of their headers.
struct Permission {
  std::set<std::string> folders;
  std::set<std::string> libraries;
};

const std::string kJson = "nlohmann/";
const std::string kOutcome = "tl/expected.hpp";

/// Every source folder must be listed: a new one has to say where it stands.
const std::map<std::string, Permission>& permissions() {
  static const std::set<std::string> core = {"core/base", "core/fuzzy", "core/analysis", "core/study", "core/model_io"};
  static const std::map<std::string, Permission> table = {
      {"core/base", {{}, {kOutcome, kJson}}},
      {"core/fuzzy", {{"core/base"}, {}}},
      {"core/analysis", {{"core/base", "core/fuzzy"}, {}}},
      {"core/render", {{"core/base", "core/fuzzy"}, {}}},
      {"core/study", {{"core/base"}, {}}},
      {"core/haptics", {{"core/base", "core/fuzzy", "core/render", "core/study"}, {}}},
      {"core/haptics/simulated", {{"core/base", "core/haptics", "core/study"}, {}}},
      {"core/haptics/hid", {{"core/base", "core/haptics"}, {"hidapi/", "linux/"}}},
      {"core/haptics/openhaptics", {{"core/base", "core/haptics"}, {}}},
      {"core/store", {{"core/base", "core/model_io", "core/study"}, {kJson, "SQLiteCpp/", "sqlite3.h"}}},
      {"core/model_io", {{"core/base", "core/fuzzy"}, {}}},
      {"experiments", {{"core/base", "core/study"}, {}}},
      {"elicitation", {{"core/base", "core/fuzzy", "core/analysis", "core/study"}, {kJson}}},
      {"questionnaires", {{"core/base", "core/study"}, {kJson}}},
      {"app/session",
       {{"core/base", "core/fuzzy", "core/study", "core/store", "experiments", "elicitation", "questionnaires"},
        {kJson}}},
      {"app/simulation", {{"core/base", "core/fuzzy", "core/render", "core/haptics", "core/haptics/simulated"}, {}}},
      {"app/devices",
       {{"core/base", "core/haptics", "core/haptics/simulated", "core/haptics/hid", "core/haptics/openhaptics"}, {}}},
      {"app/report",
       {{"app/simulation", "core/render", "core/haptics", "core/haptics/simulated", "core/base", "core/fuzzy",
         "core/analysis", "core/study", "experiments", "elicitation"},
        {}}},
      {"app/editing", {{"core/base", "core/fuzzy", "core/analysis", "core/study", "core/model_io", "elicitation"}, {}}},
      {"app/cli",
       {{"app", "app/session", "app/simulation", "app/devices", "app/report", "experiments", "elicitation",
         "questionnaires", "core/base", "core/fuzzy", "core/analysis", "core/study", "core/store", "core/model_io"},
        {"CLI/"}}},
      {"app/workbench",
       {{"app", "app/workbench/controllers", "app/workbench/views", "core/base", "core/fuzzy"}, {"Q"}}},
      {"app/workbench/controllers",
       {{"app", "app/workbench", "app/devices", "app/editing", "app/session", "core/base", "core/fuzzy",
         "core/analysis", "core/haptics", "core/haptics/simulated", "core/model_io", "core/store", "core/study",
         "elicitation"},
        {"Q"}}},
      {"app/workbench/models",
       {{"app/editing", "app/workbench", "app/workbench/controllers", "core/base", "core/fuzzy"}, {"Q"}}},
      {"app/workbench/plots",
       {{"app/workbench", "app/workbench/controllers", "core/base", "core/fuzzy", "core/analysis"},
        {"Q", "qcustomplot.h"}}},
      {"app/workbench/views",
       {{"app", "app/editing", "app/workbench", "app/workbench/controllers", "app/workbench/models",
         "app/workbench/plots", "core/base", "core/fuzzy", "core/analysis", "core/haptics", "core/study"},
        {"Q"}}},
      {"app", {{}, {}}},
  };
  return table;
}

/// Toolkit widgets have no place in controllers.
const std::set<std::string> kWidgetHeaders = {"QWidget", "QMainWindow", "QLabel",      "QPushButton",
                                              "QSlider", "QDialog",     "QMessageBox", "QFileDialog"};

bool isSource(const fs::path& path) { return path.extension() == ".h" || path.extension() == ".cpp"; }

/// Headers of the language and of POSIX: no slash but these, and no capital letter at the start.
bool isSystemHeader(const std::string& header) {
  if (header.find("qcustomplot") != std::string::npos || header.starts_with("sqlite") || header.starts_with("hid"))
    return false;
  if (header.starts_with("gmp")) return false;
  return header.starts_with("sys/") ||
         (header.find('/') == std::string::npos && std::islower(static_cast<unsigned char>(header[0])));
}

class IncludeLines : public testing::Test {
 protected:
  const fs::path root_ = TACTUS_SOURCE_DIR;

  std::string folderOf(const fs::path& file) const { return fs::relative(file.parent_path(), root_).generic_string(); }

  void checkLine(const fs::path& file, const std::string& line) const {
    const auto open = line.find_first_of("<\"");
    const auto close = line.find_first_of(">\"", open + 1);
    ASSERT_NE(close, std::string::npos) << file << ": " << line;
    const std::string header = line.substr(open + 1, close - open - 1);
    const std::string here = folderOf(file);
    const auto permission = permissions().find(here);
    ASSERT_NE(permission, permissions().end()) << "folder " << here << " is not in the table of this test";

    if (line[open] == '"' && fs::exists(root_ / header)) {
      const std::string target = folderOf(root_ / header);
      EXPECT_TRUE(target == here || permission->second.folders.contains(target))
          << file << " may not include " << header;
      return;
    }
    if (isSystemHeader(header)) return;
    bool allowed = header == kOutcome;
    for (const auto& library : permission->second.libraries) allowed = allowed || header.starts_with(library);
    EXPECT_TRUE(allowed) << file << " may not include " << header;
    if (header.starts_with(kJson)) {
      EXPECT_TRUE(file.extension() == ".cpp" || file.filename() == "json_reading.h")
          << file << ": JSON stays out of headers";
    }
    if (here == "app/workbench/controllers") {
      EXPECT_FALSE(kWidgetHeaders.contains(header)) << file << ": controllers know no widget";
    }
  }
};

TEST_F(IncludeLines, EachFolderIncludesOnlyWhatItMay) {
  int files = 0;
  int lines = 0;
  for (const char* top : {"core", "elicitation", "experiments", "questionnaires", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root_ / top)) {
      if (!entry.is_regular_file() || !isSource(entry.path())) continue;
      ++files;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("#include")) continue;
        ++lines;
        checkLine(entry.path(), line);
      }
    }
  }
  EXPECT_GT(files, 80);
  EXPECT_GT(lines, 300);
}

TEST_F(IncludeLines, EveryHeaderSaysWhatItIsFor) {
  for (const char* top : {"core", "elicitation", "experiments", "questionnaires", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root_ / top)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream file(entry.path());
      std::string line;
      std::getline(file, line);
      EXPECT_TRUE(line.starts_with("// ")) << entry.path();
    }
  }
}

}  // namespace
}  // namespace tactus
