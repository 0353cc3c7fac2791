// `tell` on the command line, the stroke that it saves, and `replay` of that file.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/files/file.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

class TellTest : public testing::Test {
 protected:
  TellTest() {
    auto model = support::s4FiveRegions();
    EXPECT_TRUE(model_io::writeModel(model, s4_));
    model.experts[0].rules[27].then = "very_large";
    EXPECT_TRUE(model_io::writeModel(model, edited_));
  }

  support::TempFolder folder_;
  std::string s4_ = folder_.file("s4.tactus.json");
  std::string edited_ = folder_.file("edited.tactus.json");
  std::string strokes_ = folder_.file("told.strokes.json");
};

// 3.02: a reference figure of another program.
TEST_F(TellTest, FeltAndKept) {
  const ProgramRun run({"tell", s4_, edited_, "--strokes", strokes_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("felt: 3.02 JND")) << run.out;
  EXPECT_NE(run.out.find("JND, proved"), std::string::npos) << run.out;
  const ProgramRun json({"tell", s4_, edited_, "--json"});
  const Json found = Json::parse(json.out);
  EXPECT_EQ(found["felt"], true);
  EXPECT_GE(found["bound_jnd"].get<double>(), found["largest_jnd"].get<double>());

  const ProgramRun replayed({"replay", strokes_, edited_, "--before", s4_, "--json"});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  EXPECT_EQ(Json::parse(replayed.out)["strokes"][0]["rms_jnd"], found["rms_jnd"]);
  const ProgramRun text({"replay", strokes_, s4_, "--before", s4_});
  EXPECT_TRUE(text.out.starts_with("0 of 1 stroke would feel different")) << text.out;
  const ProgramRun alone({"replay", strokes_, edited_});
  EXPECT_EQ(alone.status, 1);
  EXPECT_NE(alone.err.find("wanted --before MODEL"), std::string::npos) << alone.err;
}

TEST_F(TellTest, NoneFelt) {
  const ProgramRun run({"tell", s4_, s4_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out,
            "none felt: the best stroke found differs by 0.00 JND in the mean square over its time\n"
            "  nowhere more than 0.02 JND, proved\n");
}

TEST_F(TellTest, OneExpertAgainstTheMean) {
  const std::string four = folder_.file("four.tactus.json");
  ASSERT_TRUE(model_io::writeModel(support::inventedExperts(), four));
  const ProgramRun same({"tell", four, s4_, "--expert-a", "S4", "--json"});
  ASSERT_EQ(same.status, 0) << same.err;
  EXPECT_EQ(Json::parse(same.out)["rms_jnd"], 0);
  EXPECT_EQ(Json::parse(ProgramRun({"tell", four, s4_, "--json"}).out)["felt"], true);
  EXPECT_EQ(ProgramRun({"tell", four, s4_, "--expert-a", "S9"}).status, 1);
}

TEST_F(TellTest, BrokenStrokes) {
  const auto refused = [&](const std::string& text, const std::string& says) {
    ASSERT_TRUE(base::writeFileAtomically(strokes_, text));
    const ProgramRun run({"replay", strokes_, edited_, "--before", s4_});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
  };
  const std::string head = R"({"format": "tactus-strokes", "version": 1, "strokes": [{"from_mm": 100, "to_mm": )";
  refused(head + R"(90, "peak_mm_s": 50, "at": {"lubrication": 1, "neck_flexion": 60}}]})", "a depth behind from_mm");
  refused(head + R"(190, "peak_mm_s": 50, "at": {"lubrication": 1}}]})", "a value for 'neck_flexion'");
  refused(head + R"(190, "peak_mm_s": 50, "at": {"lubrication": 1, "neck_flexion": 60, "wind": 2}}]})", "'wind'");
  refused("{}", "format");
}

}  // namespace
}  // namespace tactus::cli
