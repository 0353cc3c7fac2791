// Contracts on the command line: `check`, `check --contract`, and `verify` of a bundle.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/contracts/contract_check.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

constexpr const char* kHeld = "the force is never above 1 N";
constexpr const char* kBroken = "more lubrication never raises the force";

class ContractsTest : public testing::Test {
 protected:
  std::string modelWith(std::initializer_list<const char*> sentences) {
    auto model = support::s4FiveRegions();
    for (const char* const sentence : sentences) {
      auto contract = contracts::parseContract(model, sentence);
      EXPECT_TRUE(contract.has_value());
      contract->id = "c" + std::to_string(model.contracts.size());
      model.contracts.push_back(*contract);
    }
    EXPECT_TRUE(model_io::writeModel(model, path_));
    return path_;
  }

  support::TempFolder folder_;
  std::string path_ = folder_.file("s4.tactus.json");
};

TEST_F(ContractsTest, CheckSaysEachVerdictAndFails) {
  const ProgramRun run({"check", modelWith({kHeld, kBroken})});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.out.find("contracts: proved 1, violated 1, open 0\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  proved    " + std::string(kHeld)), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  violated  " + std::string(kBroken)), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("by 0.0673 N, the largest case found"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("found a violation of '" + std::string(kBroken) + "'"), std::string::npos) << run.err;
}

TEST_F(ContractsTest, OneOnTheCommandLine) {
  const std::string model = modelWith({});
  const ProgramRun held({"check", model, "--contract", kHeld, "--json"});
  ASSERT_EQ(held.status, 0) << held.err;
  const Json json = Json::parse(held.out);
  EXPECT_EQ(json["contracts"].size(), 1U);
  EXPECT_EQ(json["contracts"][0]["verdict"], "proved");
  EXPECT_TRUE(json["contracts"][0]["id"].is_null());
  const ProgramRun broken({"check", model, "--contract", kBroken, "--json"});
  EXPECT_EQ(broken.status, 1);
  const Json violated = Json::parse(broken.out)["contracts"][0];
  EXPECT_EQ(violated["counterexample"].size(), 2U);
  EXPECT_GT(violated["excess_n"].get<double>(), 0.067);
  const ProgramRun wrong({"check", model, "--contract", "more grease never raises the force"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("--contract: character 6: found 'grease never raises the force', wanted an input"),
            std::string::npos)
      << wrong.err;
}

TEST_F(ContractsTest, AModelWithoutContractsPrintsNone) {
  const ProgramRun run({"check", modelWith({})});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.find("contracts"), std::string::npos);
}

TEST_F(ContractsTest, VerifyChecksThoseOfTheBundle) {
  const std::string bundle = folder_.file("bundle");
  ASSERT_EQ(ProgramRun({"bundle", modelWith({kHeld}), "--out", bundle, "--table-error", "0.2"}).status, 0);
  const ProgramRun held({"verify", bundle});
  EXPECT_EQ(held.status, 0) << held.err;
  EXPECT_NE(held.out.find("  proved    " + std::string(kHeld)), std::string::npos) << held.out;
  const std::string other = folder_.file("other");
  ASSERT_EQ(ProgramRun({"bundle", modelWith({kBroken}), "--out", other, "--table-error", "0.2"}).status, 0);
  const ProgramRun broken({"verify", other, "--json"});
  EXPECT_EQ(broken.status, 1);
  EXPECT_EQ(Json::parse(broken.out)["ok"], false);
  EXPECT_NE(broken.err.find("found a violation of"), std::string::npos) << broken.err;
}

}  // namespace
}  // namespace tactus::cli
