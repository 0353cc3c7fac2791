// `tactus build` on a study file.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

#include "app/session/study_import.h"
#include "core/model_io/model_file.h"
#include "core/store/study_records.h"
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

TEST_F(BuildStudyFile, TakesTheMeasuredDepthsOnRequest) {
  make("A,,,stomach,slow,small,,\nB,well,,stomach,fast,large,,\n");
  const ProgramRun without({"build", file_, "--out", out_, "--depths", "measured"});
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.err.find("found no measurement of depths in the study"), std::string::npos) << without.err;
  {
    auto file = store::StudyFile::open(file_, {});
    ASSERT_TRUE(file);
    study::DepthRecord record;
    record.id = study::RecordIds(2).next();
    record.utc_ms = 1;
    record.text = R"({"image": "scan.png", "mm_per_px": 0.5, "boundaries": [{"depth_mm": 70, "half_overlap_mm": 10},
                     {"depth_mm": 115, "half_overlap_mm": 10}, {"depth_mm": 150, "half_overlap_mm": 12},
                     {"depth_mm": 200, "half_overlap_mm": 15}, {"depth_mm": 400, "half_overlap_mm": 30}]})";
    ASSERT_TRUE(store::append(*file, record));
    ASSERT_TRUE(file->close());
  }
  ASSERT_EQ(ProgramRun({"build", file_, "--out", out_}).status, 0);
  const auto before = model_io::readModel(out_);
  ASSERT_TRUE(before);
  EXPECT_EQ(before->model.inputs[2].terms.back().points, (std::vector<double>{420, 460, 600, 600}));
  const ProgramRun run({"build", file_, "--out", out_, "--depths", "measured"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(unwrapped(run.out).find("measured on the image 'scan.png' (0.5 mm per pixel)"), std::string::npos)
      << run.out;
  const auto after = model_io::readModel(out_);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->model.inputs[2].terms.back().points, (std::vector<double>{370, 430, 600, 600}));
  const auto& settings = after->model.provenance->settings;
  EXPECT_TRUE(std::any_of(settings.begin(), settings.end(), [](const auto& one) { return one.key == "depths"; }));
}

}  // namespace
}  // namespace tactus::cli
