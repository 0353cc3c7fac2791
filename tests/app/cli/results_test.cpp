// What check, cluster and vote print.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/model_io/model_file.h"
#include "experiments/published_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

Json jsonOf(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const ProgramRun run(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return Json::parse(run.out);
}

TEST(Check, FindingsAreResultsAndNotFailures) {
  const support::TempFolder folder;
  const std::string file = folder.file("s4.tactus.json");
  ASSERT_TRUE(model_io::writeModel(support::s4AsPrinted(), file).has_value());
  const Json result = jsonOf({"check", file});
  EXPECT_EQ(result.at("valid"), true);
  EXPECT_EQ(result.at("findings").at(0).at("kind"), "hole");
  EXPECT_EQ(result.at("findings").at(0).at("expert"), nullptr);
  EXPECT_EQ(result.at("findings").at(1).at("expert"), "S4");
  EXPECT_EQ(result.at("findings").at(1).at("place"), "depth 125 to 138 mm");
  EXPECT_NEAR(result.at("reachable").at("min_n"), 0.126667, 1e-6);
  // .85 N beside the gap, see tests/core/analysis/boundary_jumps_test.cpp; the largest setting looked at may be less.
  EXPECT_GT(result.at("findings").at(1).at("newtons"), 0.7);
  EXPECT_LE(result.at("findings").at(1).at("newtons"), 0.85 + 1e-9);
  EXPECT_EQ(result.at("findings").at(1).at("to").size(), 4);
  EXPECT_EQ(result.at("newtons_complete"), true);
  EXPECT_LE(result.at("bounds").at("min_n"), result.at("reachable").at("min_n"));
  EXPECT_GE(result.at("bounds").at("max_n"), result.at("reachable").at("max_n"));
  for (const auto& finding : result.at("findings")) EXPECT_TRUE(finding.contains("newtons")) << finding;
  const ProgramRun text({"check", file});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("\n    S4: no rule fires: depth 125 to 138 mm (0."), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("proved bounds 0.127 to 0.924 N"), std::string::npos) << text.out;
}

TEST(Cluster, HasTheKeysOfItsContract) {
  const Json result = jsonOf({"cluster", TACTUS_GOLDEN_DIR "/fcm/S4_600.csv"});
  // Reference centres computed with 40 digits.
  const std::vector<double> centres = {9.504205448296123, 36.11239250449684, 52.011079026036754};
  for (std::size_t k = 0; k < centres.size(); ++k) EXPECT_NEAR(result.at("centres").at(k), centres[k], 7.7e-11);
  EXPECT_NEAR(result.at("objective").get<double>() / 16077.2207104035, 1, 1e-12);
  EXPECT_GT(result.at("iterations"), 0);
  EXPECT_EQ(result.at("stop_reason"), "converged");
  EXPECT_NEAR(result.at("validity").at("partition_coefficient"), 0.8024971756806459, 1e-9);
  EXPECT_EQ(result.at("warnings").size(), 1) << "the file has no header, which is said";
}

TEST(Cluster, AnObjectiveOutsideTheRangeOfDoubleComesAsALogarithm) {
  const support::TempFolder folder;
  const std::string file = folder.file("speeds.csv");
  writeText(file, "other,speed_mm_s\n0,1e160\n0,2e160\n0,4e160\n0,9e160\n");
  const Json result = jsonOf({"cluster", file, "-c", "2"});
  EXPECT_EQ(result.at("objective"), nullptr);
  EXPECT_GT(result.at("objective_log10"), 308);
  EXPECT_TRUE(result.at("warnings").empty());
}

TEST(Vote, Table2GivesItsElevenWinners) {
  const support::TempFolder folder;
  const std::string file = folder.file("table2.csv");
  writeText(file, std::string(experiments::table2Csv()));
  const Json result = jsonOf({"vote", file});
  const std::vector<std::string> winners = {"very_small", "very_small", "small",     "small",
                                            "medium",     "medium",     "large",     "very_large",
                                            "very_large", "very_large", "very_large"};
  ASSERT_EQ(result.at("steps").size(), winners.size());
  for (std::size_t i = 0; i < winners.size(); ++i) EXPECT_EQ(result.at("steps").at(i).at("term"), winners[i]);
  EXPECT_EQ(result.at("steps").at(2).at("reason"), "next_level");
  EXPECT_EQ(result.at("steps").at(8).at("reason"), "tie_higher");
  EXPECT_EQ(result.at("terms").at(3).at("id"), "large");
  EXPECT_EQ(result.at("terms").at(3).at("points"), Json({0.6, 0.7, 0.7, 0.8}));
  EXPECT_EQ(result.at("terms_from"), "vote");
  EXPECT_EQ(result.at("end_n"), 1.1);
}

}  // namespace
}  // namespace tactus::cli
