// `why` on the command line: its numbers are those of core/analysis, here its words, its JSON and its refusals.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

constexpr const char* kPoint = "lubrication=1,neck_flexion=60,depth=200,speed=50";

class WhyTest : public testing::Test {
 protected:
  WhyTest() {
    EXPECT_TRUE(model_io::writeModel(support::s4FiveRegions(), s4_));
    EXPECT_TRUE(model_io::writeModel(support::inventedExperts(), four_));
  }

  void expectRefused(const std::string& at, const std::string& says) const {
    const ProgramRun run({"why", s4_, "--at", at});
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
  }

  support::TempFolder folder_;
  std::string s4_ = folder_.file("s4.tactus.json");
  std::string four_ = folder_.file("four.tactus.json");
};

// As in tests/core/analysis: numbers of another program.
TEST_F(WhyTest, OneExpert) {
  const ProgramRun run({"why", s4_, "--at", kPoint, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json why = Json::parse(run.out);
  EXPECT_NEAR(why["force_n"].get<double>(), .589444, 5e-7);
  ASSERT_EQ(why["words"].size(), 4U);
  EXPECT_EQ(why["words"][0]["term"], "small");
  EXPECT_NEAR(why["words"][0]["pull_n"].get<double>(), -.086540, 5e-7);
  EXPECT_EQ(why["rules"][0]["expert"], "S4");
  EXPECT_EQ(why["rules"][0]["rule"], 29) << "the number in Table A2";
  EXPECT_TRUE(why["experts"][0]["leave_one_out_n"].is_null());
  const std::string sentence = why["sentence"];
  EXPECT_TRUE(sentence.starts_with(
      "0.589 N because small (-0.087 N: Tube lubrication well, Depth laryngopharynx) and medium (-0.010 N) hold it "
      "down "
      "and very_large (+0.086 N: Neck flexion large, Depth esophagus) and large (+0.010 N) pull it up. It would be "))
      << sentence;
  bool felt = false;
  for (const Json& one : why["counterfactuals"]) {
    if (one["input"] != "neck_flexion" || one["what"] != "one just-noticeable difference") continue;
    felt = true;
    EXPECT_NEAR(one["value"].get<double>(), 56.6623, 5e-5);
    EXPECT_NEAR(one["delta"].get<double>(), -3.3377, 5e-5);
  }
  EXPECT_TRUE(felt);
}

TEST_F(WhyTest, TheMeanAndOneOfItsExperts) {
  const Json mean = Json::parse(ProgramRun({"why", four_, "--at", kPoint, "--json"}).out);
  EXPECT_NEAR(mean["force_n"].get<double>(), .534861, 5e-7);
  ASSERT_EQ(mean["experts"].size(), 4U);
  EXPECT_EQ(mean["experts"][3]["id"], "S4");
  EXPECT_NEAR(mean["experts"][3]["leave_one_out_n"].get<double>(), .018194, 5e-7);
  const Json alone = Json::parse(ProgramRun({"why", four_, "--at", kPoint, "--expert", "S4", "--json"}).out);
  EXPECT_NEAR(alone["force_n"].get<double>(), .589444, 5e-7);
  ASSERT_EQ(alone["words"].size(), 4U);
  EXPECT_NEAR(alone["words"][3]["pull_n"].get<double>(), .086185, 5e-7);
  const ProgramRun text({"why", four_, "--at", kPoint});
  EXPECT_NE(text.out.find("the mean without this expert"), std::string::npos) << text.out;
}

TEST_F(WhyTest, AHoleSaysSo) {
  auto model = support::s4FiveRegions();
  model.experts[0].rules = {{{{"speed", "fast"}}, "large"}};
  ASSERT_TRUE(model_io::writeModel(model, s4_));
  const ProgramRun run({"why", s4_, "--at", "lubrication=1,neck_flexion=60,depth=200,speed=20"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "No rule fires here: 0.000 N is the default force of the model.\n");
}

TEST_F(WhyTest, WrongPointsAreRefused) {
  expectRefused("lubrication=1,neck_flexion=60", "--at: found no value for depth, speed, wanted INPUT=VALUE for each");
  expectRefused("lubrication=1,neck_flexion=60,depth=13,5,speed=50",
                "--at: found '5' after a comma, wanted INPUT=VALUE; a comma separates entries and the decimal sign is "
                "a point, as in "
                "depth=0.5");
  expectRefused("5,lubrication=1", "--at: found '5', wanted INPUT=VALUE, such as lubrication=1");
  expectRefused("lubrication=1,lubrication=1", "found a second lubrication, wanted each input once");
  expectRefused("wetness=1", "found 'wetness', wanted an input of the model: lubrication, neck_flexion, depth, speed");
  const ProgramRun outside({"why", s4_, "--at", "lubrication=1,neck_flexion=60,depth=200,speed=900"});
  EXPECT_EQ(outside.status, 0);
  EXPECT_NE(outside.err.find("speed 900 lies outside its universe; taken as 400"), std::string::npos) << outside.err;
  const ProgramRun unknown({"why", s4_, "--at", kPoint, "--expert", "S9"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_NE(unknown.err.find("found 'S9', wanted one of S4"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace tactus::cli
