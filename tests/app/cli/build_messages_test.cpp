// What `tactus build` says of the tables of a study: errors with file and line, notes, provenance.
#include <filesystem>
#include <gtest/gtest.h>

#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class BuildMessages : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(study_);
    write("participants", "participant,years_experience,category,handedness,weight,simulated\nA,,,,,\nB,,,,,\n");
    write("rules", kRules + "A,,,stomach,slow,small,,\n");
  }

  void write(const std::string& table, const std::string& text) const {
    writeText(study_ + '/' + table + ".csv", text);
  }
  ProgramRun build(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"build", study_, "--out", out_});
    return ProgramRun(more);
  }
  /// The whole line on standard error, with the study's folder written as `st`.
  std::string refusal() const {
    const ProgramRun run = build();
    EXPECT_EQ(run.status, 1);
    EXPECT_FALSE(std::filesystem::exists(out_));
    const auto at = run.err.find(study_);
    return at == std::string::npos ? run.err : "st" + run.err.substr(at + study_.size());
  }
  void expectNote(const std::string& note) const {
    const ProgramRun run = build();
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(unwrapped(run.out).find("note: " + note), std::string::npos) << run.out;
  }

  const std::string kRules = "participant,lubrication,neck_flexion,depth,speed,then,weight,form\n";
  const std::string kSpeeds = "participant,level,stroke,time_s,depth_mm,speed_mm_s\n";
  const std::string kJudgements = "participant,series,step,force_n,term\n";
  support::TempFolder folder_;
  std::string study_ = folder_.file("study");
  std::string out_ = folder_.file("m.tactus.json");
};

TEST_F(BuildMessages, AnOptionOutOfRangeIsNamedAsTheOption) {
  const ProgramRun run = build({"--alpha", "2"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("--alpha: found '2', wanted a number above 0.5 and at most 1\n"), std::string::npos)
      << run.err;
}

TEST_F(BuildMessages, AFolderGivenAsADotGivesTheModelItsName) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(study_);
  const ProgramRun run({"build", ".", "--out", out_});
  std::filesystem::current_path(before);
  ASSERT_EQ(run.status, 0) << run.err;
  const auto model = model_io::readModel(out_);
  ASSERT_TRUE(model.has_value());
  EXPECT_EQ(model->model.name, "study");
}

TEST_F(BuildMessages, AModelThatIsReadAndWrittenAgainKeepsItsBytes) {
  ASSERT_EQ(build().status, 0);
  const auto model = model_io::readModel(out_);
  ASSERT_TRUE(model.has_value());
  EXPECT_EQ(model_io::formatModel(model->model), readText(out_));
}

TEST_F(BuildMessages, MistakesOfATableNameFileLineAndColumn) {
  write("rules", kRules + "A,wel,,,,small,,\n");
  EXPECT_EQ(refusal(), "st/rules.csv: line 2, column 'lubrication': found 'wel', wanted one of poor, medium, well\n");
  write("rules", kRules + "\nA,,,stomach,,small,,guess\n");
  EXPECT_EQ(refusal(),
            "st/rules.csv: line 3, column 'form': found 'guess', wanted one of ngt-force-v1, ngt-a2-printed, "
            "ngt-a2-shifted, ngt-a2-five-regions\n");
  write("rules", kRules + "A,,,stomach,,small,,\n");
  write("judgements", kJudgements + "A,ascending,1,0.1,smal\n");
  EXPECT_EQ(refusal(),
            "st/judgements.csv: line 2, column 'term': found 'smal', wanted one of very_small, small, medium, large, "
            "very_large (small?)\n");
  write("judgements", kJudgements + "A,ascending,0,0.1,small\n");
  EXPECT_EQ(refusal(), "st/judgements.csv: line 2, column 'step': found '0', wanted an integer from 1\n");
  write("judgements", kJudgements + "A,ascending,1,-0.1,small\n");
  EXPECT_EQ(refusal(), "st/judgements.csv: line 2, column 'force_n': found '-0.1', wanted a force of 0 N or more\n");
  write("judgements", kJudgements);
  write("speeds", kSpeeds + "A,zzz,1,0,0,1\n");
  EXPECT_EQ(refusal(), "st/speeds.csv: line 2, column 'level': found 'zzz', wanted one of slow, medium, fast\n");
  write("speeds", kSpeeds);
  write("answers", "participant,form,item,term,status\nB,ngt-force-v1,46,small,answered\n");
  EXPECT_EQ(
      refusal(),
      "st/answers.csv: line 2, column 'item': found item 46, which form ngt-force-v1 does not have, wanted one of "
      "its 45 items\n");
}

TEST_F(BuildMessages, TheTableOfWeightsIsNamed) {
  const std::string weights = folder_.file("w.csv");
  writeText(weights, "participant,weight\nB,1\n");
  EXPECT_EQ(build({"--weights", weights}).err,
            "tactus: " + weights +
                ": participant A: found no row in the table of weights, wanted one row per expert (there are: B)\n");
  writeText(weights, "participant,weight\nA,1\nZ,1\n");
  const ProgramRun run = build({"--weights", weights});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find(weights + " has a weight for 'Z', who is not in the study."), std::string::npos) << run.out;
}

TEST_F(BuildMessages, AbsentTablesAreOneSentence) {
  EXPECT_EQ(build().err,
            "tactus: warning: Absent tables, which count as empty: speeds.csv, judgements.csv, answers.csv.\n");
}

TEST_F(BuildMessages, OddDataAreNoted) {
  write("judgements",
        kJudgements + "A,ascending,1,0.15,small\nB,ascending,1,0.1,very_small\nB,ascending,2,1.1,large\n");
  expectNote(
      "Participant A judged other forces than most participants in series 'ascending': step 1 (judgements.csv, line 2) "
      "is at 0.15 N, for most at 0.1 N.");
  write("judgements", kJudgements);
  write("rules", kRules + "A,,,stomach,slow,small,,\nA,,,stomach,slow,large,,\n");
  expectNote(
      "Participant A contradicts themselves: rule 1 (line 2) says 'small', rule 2 (line 3) says 'large' of the same "
      "conditions.");
  std::string speeds = kSpeeds + "A,slow,1,0,0,-1\n";
  for (int i = 0; i < 20; ++i) speeds += "A,slow,1,0,0,10\nA,medium,1,0,0,100\nA,fast,1,0,0,200\n";
  write("speeds", speeds);
  expectNote("1 of 61 speed samples lie below 0 mm/s; they are clustered as they are.");
}

}  // namespace
}  // namespace tactus::cli
