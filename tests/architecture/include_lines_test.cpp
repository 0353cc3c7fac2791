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
  // What every core folder above it may use.
  const std::set<std::string> base = {"core/base", "core/base/json", "core/base/tables", "core/base/files"};
  const std::set<std::string> haptics = {"core/haptics/device", "core/haptics/safety", "core/haptics/sources",
                                         "core/haptics/servo"};
  const std::set<std::string> elicitation = {"elicitation/clustering",  "elicitation/speed",     "elicitation/force",
                                             "elicitation/rules",       "elicitation/agreement", "elicitation/model",
                                             "elicitation/uncertainty", "elicitation/depth",     "elicitation/tracing"};
  const std::set<std::string> model = {"core/fuzzy", "core/analysis", "core/contracts", "core/study", "core/procedure"};
  const auto joined = [](std::set<std::string> folders, std::initializer_list<std::set<std::string>> more) {
    for (const auto& set : more) folders.insert(set.begin(), set.end());
    return folders;
  };

  // The rooms of the workbench: each may use everything below the window, and the rooms that it names.
  const std::set<std::string> below = joined({"app",
                                              "app/bundle",
                                              "app/demo",
                                              "app/editing",
                                              "app/figures",
                                              "app/link",
                                              "app/planning",
                                              "app/replay",
                                              "app/report",
                                              "app/session",
                                              "app/devices",
                                              "app/webform",
                                              "core/render",
                                              "core/haptics/simulated",
                                              "core/store",
                                              "core/model_io",
                                              "core/exchange/import",
                                              "core/analysis/pull",
                                              "experiments",
                                              "questionnaires"},
                                             {base, haptics, elicitation, model});
  // Plots go through plot/; only what needs more of QCustomPlot than plot/ offers includes it.
  const auto room = [&](const std::set<std::string>& names, bool plots = false) {
    std::set<std::string> folders = below;
    for (const std::string& name : names) folders.insert("app/workbench/" + name);
    std::set<std::string> libraries = {"Q"};
    if (plots) libraries.insert("qcustomplot.h");
    return Permission{folders, libraries};
  };
  const std::set<std::string> shared = {"base", "kit", "model", "plot"};
  const std::set<std::string> rooms = {"base",
                                       "kit",
                                       "model",
                                       "plot",
                                       "deliver",
                                       "tune/terms",
                                       "tune/rules",
                                       "tune/contracts",
                                       "tune/findings",
                                       "tune/history",
                                       "tune/strokes",
                                       "tune/tell",
                                       "understand/curves",
                                       "understand/map",
                                       "understand/here",
                                       "understand/pull",
                                       "device",
                                       "collect",
                                       "labs/data",
                                       "labs/frame",
                                       "labs/origins",
                                       "labs/speed",
                                       "labs/force",
                                       "labs/rules",
                                       "labs/experts",
                                       "labs/depth",
                                       "labs/method",
                                       "labs/plan",
                                       "labs/overview",
                                       "feel",
                                       "feel/recordings",
                                       "feel/duel",
                                       "study/connection",
                                       "study",
                                       "shell",
                                       "help",
                                       "deliver/link",
                                       "participant",
                                       "participant/kit",
                                       "participant/screens",
                                       "session"};

  static const std::map<std::string, Permission> table = {
      {"core/base", {{}, {kOutcome}}},
      {"core/base/json", {{"core/base"}, {kOutcome, kJson}}},
      {"core/base/files", {{"core/base"}, {}}},
      {"core/base/tables", {{"core/base", "core/base/files"}, {}}},
      {"core/fuzzy", {{"core/base", "core/base/json"}, {}}},
      {"core/contracts", {{"core/base", "core/fuzzy"}, {}}},
      {"core/analysis", {{"core/base", "core/fuzzy", "core/contracts"}, {}}},
      {"core/analysis/pull", {{"core/base", "core/fuzzy", "core/analysis"}, {}}},
      {"core/render", {{"core/base", "core/fuzzy"}, {}}},
      {"core/study", {base, {}}},
      {"core/procedure", {joined({"core/fuzzy", "core/study"}, {base}), {}}},
      {"core/haptics/device", {joined({"core/render"}, {base}), {}}},
      {"core/haptics/safety", {{"core/base", "core/render", "core/haptics/device"}, {}}},
      {"core/haptics/sources",
       {{"core/base", "core/fuzzy", "core/render", "core/haptics/device", "core/haptics/safety"}, {}}},
      {"core/haptics/servo",
       {{"core/base", "core/fuzzy", "core/render", "core/haptics/device", "core/haptics/safety",
         "core/haptics/sources"},
        {}}},
      {"core/haptics/simulated", {{"core/base", "core/haptics/device", "core/study"}, {}}},
      {"core/haptics/haply",
       {{"core/base", "core/base/json", "core/haptics/device", "core/haptics/servo", "core/haptics/simulated"},
        {"boost/"}}},
      {"core/haptics/hid", {{"core/base", "core/base/files", "core/haptics/device"}, {"hidapi/", "linux/"}}},
      {"core/haptics/openhaptics", {{"core/base", "core/base/files", "core/haptics/device"}, {}}},
      {"core/store", {joined({"core/model_io", "core/study"}, {base}), {kJson, "SQLiteCpp/", "sqlite3.h", "sodium.h"}}},
      {"core/model_io",
       {{"core/base", "core/base/json", "core/base/files", "core/base/tables", "core/fuzzy", "core/render"}, {}}},
      {"core/exchange", {{"core/base", "core/base/json", "core/fuzzy", "core/render"}, {}}},
      {"core/exchange/import",
       {{"core/base", "core/base/json", "core/base/tables", "core/base/files", "core/fuzzy"}, {}}},
      {"core/runtime",
       {{"core/base", "core/base/files", "core/contracts", "core/fuzzy", "core/render", "core/model_io",
         "core/runtime/include/tactus"},
        {"tactus/"}}},
      // What a simulator builds against knows nothing of this repository.
      {"core/runtime/include/tactus", {{}, {}}},
      {"core/runtime/examples", {{}, {"tactus/"}}},
      {"core/runtime/examples/simulator", {{}, {"tactus/", "netinet/"}}},
      {"core/runtime/examples/engines/sofa", {{}, {"tactus/", "sofa/"}}},
      {"experiments", {joined({"core/study"}, {base}), {}}},
      {"elicitation/clustering", {{"core/base"}, {}}},
      {"elicitation/speed", {joined({"elicitation/clustering"}, {base, model}), {}}},
      {"elicitation/depth", {joined({"core/fuzzy"}, {base}), {}}},
      {"elicitation/force", {joined(model, {base}), {}}},
      {"elicitation/rules", {joined({"elicitation/clustering", "elicitation/force"}, {base, model}), {kJson}}},
      {"elicitation/agreement", {joined({"elicitation/force"}, {base, model}), {kJson}}},
      {"elicitation/model", {joined(elicitation, {base, model}), {kJson}}},
      {"elicitation/uncertainty", {joined(elicitation, {base, model}), {}}},
      {"elicitation/tracing", {joined(elicitation, {base, model}), {}}},
      {"questionnaires", {joined({"core/procedure", "core/study"}, {base}), {kJson}}},
      {"app/session",
       {joined({"core/haptics/device", "core/haptics/safety", "core/model_io", "core/store", "experiments",
                "questionnaires"},
               {base, model, elicitation}),
        {kJson}}},
      {"app/dataset",
       {joined({"app/session", "core/procedure", "core/store", "core/study", "questionnaires"}, {base}), {}}},
      {"app/webform",
       {joined({"app/session", "core/fuzzy", "core/procedure", "core/store", "core/study", "questionnaires"}, {base}),
        {}}},
      {"app/simulation", {joined({"core/fuzzy", "core/render", "core/haptics/simulated"}, {base, haptics}), {}}},
      {"app/devices",
       {joined({"core/haptics/simulated", "core/haptics/haply", "core/haptics/hid", "core/haptics/openhaptics"},
               {base, haptics}),
        {}}},
      {"app/figures", {joined({}, {base, model, elicitation}), {}}},
      {"app/report",
       {joined({"app/figures", "app/living", "app/simulation", "core/render", "core/haptics/simulated", "experiments",
                "questionnaires"},
               {base, haptics, model, elicitation}),
        {}}},
      {"app/demo",
       {joined({"app", "app/report", "app/session", "app/simulation", "core/model_io", "core/store", "questionnaires"},
               {base, model, elicitation}),
        {}}},
      {"app/bundle",
       {joined(
            {"app/figures", "app/living", "app/report", "core/analysis", "core/contracts", "core/exchange",
             "core/fuzzy", "core/model_io", "core/procedure", "core/render", "elicitation/force", "elicitation/rules"},
            {base}),
        {}}},
      {"app/living",
       {joined({"app/figures", "core/analysis", "core/exchange", "core/fuzzy", "core/render"}, {base}), {}}},
      {"app/certify",
       {joined({"app/bundle", "app/report", "core/analysis", "core/fuzzy", "core/model_io", "core/render"}, {base}),
        {"netinet/"}}},
      {"app/link", {joined({"core/fuzzy", "core/haptics/servo"}, {base}), {"netinet/"}}},
      {"app/editing", {joined({"core/model_io"}, {base, model, elicitation}), {}}},
      {"app/planning", {joined({"app/session", "experiments", "questionnaires"}, {base, model, elicitation}), {}}},
      {"app/replay",
       {joined({"app/editing", "core/contracts", "core/haptics/sources", "core/model_io", "core/render", "core/store"},
               {base, model, elicitation}),
        {}}},
      {"app/cli",
       {joined({"app",           "app/bundle",        "app/certify",        "app/dataset",          "app/demo",
                "app/editing",   "app/link",          "core/analysis/pull", "app/planning",         "app/replay",
                "app/session",   "app/simulation",    "app/devices",        "app/report",           "app/webform",
                "experiments",   "questionnaires",    "core/exchange",      "core/exchange/import", "core/store",
                "core/model_io", "core/haptics/haply"},
               {base, model, elicitation}),
        {"CLI/"}}},
      {"app/workbench/base", room({})},
      {"app/workbench/kit", room({"base"})},
      {"app/workbench/anatomy", room({"base"})},
      {"app/workbench/model", room({"base"})},
      {"app/workbench/plot", room({"base", "kit", "model"}, true)},
      {"app/workbench/deliver", room({"base", "kit", "model"})},
      {"app/workbench/tune/terms", room(shared)},
      {"app/workbench/tune/rules", room(shared)},
      {"app/workbench/tune/contracts", room({"base", "kit", "model"})},
      {"app/workbench/tune/findings", room(shared)},
      {"app/workbench/tune/history", room(shared)},
      {"app/workbench/tune/strokes", room({"base", "kit", "model", "study/connection"})},
      {"app/workbench/tune/tell", room({"base", "kit", "model", "plot", "tune/history"})},
      {"app/workbench/understand/curves", room(shared)},
      {"app/workbench/understand/map", room(shared)},
      {"app/workbench/understand/here", room(shared)},
      {"app/workbench/understand/pull", room({"base", "kit", "model"})},
      {"app/workbench/desktop", room({"base"})},
      {"app/workbench/device", room({"base"})},
      {"app/workbench/feel", room({"base", "anatomy", "kit", "model", "plot", "device"})},
      {"app/workbench/feel/recordings", room({"base", "kit", "model", "plot", "device", "feel", "study/connection"})},
      {"app/workbench/feel/duel",
       room({"base", "kit", "model", "device", "feel", "feel/recordings", "study/connection"})},
      {"app/workbench/study/connection", room({"base"})},
      {"app/workbench/study", room({"base", "kit", "model", "study/connection"})},
      {"app/workbench/participant",
       room({"base", "device", "study/connection", "participant/kit", "participant/screens"})},
      {"app/workbench/rehearsal",
       room({"base", "device", "study/connection", "participant", "participant/kit", "participant/screens"})},
      {"app/workbench/labs/data", room({"base", "study/connection"})},
      {"app/workbench/labs/frame", room({"base", "kit", "labs/data"})},
      {"app/workbench/labs/origins", room({"base", "kit", "labs/data", "labs/frame"})},
      {"app/workbench/labs/depth", room({"base", "kit", "plot", "anatomy", "labs/data", "labs/frame"})},
      {"app/workbench/labs/speed", room({"base", "kit", "plot", "labs/data", "labs/frame"}, true)},
      {"app/workbench/labs/force", room({"base", "kit", "plot", "labs/data", "labs/frame"})},
      {"app/workbench/labs/experts", room({"base", "kit", "plot", "labs/data", "labs/frame"})},
      {"app/workbench/labs/overview", room({"base", "kit", "labs/data"})},
      {"app/workbench/labs/method", room({"base", "kit", "plot", "labs/data", "labs/frame"})},
      {"app/workbench/labs/plan", room({"base", "kit", "plot", "labs/data", "labs/frame"})},
      {"app/workbench/labs/rules", room({"base", "kit", "model", "plot", "labs/data", "labs/frame"})},
      {"app/workbench/collect", room({"base", "kit", "study/connection"})},
      {"app/workbench/shell", room({"base", "kit", "model"})},
      {"app/workbench/help", room({"base", "kit"})},
      {"app/workbench/deliver/link", room({"base", "kit", "model"})},
      {"app/workbench/participant/kit", room({"base", "anatomy"})},
      {"app/workbench/participant/screens", room({"base", "anatomy", "participant/kit"})},
      {"app/workbench/session", room({"base", "kit", "device", "collect", "shell", "study/connection", "participant",
                                      "participant/kit", "participant/screens", "rehearsal"})},
      // The features join the rooms, and the root has the features.
      {"app/workbench/features", room(rooms)},
      {"app/workbench", room(joined(rooms, {{"desktop", "rehearsal", "features"}}))},
      {"app", {{}, {}}},
  };
  return table;
}

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
      EXPECT_EQ(file.extension(), ".cpp") << file << ": JSON stays out of headers";
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
      // The C interface is clean C89, which has no other comments.
      const bool c = entry.path().filename() == "tactus.h";
      EXPECT_TRUE(line.starts_with(c ? "/* " : "// ")) << entry.path();
    }
  }
}

}  // namespace
}  // namespace tactus
