// `tactus bench`: what it says; the times themselves are of the machine.
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class BenchCommand : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(model_io::writeModel(support::s4FiveRegions(), model_)); }

  support::TempFolder folder_;
  std::string model_ = folder_.file("m.tactus.json");
};

TEST_F(BenchCommand, ErrorsFallWithTheResolutionAndTheLibraryHasNone) {
  const ProgramRun run({"bench", model_, "--seconds", "0.001", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  std::map<std::string, double> largest;
  for (const auto& row : json.at("rows")) {
    EXPECT_GT(row.at("ns"), 0) << row;
    EXPECT_GE(row.at("largest_error_n"), row.at("rms_error_n")) << row;
    EXPECT_GT(row.at("points"), 0) << row;
    largest[row.at("method")] = row.at("largest_error_n");
  }
  ASSERT_EQ(largest.size(), 10U);
  // Entry points agree to 4 ulp of about 1 N.
  for (const char* ours : {"exact, one point", "exact, a batch", "scene, one point", "scene, a batch"}) {
    EXPECT_LT(largest.at(ours), 1e-14) << ours;
  }
  EXPECT_GT(largest.at("midpoint:100"), largest.at("midpoint:10000"));
  EXPECT_GT(largest.at("linspace:101"), largest.at("linspace:10001"));
  EXPECT_LT(largest.at("midpoint:10000"), 1e-3);
}

TEST_F(BenchCommand, SaysItInATableAndRefusesWhatItCannotRead) {
  const ProgramRun run({"bench", model_, "--seconds", "0.001"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("midpoint:100 "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("largest error"), std::string::npos);
  EXPECT_EQ(ProgramRun({"bench", folder_.file("absent.json")}).status, 1);
  EXPECT_EQ(ProgramRun({"bench", model_, "--seconds", "0"}).status, 2);
}

}  // namespace
}  // namespace tactus::cli
