// `study form --responses`: from a survey system's export into a study file.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class StudyResponsesTest : public testing::Test {
 protected:
  StudyResponsesTest() {
    const std::string tables = folder_.file("tables");
    std::filesystem::create_directory(tables);
    writeText(tables + "/participants.csv",
              "participant,years_experience,category,simulated\nvelvet-otter,8,expert,0\n");
    EXPECT_EQ(ProgramRun({"study", "import", study_, tables}).status, 0);
    std::string head = "record_id";
    std::string first = "velvet-otter";
    std::string second = "amber-lynx";
    for (int item = 1; item <= 45; ++item) {
      head += (item < 10 ? ",q0" : ",q") + std::to_string(item);
      first += ",4";
      second += item == 1 ? ",9" : ",1";
    }
    writeText(responses_, head + "\n" + first + "\n" + second + "\n");
  }

  ProgramRun read() const { return ProgramRun({"study", "form", study_, "--responses", responses_, "--out", out_}); }

  support::TempFolder folder_;
  std::string study_ = folder_.file("a.tactus");
  std::string responses_ = folder_.file("responses.csv");
  std::string out_ = folder_.file("answers");
};

TEST_F(StudyResponsesTest, BecomeTablesThatTheStudyImports) {
  const ProgramRun run = read();
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, out_ + ": 2 participants, 89 answers; `tactus study import STUDY " + out_ + "` adds them\n");
  const std::string answers = readText(out_ + "/answers.csv");
  EXPECT_NE(answers.find("velvet-otter,ngt-force-v1,1,large,answered\n"), std::string::npos);
  EXPECT_NE(answers.find("amber-lynx,ngt-force-v1,1,,cant_tell\n"), std::string::npos);
  // What the study knows of a person stays.
  EXPECT_NE(readText(out_ + "/participants.csv").find("velvet-otter,8,expert,,,0\n"), std::string::npos);

  const ProgramRun imported({"study", "import", study_, out_, "--json"});
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_EQ(nlohmann::json::parse(imported.out)["persons"], 1);
  ASSERT_EQ(ProgramRun({"study", "export", study_, folder_.file("all")}).status, 0);
  EXPECT_EQ(readText(folder_.file("all") + "/participants.csv"),
            "participant,years_experience,category,handedness,weight,simulated\namber-lynx,,,,,0\n"
            "velvet-otter,8,expert,,,0\n");
}

TEST_F(StudyResponsesTest, TablesThatAreThereAreNotReplaced) {
  ASSERT_EQ(read().status, 0);
  const ProgramRun again = read();
  EXPECT_EQ(again.status, 1);
  EXPECT_EQ(again.err,
            "tactus: " + out_ +
                ": found a folder that holds participants.csv, wanted a folder without the tables of a study\n");
}

TEST_F(StudyResponsesTest, RecordIdsLeadToCodesByATable) {
  const std::string map = folder_.file("map.csv");
  writeText(map, "record,participant\nvelvet-otter,N1\namber-lynx,N2\n");
  const ProgramRun run(
      {"study", "form", study_, "--responses", responses_, "--participants", map, "--out", out_, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["answered"], 89);
  EXPECT_NE(readText(out_ + "/participants.csv").find("N2,,,,,0\n"), std::string::npos);
  writeText(map, "record,participant\nvelvet-otter,N1\nvelvet-otter,N2\n");
  std::filesystem::remove_all(out_);
  const ProgramRun twice({"study", "form", study_, "--responses", responses_, "--participants", map, "--out", out_});
  EXPECT_EQ(twice.err, "tactus: " + map + ": line 3, column 'record': found 'velvet-otter', wanted each record once\n");
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(StudyResponsesTest, WrongRequestsAreRefused) {
  EXPECT_EQ(ProgramRun({"study", "form", study_, "--out", out_}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "form", study_, "--to", "print", "--responses", responses_, "--out", out_}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "form", study_, "--to", "print", "--missing", "-9", "--out", out_}).status, 2);
  writeText(responses_, "record_id,q01\n");
  const ProgramRun empty = read();
  EXPECT_EQ(empty.status, 1);
  EXPECT_NE(empty.err.find("found no column 'q02'"), std::string::npos) << empty.err;
}

}  // namespace
}  // namespace tactus::cli
