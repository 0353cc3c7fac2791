// `study export --layout` on the command line: what it is made of, what it says, what it refuses.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using LayoutJson = nlohmann::json;

class StudyLayoutTest : public testing::Test {
 protected:
  StudyLayoutTest() {
    std::filesystem::create_directory(tables_);
    writeText(tables_ + "/participants.csv", "participant,simulated\nnora-7,0\nodo-3,1\n");
    writeText(tables_ + "/judgements.csv",
              "participant,series,step,force_n,term\nnora-7,ascending,1,0.1,small\nodo-3,ascending,1,0.1,small\n");
    EXPECT_EQ(ProgramRun({"study", "import", study_, tables_}).status, 0);
  }

  support::TempFolder folder_;
  std::string tables_ = folder_.file("tables");
  std::string study_ = folder_.file("a.tactus");
  std::string out_ = folder_.file("out");
};

TEST_F(StudyLayoutTest, IsWrittenOfAStudyFileAndOfAFolderOfTables) {
  for (const std::string& study : {study_, tables_}) {
    for (const std::string layout : {"psych-ds", "bids"}) {
      const ProgramRun run({"study", "export", study, out_ + layout, "--layout", layout, "--json"});
      ASSERT_EQ(run.status, 0) << run.err;
      const LayoutJson said = LayoutJson::parse(run.out);
      EXPECT_EQ(said["layout"], layout);
      EXPECT_EQ(said["profile"], "shareable");
      EXPECT_EQ(said["participants"], 2);
      EXPECT_TRUE(std::filesystem::exists(out_ + layout + "/dataset_description.json"));
    }
  }
}

TEST_F(StudyLayoutTest, TheFolderMayBeNamedByOut) {
  const ProgramRun run({"study", "export", study_, "--layout", "bids", "--out", out_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(out_ + "/participants.tsv"));
}

TEST_F(StudyLayoutTest, APersonWhoWithdrewIsNotInIt) {
  ASSERT_EQ(ProgramRun({"study", "withdraw", study_, "nora-7", "--yes"}).status, 0);
  ASSERT_EQ(ProgramRun({"study", "export", study_, out_, "--layout", "bids"}).status, 0);
  const std::string participants = readText(out_ + "/participants.tsv");
  EXPECT_EQ(participants,
            "participant_id\thandedness\tcategory\tyears_experience_band\tsimulated\nsub-P1\tn/a\tn/a\tn/a\t1\n");
}

TEST_F(StudyLayoutTest, ThePsychDsFolderIsAStudyAgain) {
  ASSERT_EQ(ProgramRun({"study", "export", study_, out_, "--layout", "psych-ds"}).status, 0);
  const std::string again = folder_.file("again.tactus");
  const ProgramRun imported({"study", "import", again, out_, "--json"});
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_EQ(LayoutJson::parse(imported.out)["persons"], 2);
  EXPECT_EQ(ProgramRun({"study", "import", again, out_, "--json"}).status, 0);  // nothing is added twice
  ASSERT_EQ(ProgramRun({"study", "export", again, folder_.file("all")}).status, 0);
  const std::string participants = readText(folder_.file("all") + "/participants.csv");
  EXPECT_NE(participants.find("P1,,,,,"), std::string::npos) << participants;
  const std::string judgements = readText(folder_.file("all") + "/judgements.csv");
  EXPECT_NE(judgements.find("P1,ascending,1,0.1,small\n"), std::string::npos) << judgements;
  EXPECT_NE(judgements.find("P2,ascending,1,0.1,small\n"), std::string::npos) << judgements;
}

TEST_F(StudyLayoutTest, WrongRequestsAreRefused) {
  EXPECT_EQ(ProgramRun({"study", "export", study_, out_, "--layout", "bid"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "export", study_, out_, "--layout", "bids", "--bom"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "export", study_, "--layout", "bids"}).status, 2);
  const ProgramRun missing({"study", "export", folder_.file("none.tactus"), out_, "--layout", "bids"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("none.tactus"), std::string::npos);
  writeText(out_, "a file");
  EXPECT_EQ(ProgramRun({"study", "export", study_, out_, "--layout", "bids"}).status, 1);
}

}  // namespace
}  // namespace tactus::cli
