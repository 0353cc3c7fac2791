#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;

/// A folder of tables of two simulated participants, and the commands on study files beside it.
class StudyCommands : public testing::Test {
 protected:
  StudyCommands() {
    fs::create_directory(path("tables"));
    writeText(path("tables/participants.csv"),
              "participant,years_experience,category,handedness,weight,simulated\n"
              "S1,12.25,expert,left,,1\nS2,3,beginner,right,,1\n");
    writeText(
        path("tables/answers.csv"),
        "participant,form,item,term,status\nS1,ngt-force-v1,1,small,answered\nS2,ngt-force-v1,1,large,answered\n");
  }

  std::string path(const std::string& name) const { return folder_.file(name); }
  static ProgramRun fine(const std::vector<std::string>& arguments) {
    const ProgramRun run(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return run;
  }
  static nlohmann::json json(std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    return nlohmann::json::parse(fine(arguments).out);
  }
  nlohmann::json rows(const std::string& file) const { return json({"study", "info", path(file)})["rows"]; }

  support::TempFolder folder_;
};

TEST_F(StudyCommands, NewMakesAnEmptyStudyOnce) {
  fine({"study", "new", path("a.tactus"), "--name", "Tube study"});
  const auto info = json({"study", "info", path("a.tactus")});
  EXPECT_EQ(info["name"], "Tube study");
  EXPECT_EQ(info["rows"]["person"], 0);
  EXPECT_NE(fine({"study", "info", path("a.tactus")}).out.find("Tube study"), std::string::npos);
  EXPECT_EQ(ProgramRun({"study", "new", path("a.tactus")}).status, 1);
  fine({"study", "new", path("b.tactus")});
  EXPECT_EQ(json({"study", "info", path("b.tactus")})["name"], "b");
}

TEST_F(StudyCommands, ImportOfTablesMakesTheStudyAndAddsNothingTwice) {
  const auto first = json({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(first["persons"], 2);
  EXPECT_EQ(first["records"], 4);  // a profile and an answer each
  const auto again = json({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(again["persons"], 0);
  EXPECT_EQ(again["records"], 0);
  EXPECT_EQ(rows("a.tactus")["answer"], 2);
  EXPECT_EQ(json({"study", "info", path("a.tactus")})["simulated_persons"], 2);
}

TEST_F(StudyCommands, AMistakeInTheTablesLeavesNoStudy) {
  writeText(path("tables/answers.csv"), "participant,form,item,term,status\nS9,f,1,small,answered\n");
  const ProgramRun run({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("answers.csv: line 2, column 'participant': found 'S9'"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(path("a.tactus")));
}

TEST_F(StudyCommands, CheckTellsFindingsFromDamage) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_TRUE(json({"study", "check", path("a.tactus")})["findings"].empty());
  EXPECT_NE(fine({"study", "check", path("a.tactus")}).out.find("findings 0"), std::string::npos);
  writeText(path("text.tactus"), "participant,years\n");
  EXPECT_EQ(ProgramRun({"study", "check", path("text.tactus")}).status, 1);
  std::string bytes = readText(path("a.tactus"));
  for (std::size_t at = 5000; at < bytes.size(); ++at) bytes[at] = '\x5A';
  writeText(path("damaged.tactus"), bytes);
  const ProgramRun damaged({"study", "check", path("damaged.tactus")});
  EXPECT_EQ(damaged.status, 1);
  EXPECT_NE(damaged.err.find("damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ(ProgramRun({"study", "check", path("none.tactus")}).status, 1);
}

TEST_F(StudyCommands, MergeAddsSeveralFilesOnce) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "new", path("b.tactus")});
  fine({"study", "new", path("c.tactus")});
  const auto merged = json({"study", "merge", path("c.tactus"), path("b.tactus"), path("a.tactus")});
  ASSERT_EQ(merged["merged"].size(), 2U);
  EXPECT_TRUE(merged["merged"][0]["added"].empty());
  EXPECT_EQ(merged["merged"][1]["added"]["person"], 2);
  EXPECT_TRUE(merged["merged"][1]["conflicts"].empty());
  EXPECT_NE(fine({"study", "merge", path("c.tactus"), path("a.tactus")}).out.find("nothing new"), std::string::npos);
  EXPECT_EQ(ProgramRun({"study", "merge", path("c.tactus"), path("c.tactus")}).status, 1);
}

TEST_F(StudyCommands, ExportAndImportGiveTheSameStudy) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(json({"study", "export", path("a.tactus"), path("out")})["participants"], 2);
  EXPECT_EQ(json({"study", "import", path("b.tactus"), path("out")})["added"]["answer"], 2);
  EXPECT_EQ(json({"study", "info", path("a.tactus")})["id"], json({"study", "info", path("b.tactus")})["id"]);
  EXPECT_EQ(rows("a.tactus"), rows("b.tactus"));
  EXPECT_TRUE(json({"study", "import", path("a.tactus"), path("out")})["added"].empty());
  fine({"study", "export", path("b.tactus"), path("out"), "--bom"});
  EXPECT_TRUE(readText(path("out/answers.csv")).starts_with("\xEF\xBB\xBF"));
  fine({"study", "import", path("c.tactus"), path("out")});
  EXPECT_EQ(rows("c.tactus"), rows("a.tactus"));
}

TEST_F(StudyCommands, ShareableLeavesOutCodesAndYears) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "export", path("a.tactus"), path("out"), "--shareable"});
  const std::string participants = readText(path("out/participants.csv"));
  EXPECT_EQ(participants.find("S1"), std::string::npos);
  EXPECT_EQ(participants.find("12.25"), std::string::npos);
  EXPECT_NE(participants.find("10-15"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("out/records")));
}

TEST_F(StudyCommands, WithdrawWantsAYesAndLastsThroughImports) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "export", path("a.tactus"), path("out")});
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S1"}).status, 2);
  EXPECT_EQ(rows("a.tactus")["person"], 2);
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S7", "--yes"}).status, 1);
  fine({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  fine({"study", "import", path("a.tactus"), path("out")});
  EXPECT_EQ(rows("a.tactus")["person"], 1);
  EXPECT_EQ(rows("a.tactus")["tombstone"], 1);
}

TEST_F(StudyCommands, WithdrawCanBeDoneAgainAndNamesCopies) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "export", path("a.tactus"), path("out")});
  const ProgramRun first({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.err.find(path("out") + ": an export in which the participant stands"), std::string::npos)
      << first.err;
  const ProgramRun again({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("; there is nothing left to remove"), std::string::npos) << again.out;
  const ProgramRun erased({"study", "erase", path("a.tactus")});
  EXPECT_EQ(erased.status, 0) << erased.err;
  EXPECT_NE(erased.out.find("no erasure was interrupted"), std::string::npos) << erased.out;
  const ProgramRun tables({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(tables.status, 1);
  EXPECT_NE(tables.err.find("found the code 'S1' of a participant who withdrew on "), std::string::npos) << tables.err;
}

TEST_F(StudyCommands, RecodeGivesAnotherCode) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "import", path("b.tactus"), path("tables")});
  const ProgramRun merged({"study", "merge", path("a.tactus"), path("b.tactus")});
  ASSERT_EQ(merged.status, 0) << merged.err;
  const auto at = merged.out.find("tactus study recode " + path("a.tactus") + " ");
  ASSERT_NE(at, std::string::npos) << merged.out;
  const std::string id =
      merged.out.substr(at + std::string("tactus study recode ").size() + path("a.tactus").size() + 1, 32);
  const ProgramRun build({"build", path("a.tactus"), "--out", path("m.json")});
  EXPECT_EQ(build.status, 1);
  EXPECT_NE(build.err.find("found 2 persons with the code 'S1' (ids "), std::string::npos) << build.err;
  EXPECT_NE(build.err.find("tactus study recode " + path("a.tactus") + " " + id + " S1-2"), std::string::npos)
      << build.err;
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S1", "--yes"}).status, 1);
  fine({"study", "recode", path("a.tactus"), id, "S1-2"});
  EXPECT_EQ(ProgramRun({"study", "recode", path("a.tactus"), "S1-2", "S1"}).status, 1);
  fine({"study", "withdraw", path("a.tactus"), "S1-2", "--yes"});
  EXPECT_EQ(rows("a.tactus")["tombstone"], 1);
}

TEST_F(StudyCommands, WrongUsage) {
  EXPECT_EQ(ProgramRun({"study"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "info"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "new", ""}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "merge", "a.tactus"}).status, 2);
}

}  // namespace
}  // namespace tactus::cli
