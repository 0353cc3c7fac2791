// Broken input: exit status 1, one sentence on one line that says where and what, and no output file.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>

#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

void expectRefused(const std::vector<std::string>& arguments, const std::string& says) {
  const ProgramRun run(arguments);
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(run.err.starts_with("tactus: ")) << run.err;
  for (const char* part : {says.c_str(), "found ", "wanted "})
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

class BrokenInput : public testing::Test {
 protected:
  void expectModelRefused(const std::string& text, const std::string& says) {
    writeText(file_, text);
    const std::string out = folder_.file("out.csv");
    expectRefused({"check", file_}, says);
    expectRefused({"eval", file_, "--in", points_, "--out", out}, says);
    EXPECT_FALSE(std::filesystem::exists(out));
  }

  support::TempFolder folder_;
  std::string file_ = folder_.file("broken");
  std::string points_ = folder_.file("points.csv");
  std::string good_ = model_io::formatModel(support::s4AsPrinted());
};

TEST_F(BrokenInput, ModelFiles) {
  writeText(points_, "lubrication,neck_flexion,depth,speed\n1,45,30,30\n");
  expectModelRefused("", "an empty text");
  expectModelRefused(good_.substr(0, good_.size() / 2), "line ");
  expectModelRefused(replaced(good_, "\"max\": 600", "\"max\": NaN"), "line ");
  expectModelRefused(replaced(good_, "[60, 80, 105, 125]", "[60, 80, 125, 105]"), "/inputs/2/terms/1/points/3");
  expectModelRefused(replaced(good_, "\"depth\": \"stomach\"", "\"depth\": \"knee\""), "'knee'");
  expectModelRefused(replaced(good_, "\"version\": 1", "\"version\": 2"), "/version");
  expectModelRefused(std::string(1000, '\0'), "line 1");
  const auto rule = good_.find("{ \"if\"");
  const std::string first = good_.substr(rule, good_.find("},", good_.find("},", rule) + 1) - rule);
  expectModelRefused(replaced(good_, first, first + " },\n " + first), "earlier");
}

TEST_F(BrokenInput, HugeGarbageIsRefusedBySize) {
  writeText(file_, "x");
  std::filesystem::resize_file(file_, 200'000'000);
  expectRefused({"check", file_}, "200000000 bytes");
}

TEST_F(BrokenInput, MissingFilesAndFolders) {
  expectRefused({"check", folder_.file("none")}, "none: found No such file");
  expectRefused({"build", folder_.file("none"), "--out", folder_.file("m")}, "none");
  expectRefused({"cluster", folder_.file("none")}, "none");
  expectRefused({"vote", folder_.file("none")}, "none");
  EXPECT_TRUE(folder_.isEmpty());
}

TEST_F(BrokenInput, PointsOfEval) {
  const std::string model = folder_.file("m.tactus.json");
  writeText(model, good_);
  const auto expect = [&](const std::string& csv, const std::string& says) {
    writeText(points_, csv);
    expectRefused({"eval", model, "--in", points_}, says);
  };
  expect("", "an empty table");
  expect("lubrication,neck_flexion,speed\n1,2,3\n", "'depth'");
  expect("lubrication,neck_flexion,depth,speed\n1,2,3\n", "line 2: found 3 cells");
  expect("lubrication,neck_flexion,depth,speed\n1,2,,4\n", "line 2, column 'depth': found an empty cell");
  expect("lubrication,neck_flexion,depth,speed\n1,2,\"3,4\n", "quote");
  expect("lubrication,neck_flexion,depth,speed\n1,2,\"1,5\",4\n", "'1,5'");
  expect("lubrication,neck_flexion,depth,speed,force\n1,2,3,4,5\n", "'force'");
  expect("lubrication,neck_flexion,depth,depth\n", "twice");
}

TEST_F(BrokenInput, SpeedsOfCluster) {
  const auto expect = [&](const std::string& csv, const std::string& says, std::vector<std::string> options = {}) {
    writeText(file_, csv);
    options.insert(options.begin(), {"cluster", file_});
    expectRefused(options, says);
  };
  expect("speed\n1\n", "'speed_mm_s'");
  expect("speed_mm_s\n1\n2\nnan\n", "line 4");
  expect("speed_mm_s\n1\n2\n", "distinct");
}

TEST_F(BrokenInput, JudgementsOfVote) {
  const auto expect = [&](const std::string& csv, const std::string& says) {
    writeText(file_, csv);
    expectRefused({"vote", file_}, says);
  };
  expect("participant,series,step,force_n\n", "'term'");
  expect("participant,series,step,force_n,term\nA,ascending,1,0.1,tiny\n", "'tiny'");
  expect("force_n,very_small,small,medium,large,very_large\n0.1,1,1,0,0,-3\n", "'-3'");
}

TEST_F(BrokenInput, ABuildThatFailsWritesNothing) {
  const std::string study = folder_.file("study");
  std::filesystem::create_directory(study);
  writeText(study + "/participants.csv",
            "participant,years_experience,category,handedness,weight,simulated\nA,12,expert,right,,\n");
  writeText(study + "/answers.csv", "participant,form,item,term,status\nA,ngt-force-v1,46,small,answered\n");
  const std::string out = folder_.file("model.tactus.json");
  expectRefused({"build", study, "--out", out}, "46");
  EXPECT_FALSE(std::filesystem::exists(out));
}

/// What is said of a `found` where a study may be a file or a folder.
TEST_F(BrokenInput, AStudyThatIsNeitherFileNorFolder) {
  const std::string wanted = "wanted a study file, or a folder with participants.csv\n";
  const std::string none = folder_.file("none");
  for (const std::string& path : {none, std::string("/dev/null")}) {
    const std::string found = ": found " + std::string(path == none ? "nothing of this name" : "a device or a pipe");
    for (const std::vector<std::string>& line : {std::vector<std::string>{"build", path, "--out", folder_.file("m")},
                                                 {"report", path, "--out", folder_.file("r")},
                                                 {"study", "compare", path},
                                                 {"study", "export", path, folder_.file("out"), "--layout", "bids"}}) {
      const ProgramRun run(line);
      EXPECT_EQ(run.status, 1);
      EXPECT_EQ(run.err, "tactus: " + path + found + ", " + wanted);
    }
  }
}

/// Nothing that was recorded is replaced by a result.
TEST_F(BrokenInput, AResultReplacesNoInputAndNoStudy) {
  const std::string tables = folder_.file("tables");
  std::filesystem::create_directory(tables);
  writeText(tables + "/participants.csv", "participant\nN1\n");
  writeText(tables + "/answers.csv", "participant,form,item,term,status\nN1,ngt-force-v1,1,small,answered\n");
  const std::string study = folder_.file("a.tactus");
  ASSERT_EQ(ProgramRun({"study", "import", study, tables}).status, 0);
  const std::string other = folder_.file("b.tactus");
  ASSERT_EQ(ProgramRun({"study", "new", other}).status, 0);
  writeText(file_, good_);
  writeText(points_, "lubrication,neck_flexion,depth,speed\n1,60,200,50\n");
  const std::string read = "--out: found a file that the command reads, wanted another file";
  const std::string base = "--out: found a study file or another database, wanted another file";
  const auto expectKept = [&](const std::string& out, std::vector<std::string> line, const std::string& says) {
    const std::string before = readText(out);
    line.insert(line.end(), {"--out", out});
    expectRefused(line, out + ": " + says);
    EXPECT_EQ(readText(out), before) << line[0];
  };
  for (const char* command : {"build", "report"}) {
    expectKept(study, {command, study}, read);
    expectKept(other, {command, study}, base);
    expectKept(tables + "/answers.csv", {command, tables}, read);
    expectKept(tables + "/participants.csv", {command, tables}, read);
  }
  expectKept(points_, {"build", study, "--weights", points_}, read);
  expectKept(file_, {"eval", file_, "--in", points_}, read);
  expectKept(points_, {"eval", file_, "--in", points_}, read);
  expectKept(study, {"eval", file_, "--in", points_}, base);
  expectKept(study, {"import", points_}, base);
  expectKept(points_, {"import", points_}, read);
  expectKept(study, {"simulate", file_, "--scenario", points_}, base);
  const std::vector<std::string> pull = {
      "pull", file_, "--at", "lubrication=1,neck_flexion=60,depth=200,speed=50", "--force", "0.5", "--apply", "1"};
  expectKept(study, pull, base);
  expectKept(file_, pull, read);
}

TEST_F(BrokenInput, ABundleThatIsNoFolder) {
  writeText(folder_.file("file"), "{}");
  EXPECT_EQ(ProgramRun({"verify", folder_.file("file")}).err,
            "tactus: " + folder_.file("file") + ": found a file, wanted the folder of a bundle\n");
  EXPECT_EQ(ProgramRun({"verify", folder_.file("none")}).err,
            "tactus: " + folder_.file("none") + ": found nothing of this name, wanted the folder of a bundle\n");
}

TEST(WrongUsage, AnExportWithoutItsFolder) {
  const ProgramRun run({"study", "export", "a.tactus", "--layout", "bids"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.err.find(": FOLDER is required") != std::string::npos) << run.err;
}

TEST(WrongOutput, HelpThatCannotBeWrittenIsAnError) {
  std::ofstream full("/dev/full");
  std::ostringstream err;
  EXPECT_EQ(run({"--help"}, full, err), 1);
  EXPECT_EQ(err.str(), "tactus: found a standard output that cannot be written to, wanted a pipe or file with room\n");
}

TEST(WrongUsage, HasStatusTwo) {
  const std::vector<std::vector<std::string>> lines = {{},
                                                       {"frob"},
                                                       {"eval"},
                                                       {"eval", "m", "--in", "p", "--method", "guess"},
                                                       {"eval", "m", "--in", "p", "--method", "midpoint:1"},
                                                       {"cluster", "f", "-c", "three"},
                                                       {"build", "s", "--out", "m", "--terms", "mine"},
                                                       {"check", "m", "--frob"}};
  for (const auto& line : lines) {
    const ProgramRun run(line);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err, "");
  }
}

TEST(WrongUsage, NoCommandShowsWhichThereAre) {
  const ProgramRun run(std::vector<std::string>{});
  for (const char* command : {"demo", "build", "eval", "simulate", "study", "devices"}) {
    EXPECT_NE(run.err.find(std::string("\n  ") + command), std::string::npos) << run.err;
  }
}

TEST(WrongUsage, HelpIsNotWrong) {
  for (const char* command : {"demo", "build", "cluster", "vote", "eval", "check"}) {
    const ProgramRun run({command, "--help"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("Usage"), std::string::npos);
  }
  EXPECT_EQ(ProgramRun({"--version"}).status, 0);
}

}  // namespace
}  // namespace tactus::cli
