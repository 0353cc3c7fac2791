// `tactus build` on a study file.
#include <filesystem>
#include <gtest/gtest.h>

#include "app/session/study_import.h"
#include "core/model_io/model_file.h"
#include "core/study/csv_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

const std::string kRules = "participant,lubrication,neck_flexion,depth,speed,then,weight,form\n";

class BuildStudyFile : public testing::Test {
 protected:
  /// Writes the two tables and puts them into a study file.
  void make(const std::string& rules) {
    std::filesystem::create_directory(tables_);
    writeText(tables_ + "/participants.csv",
              "participant,years_experience,category,handedness,weight,simulated\nA,,,,,\nB,,,,,\n");
    writeText(tables_ + "/rules.csv", kRules + rules);
    const auto study = study::readStudyFolder(tables_);
    ASSERT_TRUE(study) << study.error().message();
    auto file = store::StudyFile::create(file_, {study::RecordIds(1).next(), "two nurses", 1, "test"});
    ASSERT_TRUE(file) << file.error().message();
    ASSERT_TRUE(session::importTables(study->study, *file));
    ASSERT_TRUE(file->close());
  }

  support::TempFolder folder_;
  std::string tables_ = folder_.file("tables");
  std::string file_ = folder_.file("study.tactus");
  std::string out_ = folder_.file("m.tactus.json");
};

TEST_F(BuildStudyFile, GivesTheModelThatItsTablesGive) {
  make("A,,,stomach,slow,small,,\nB,well,,stomach,fast,large,,\n");
  const std::string from_tables = folder_.file("tables.tactus.json");
  const ProgramRun file({"build", file_, "--out", out_});
  ASSERT_EQ(file.status, 0) << file.err;
  ASSERT_EQ(ProgramRun({"build", tables_, "--out", from_tables}).status, 0);
  const auto a = model_io::readModel(out_);
  const auto b = model_io::readModel(from_tables);
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->model.experts.size(), 2U);
  EXPECT_EQ(a->model.experts, b->model.experts);
  EXPECT_EQ(a->model.output, b->model.output);
  EXPECT_EQ(a->model.name, "two nurses");  // the folder can only give its own name
}

TEST_F(BuildStudyFile, MistakesNameTheFile) {
  make("A,,,stomach,slow,smal,,\n");
  const ProgramRun run({"build", file_, "--out", out_});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err.substr(0, run.err.find(": ") + 2), "tactus: ") << run.err;
  EXPECT_NE(run.err.find(file_), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("found force 'smal'"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(BuildStudyFile, AFileThatIsNoStudyIsRefused) {
  writeText(file_, "participant,then\n");
  const ProgramRun run({"build", file_, "--out", out_});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find(file_), std::string::npos) << run.err;
  EXPECT_EQ(readText(file_), "participant,then\n");
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(BuildStudyFile, TheHelpTellsOfIt) {
  const ProgramRun run({"build", "--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find("Study file, or folder with the CSV tables"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace tactus::cli
