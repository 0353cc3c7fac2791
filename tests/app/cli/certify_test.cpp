// `certify` on the command line.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

class CertifyCommand : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(model_io::writeModel(support::s4FiveRegions(), model_)); }

  /// The simulator of the tests, wrong in the way `how` at question `at`.
  ProgramRun certified(const std::string& model, std::vector<std::string> options, const std::string& how = "",
                       const std::string& at = "1") const {
    options.insert(options.begin(), {"certify", TACTUS_SIMULATOR, "--model", model, "--points", "50"});
    options.insert(options.end(), {"--", model_, how, at});
    return ProgramRun(options);
  }

  support::TempFolder folder_;
  const std::string model_ = folder_.file("m.tactus.json");
};

TEST_F(CertifyCommand, ARightProgramIsExitZeroWithItsPage) {
  const std::string page = folder_.file("page.html");
  const ProgramRun run = certified(model_, {"--out", page, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json said = Json::parse(run.out);
  EXPECT_EQ(said["certified"], true);
  EXPECT_EQ(said["model_sha256"], base::sha256(readText(model_)));
  EXPECT_EQ(said["program"], "the simulator of the tests");
  EXPECT_EQ(said["points"]["right"], 50);
  EXPECT_EQ(said["points"]["largest_error_n"], 0);
  EXPECT_GT(said["steps"]["right"], 3000);
  EXPECT_EQ(said["steps"]["right"], said["steps"]["asked"]);
  EXPECT_GT(said["steps"]["latency_us"]["p99_9"], 0);
  EXPECT_TRUE(said["wrong"].is_null());
  EXPECT_NE(readText(page).find("Within 1e-09 N of "), std::string::npos);
}

TEST_F(CertifyCommand, AWrongAnswerIsExitOneWithItsPoint) {
  const std::string page = folder_.file("page.html");
  const ProgramRun run = certified(model_, {"--out", page}, "off", "7");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(run.err.starts_with("tactus: point 7 (lubrication ")) << run.err;
  EXPECT_NE(run.out.find("49 of 50 right, 1 wrong"), std::string::npos) << run.out;
  EXPECT_NE(readText(page).find("Not certified"), std::string::npos);
  EXPECT_EQ(certified(model_, {"--tolerance", "1e-5"}, "off", "7").status, 0);
  const ProgramRun hangs = certified(model_, {"--timeout", "0.2"}, "hang", "3");
  EXPECT_EQ(hangs.status, 1);
  EXPECT_NE(hangs.err.find("found no answer within 0.2 s"), std::string::npos) << hangs.err;
}

TEST_F(CertifyCommand, ABundleIsAskedWithItsOwnChecks) {
  const std::string bundle = folder_.file("bundle");
  ASSERT_EQ(ProgramRun({"bundle", model_, "--out", bundle, "--table-error", "0.2"}).status, 0);
  for (const std::string& named : {bundle, bundle + "/manifest.json"}) {
    const ProgramRun run = certified(named, {"--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(Json::parse(run.out)["model_sha256"], base::sha256(readText(bundle + "/model.tactus.json")));
  }
  const std::string zip = folder_.file("bundle.zip");
  ASSERT_EQ(ProgramRun({"bundle", model_, "--out", zip, "--table-error", "0.2"}).status, 0);
  const ProgramRun packed = certified(zip, {"--json"});
  ASSERT_EQ(packed.status, 0) << packed.err;
  EXPECT_EQ(Json::parse(packed.out)["points"]["right"], 50);
  writeText(folder_.file("no.zip"), "no zip file");
  EXPECT_NE(certified(folder_.file("no.zip"), {}).err.find("wanted a zip file"), std::string::npos);
  writeText(bundle + "/checks.csv", readText(bundle + "/checks.csv") + "\n");
  const ProgramRun damaged = certified(bundle, {});
  EXPECT_EQ(damaged.status, 1);
  EXPECT_NE(damaged.err.find("wanted an undamaged one"), std::string::npos) << damaged.err;
}

TEST_F(CertifyCommand, WrongUsageIsExitTwo) {
  EXPECT_EQ(ProgramRun({"certify", "tcp:nowhere", "--model", model_}).status, 2);
  EXPECT_EQ(ProgramRun({"certify", TACTUS_SIMULATOR}).status, 2);
  EXPECT_EQ(ProgramRun({"certify", TACTUS_SIMULATOR, "--model", model_, "--points", "0"}).status, 2);
  EXPECT_EQ(ProgramRun({"certify", TACTUS_SIMULATOR, "--model", model_, "--timeout", "0"}).status, 2);
  EXPECT_EQ(ProgramRun({"certify", folder_.file("none"), "--model", model_}).status, 1);
  const ProgramRun over_the_model({"certify", TACTUS_SIMULATOR, "--model", model_, "--out", model_});
  EXPECT_EQ(over_the_model.status, 1);
  EXPECT_NE(over_the_model.err.find("a file that the command reads"), std::string::npos) << over_the_model.err;
}

}  // namespace
}  // namespace tactus::cli
