// The main job, end to end.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/session/export_folder.h"
#include "core/base/files/unfinished.h"
#include "core/base/tables/csv.h"
#include "core/model_io/model_file.h"
#include "core/store/copies.h"
#include "core/store/study_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class Demo : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new support::TempFolder;
    run_ = new ProgramRun({"demo", folder_->file("demo"), "--json"});
  }
  static void TearDownTestSuite() {
    delete run_;
    delete folder_;
  }

  static std::string path(const std::string& name) { return folder_->file("demo") + '/' + name; }

  static support::TempFolder* folder_;
  static ProgramRun* run_;
};

support::TempFolder* Demo::folder_ = nullptr;
ProgramRun* Demo::run_ = nullptr;

TEST_F(Demo, DoesNotReplaceAStudyThatIsOpen) {
  const support::TempFolder folder;
  const std::string study = folder.file("demo/study/ngt-demo.tactus");
  std::filesystem::create_directories(folder.file("demo/study"));
  std::filesystem::copy_file(path("written-by-tactus-demo.txt"), folder.file("demo/written-by-tactus-demo.txt"));
  std::filesystem::copy_file(path("study/ngt-demo.tactus"), study);
  const auto open = store::StudyFile::open(study);
  ASSERT_TRUE(open) << open.error().message();
  const ProgramRun run({"demo", folder.file("demo")});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("ngt-demo.tactus: found a study that is open elsewhere"), std::string::npos) << run.err;
  EXPECT_TRUE(session::leftoversOfStudy(study).empty());
}

