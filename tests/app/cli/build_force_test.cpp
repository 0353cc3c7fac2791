// What `tactus build` makes of force judgements that leave a term out, and of participants who stop at other forces.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

/// Three nurses whose answers are one letter for each force from 0.1 N on: v s m l V, b beyond practice.
class BuildForce : public testing::Test {
 protected:
  BuildForce() {
    writeText(folder_.file("participants.csv"),
              "participant,years_experience,category,handedness,weight,simulated\nA,,,,,\nB,,,,,\nC,,,,,\n");
    writeText(
        folder_.file("rules.csv"),
        "participant,lubrication,neck_flexion,depth,speed,then,weight\nA,poor,,,,very_large,\nB,poor,,,,large,\n");
  }

  void judge(const std::vector<std::string>& participants) const {
    const std::vector<std::string> words = {"very_small", "small", "medium", "large", "very_large", "beyond_practice"};
    std::string csv = "participant,series,step,force_n,term\n";
    for (std::size_t who = 0; who < participants.size(); ++who) {
      for (std::size_t i = 0; i < participants[who].size(); ++i) {
        const auto step = i + 1;
        csv += static_cast<char>('A' + who) + std::string(",ascending,") + std::to_string(step) + ',' +
               std::to_string(step / 10) + '.' + std::to_string(step % 10) + ',' +
               words[std::string("vsmlVb").find(participants[who][i])] + '\n';
      }
    }
    writeText(folder_.file("judgements.csv"), csv);
  }

  ProgramRun build(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"build", folder_.file(""), "--out", out_});
    return ProgramRun(more);
  }
  Json model() const { return Json::parse(readText(out_)); }

  support::TempFolder folder_;
  support::TempFolder out_folder_;
  std::string out_ = out_folder_.file("m.tactus.json");
};

TEST_F(BuildForce, EverybodySaysBeyondWhereVeryLargeWouldStand) {
  judge({"vvssmmlb", "vssmmllb", "vvsmmllb"});
  for (const char* way : {"vote", "frequency", "thresholds", "probit"}) {
    SCOPED_TRACE(way);
    const ProgramRun run = build({"--force-terms", way});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("force terms from the " + std::string(way) + ": "), std::string::npos) << run.out;
    const Json built = model();
    EXPECT_EQ(built.at("provenance").at("settings").at("force_terms"), way);
    EXPECT_EQ(built.at("output").at("max"), 0.8);  // 0.7 N and a step
    const Json terms = built.at("output").at("terms");
    ASSERT_EQ(terms.size(), 5U);
    EXPECT_EQ(terms[4].at("id"), "very_large");
    EXPECT_EQ(terms[4].at("points").back(), 0.8);
  }
  const ProgramRun run = build();
  EXPECT_EQ(model().at("output").at("terms")[4].at("points"), Json::parse("[0.7, 0.8, 0.8, 0.8]"));
  EXPECT_NE(unwrapped(run.out).find("note: No force up to 0.7 N was given 'very_large': its term is placed one step "
                                    "above, at 0.8 N."),
            std::string::npos)
      << run.out;
}

TEST_F(BuildForce, TheEndCanBeAskedFor) {
  judge({"vsmlV", "vsmlV", "vsmlVVVV"});
  ASSERT_EQ(build().status, 0);
  EXPECT_EQ(model().at("output").at("max"), 0.5);
  const ProgramRun run = build({"--force-end", "0.8", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(model().at("output").at("max"), 0.8);
  EXPECT_EQ(model().at("provenance").at("settings").at("force_end_n"), 0.8);
  const Json force = Json::parse(run.out).at("force");
  EXPECT_EQ(force.at("terms_from"), "vote");
  EXPECT_EQ(force.at("end_n"), 0.8);
  EXPECT_EQ(force.at("terms")[4], Json::parse(R"({"id": "very_large", "points": [0.4, 0.5, 0.8, 0.8]})"));
}

/// `vote` and `build` have the same options and give the same terms.
TEST_F(BuildForce, VoteGivesTheTermsThatBuildBuildsOf) {
  judge({"vvssmmlVVV", "vssmmlVb", "vvssmlVVVVV"});
  for (const char* way : {"vote", "frequency", "thresholds", "probit"}) {
    for (const char* end : {"", "0.8", "1.4"}) {
      SCOPED_TRACE(std::string(way) + ", end " + end);
      std::vector<std::string> options = {"--force-terms", way};
      if (*end != 0) options.insert(options.end(), {"--force-end", end});
      ASSERT_EQ(build(options).status, 0);
      options.insert(options.begin(), {"vote", folder_.file("judgements.csv"), "--json"});
      const ProgramRun run(options);
      ASSERT_EQ(run.status, 0) << run.err;
      const Json result = Json::parse(run.out);
      const Json output = model().at("output");
      EXPECT_EQ(result.at("terms_from"), way);
      EXPECT_EQ(result.at("end_n"), output.at("max"));
      ASSERT_EQ(result.at("terms").size(), output.at("terms").size());
      for (std::size_t i = 0; i < result.at("terms").size(); ++i) {
        EXPECT_EQ(result.at("terms")[i].at("id"), output.at("terms")[i].at("id"));
        EXPECT_EQ(result.at("terms")[i].at("points"), output.at("terms")[i].at("points"));
      }
    }
  }
  const ProgramRun text({"vote", folder_.file("judgements.csv"), "--force-terms", "thresholds"});
  EXPECT_NE(text.out.find("terms of the force from the thresholds (corners in N)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("the universe ends at "), std::string::npos) << text.out;
}

TEST_F(BuildForce, CountsKnowNoThresholds) {
  const std::string counts = folder_.file("counts.csv");
  writeText(counts, "force_n,very_small,small,medium,large,very_large\n0.1,4,0,0,0,0\n0.2,1,3,0,0,0\n");
  EXPECT_EQ(ProgramRun({"vote", counts, "--force-terms", "frequency"}).status, 0);
  const ProgramRun run({"vote", counts, "--force-terms", "thresholds"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "tactus: " + counts +
                         ": --force-terms: found thresholds with a table of counts, wanted a table of judgements, "
                         "because thresholds are those of each participant\n");
  EXPECT_EQ(ProgramRun({"vote", counts, "--force-end", "0"}).status, 2);
}

TEST_F(BuildForce, AnEndThatLeavesARuleWithoutItsTermIsRefused) {
  judge({"vsmlV", "vsmlV", "vsmlV"});
  const ProgramRun run = build({"--force-end", "0.4"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("there is no room for 'very_large' between 0 N and the end of the universe at 0.4 N"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(build({"--force-end", "1100"}).status, 2);  // in mN
  EXPECT_EQ(build({"--force-end", "0"}).status, 2);
  EXPECT_EQ(build({"--force-terms", "mean"}).status, 2);
}

}  // namespace
}  // namespace tactus::cli
