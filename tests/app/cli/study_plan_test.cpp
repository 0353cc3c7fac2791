// `study plan`: before a study and during one. Its numbers are those of app/planning.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/tables/csv.h"
#include "core/study/csv_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

TEST(StudyPlanCommand, BeforeAStudy) {
  const support::TempFolder folder;
  const std::string out = folder.file("plan.csv");
  const ProgramRun text({"study", "plan", "--region", "laryngopharynx", "--most-nurses", "4", "--questions", "15,45",
                         "--studies", "20", "--out", out, "--force-terms", "thresholds", "--precision", "0.001"});
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("Simulated nurses, not real ones"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("No design reaches"), std::string::npos) << text.out;
  const auto table = base::CsvTable::parse(readText(out), out);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rowCount(), 6U);  // 2, 3, 4 nurses by 15 and 45 questions

  const std::vector<std::string> easy = {"study",     "plan", "--most-nurses", "4", "--questions", "45",
                                         "--studies", "20",   "--precision",   "5", "--seed",      "7",
                                         "--json"};
  const ProgramRun first(easy);
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(first.out, ProgramRun(easy).out);
  const Json json = Json::parse(first.out);
  EXPECT_EQ(json.at("seed"), 7);
  EXPECT_TRUE(json.at("simulated").get<bool>());
  EXPECT_EQ(json.at("cheapest").at("nurses"), 2);
  EXPECT_EQ(json.at("designs").size(), 3U);
}

TEST(StudyPlanCommand, DuringAStudy) {
  const support::TempFolder folder;
  const std::string tables = folder.file("tables");
  const auto study = support::tableStudy(1, {.nurses = 3, .rows_per_s = 60});
  ASSERT_TRUE(study::writeStudyFolder(study, support::ngtInputIds(), tables));
  const ProgramRun run({"study", "plan", tables, "--most-nurses", "4", "--studies", "20", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_FALSE(json.at("notes").empty());
  ASSERT_FALSE(json.at("gains").empty());
  EXPECT_EQ(json.at("gains")[0].at("nurses"), 5);
  EXPECT_GE(json.at("gains")[0].at("buys_n").get<double>(), 0);
}

TEST(StudyPlanCommand, OfAnotherProcedure) {
  const ProgramRun run(
      {"study", "plan", "--pack", "nasopharyngeal-swab", "--studies", "10", "--most-nurses", "3", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("designs").size(), 6U);  // 2 and 3 nurses by a third, two thirds and all of 18 questions
  EXPECT_EQ(json.at("designs")[0].at("questions"), 6);
  EXPECT_NE(json.at("notes").at(0).get<std::string>().find("invented"), std::string::npos);
}

TEST(StudyPlanCommand, AMistakeIsSaid) {
  const ProgramRun region({"study", "plan", "--region", "elbow", "--studies", "2"});
  EXPECT_EQ(region.status, 1);
  EXPECT_NE(region.err.find("laryngopharynx"), std::string::npos) << region.err;
  EXPECT_EQ(ProgramRun({"study", "plan", "--questions", "46", "--studies", "2"}).status, 1);
  EXPECT_EQ(ProgramRun({"study", "plan", "--precision", "0"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "plan", "absent.tactus"}).status, 1);
  EXPECT_EQ(ProgramRun({"study", "plan", "--pack", "absent"}).status, 1);
  EXPECT_EQ(ProgramRun({"study", "plan", "absent.tactus", "--pack", "nasopharyngeal-swab"}).status, 2);
}

}  // namespace
}  // namespace tactus::cli