TEST_F(Demo, WhatAnInterruptedDemoLeftIsDeletedByTheNext) {
  const support::TempFolder folder;
  const std::string study = folder.file("demo/study/ngt-demo.tactus");
  std::filesystem::create_directories(folder.file("demo/study"));
  std::filesystem::copy_file(path("written-by-tactus-demo.txt"), folder.file("demo/written-by-tactus-demo.txt"));
  {
    const auto left = base::makeUnfinishedFolder(study, store::kImportEnding);
    ASSERT_TRUE(left.descriptor.isOpen());
    std::ofstream(left.path + "/ngt-demo.tactus") << "half a study";
  }
  ASSERT_EQ(session::leftoversOfStudy(study).size(), 1U);
  ASSERT_EQ(ProgramRun({"demo", folder.file("demo")}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(study));
  EXPECT_TRUE(session::leftoversOfStudy(study).empty());
}

TEST_F(Demo, WritesTheFilesItNames) {
  ASSERT_EQ(run_->status, 0) << run_->err;
  const auto result = nlohmann::json::parse(run_->out);
  EXPECT_EQ(result.at("simulated"), true);
  for (const auto& file : result.at("files")) EXPECT_TRUE(std::filesystem::exists(path(file.at("path")))) << file;
  for (const char* table : {"participants", "speeds", "judgements", "answers", "rules"}) {
    EXPECT_TRUE(std::filesystem::exists(path("study/") + table + ".csv")) << table;
  }
}

TEST_F(Demo, TheAveragedModelHasFourExpertsAndNoHole) {
  const auto read = model_io::readModel(path("models/averaged.tactus.json"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  ASSERT_EQ(read->model.experts.size(), 4);
  EXPECT_GE(read->model.checks.size(), 24);
  for (const auto& expert : read->model.experts) EXPECT_EQ(expert.rules.size(), 45) << expert.id;
  const ProgramRun check({"check", path("models/averaged.tactus.json")});
  EXPECT_EQ(check.out.find("hole"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("disagreement: 1\n    S4: "), std::string::npos)
      << "S4 contradicts the others on neck flexion";
}

TEST_F(Demo, WhatIsSimulatedSaysSo) {
  const auto people = base::CsvTable::read(path("study/participants.csv"));
  ASSERT_TRUE(people.has_value());
  for (std::size_t row = 0; row < people->rowCount(); ++row)
    EXPECT_EQ(people->cell(row, *people->find("simulated")), "1");
  EXPECT_NE(readText(path("models/averaged.tactus.json")).find("imulated"), std::string::npos);
  EXPECT_NE(readText(path("report.html")).find("simulated"), std::string::npos);
  EXPECT_NE(readText(path("export/README.txt")).find("simulated"), std::string::npos);
}

TEST_F(Demo, ProvenanceSaysWhatIsSimulatedAndHow) {
  const auto model = nlohmann::json::parse(readText(path("models/averaged.tactus.json")));
  const auto& provenance = model.at("provenance");
  EXPECT_EQ(provenance.at("notes"),
            "Simulated, not measured: strokes and judgements of S1, S2, S3, S4; answers of S1, S2, S3. Rules given "
            "directly: S4.");
  const auto& settings = provenance.at("settings");
  EXPECT_EQ(settings.at("simulation_seed"), 2);
  EXPECT_EQ(settings.at("forms").at("S1"), "ngt-force-v1");
  EXPECT_EQ(settings.at("forms").at("S4"), "ngt-a2-five-regions");
  EXPECT_EQ(settings.at("depth_terms").at("S4"), "form_a2");
}

TEST_F(Demo, BuildFromItsTablesAndFromItsStudyFileGivesTheSameForces) {
  const std::string points = path("export/checks.csv");
  const std::string forces = ProgramRun({"eval", path("models/averaged.tactus.json"), "--in", points}).out;
  for (const char* study : {"study", "study/ngt-demo.tactus"}) {
    const std::string rebuilt = path("rebuilt.tactus.json");
    const ProgramRun build({"build", path(study), "--out", rebuilt});
    ASSERT_EQ(build.status, 0) << build.err;
    EXPECT_EQ(ProgramRun({"eval", rebuilt, "--in", points}).out, forces) << study;
  }
}

TEST_F(Demo, TheExportedChecksAreWhatEvalGives) {
  const ProgramRun eval({"eval", path("export/model.tactus.json"), "--in", path("export/checks.csv")});
  const auto table = base::CsvTable::parse(eval.out, "out");
  ASSERT_TRUE(table.has_value()) << eval.err;
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    EXPECT_EQ(table->cell(row, *table->find("force")), table->cell(row, *table->find("expected_force")));
    EXPECT_EQ(table->cell(row, *table->find("fired")), table->cell(row, *table->find("expected_fired")));
  }
}

TEST_F(Demo, TheSameSeedGivesTheSameStudy) {
  const ProgramRun again({"demo", folder_->file("again")});
  ASSERT_EQ(again.status, 0);
  for (const char* table : {"speeds.csv", "judgements.csv", "answers.csv", "rules.csv"}) {
    EXPECT_EQ(readText(folder_->file("again") + "/study/" + table), readText(path("study/") + table)) << table;
  }
}

TEST_F(Demo, NeverWritesOverAnybodysWork) {
  const std::string work = folder_->file("work");
  std::filesystem::create_directory(work);
  writeText(work + "/report.html", "mine");
  const ProgramRun refused({"demo", work});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("a folder that holds other files"), std::string::npos) << refused.err;
  EXPECT_EQ(readText(work + "/report.html"), "mine");
  EXPECT_EQ(ProgramRun({"demo", folder_->file("demo")}).status, 0) << "its own folder it may write again";
}

TEST_F(Demo, TheReadingOfTableA2IsAChoice) {
  const ProgramRun printed({"demo", folder_->file("printed"), "--reading", "ngt-a2-printed"});
  ASSERT_EQ(printed.status, 0) << printed.err;
  const ProgramRun check({"check", folder_->file("printed") + "/models/averaged.tactus.json"});
  EXPECT_NE(unwrapped(check.out).find("hole: 1 S4: no rule fires: depth 125 to 138 mm"), std::string::npos)
      << check.out;
  const ProgramRun unknown({"demo", folder_->file("unknown"), "--reading", "guess"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_->file("unknown")));
}

}  // namespace
}  // namespace tactus::cli
