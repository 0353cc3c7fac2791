// What `tactus build` does with the speeds of a study, and what it prints of them.
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

/// A study of the strokes of tests/golden/fcm/S4_600.csv: levels that hardly differ.
class BuildSpeeds : public testing::Test {
 protected:
  BuildSpeeds() {
    writeText(folder_.file("participants.csv"),
              "participant,years_experience,category,handedness,weight,simulated\nS4,12,expert,right,1,1\n");
    writeText(folder_.file("rules.csv"),
              "participant,lubrication,neck_flexion,depth,speed,then,weight\nS4,,,,slow,small,1\nS4,,,,fast,large,1\n");
    writeSpeeds(4);
  }

  /// With the first `strokes` of each level.
  void writeSpeeds(char strokes) {
    std::ifstream in(TACTUS_GOLDEN_DIR "/fcm/S4_600.csv");
    std::string csv = "participant,level,stroke,time_s,depth_mm,speed_mm_s\n";
    const char* levels[] = {"slow", "medium", "fast"};
    for (std::string line; std::getline(in, line);) {
      if (line.front() == '#') continue;
      const auto comma = line.find(',');  // speed,level,stroke, the last two one digit each
      if (line[comma + 3] - '0' >= strokes) continue;
      csv += std::string("S4,") + levels[line[comma + 1] - '0'] + ',' + static_cast<char>(line[comma + 3] + 1) +
             ",0,0," + line.substr(0, comma) + '\n';
    }
    writeText(folder_.file("speeds.csv"), csv);
  }

  ProgramRun build(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"build", folder_.file(""), "--out", out_});
    return ProgramRun(more);
  }

  Json jsonOf(std::vector<std::string> more = {}) const {
    more.emplace_back("--json");
    const ProgramRun run = build(more);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out);
  }

  Json settings() const { return Json::parse(readText(out_)).at("provenance").at("settings"); }

  support::TempFolder folder_;
  support::TempFolder out_folder_;
  std::string out_ = out_folder_.file("model.tactus.json");
};

TEST_F(BuildSpeeds, ShowsLevelsOrderAndIntervals) {
  // tests/golden/speeds/reference.json: d' .594 and .389, index .229, accuracy .407, J 46 and p 8 / 34650.
  const ProgramRun run = build({"--replicates", "50"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* text : {"speeds of S4: 600 of 600 samples", "  slow 31.1 ± 8.9 mm/s, strokes 4; center 9.5 [",
                           "d' to the next level 0.59", "Jonckheere-Terpstra J 46 of 48, p 0.000231 (exact)",
                           "adjusted Rand index 0.23, accuracy 0.41",
                           "in brackets: 95 % intervals (Student's t, standard deviation of 50 draws of whole strokes)",
                           "hardly apart (d' 0.39, below 1)"}) {
    EXPECT_NE(run.out.find(text), std::string::npos) << text << '\n' << run.out;
  }
}

TEST_F(BuildSpeeds, JsonHasTheNumbers) {
  const Json speeds = jsonOf().at("speeds");
  EXPECT_EQ(speeds.at("replicates"), 2000);
  const Json& one = speeds.at("participants").at(0);
  EXPECT_EQ(one.at("participant"), "S4");
  EXPECT_EQ(one.at("simulated"), true);
  EXPECT_EQ(one.at("confusion"), Json::parse("[[31, 168, 1], [33, 77, 90], [33, 31, 136]]"));
  EXPECT_DOUBLE_EQ(one.at("jonckheere_terpstra").at("p").get<double>(), 8.0 / 34650);
  EXPECT_EQ(one.at("levels").size(), 3U);
  EXPECT_EQ(one.at("separations").size(), 2U);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& interval = one.at("centre_intervals")[k];
    EXPECT_LT(interval[0], one.at("centres")[k]);
    EXPECT_GT(interval[1], one.at("centres")[k]);
  }
  EXPECT_EQ(one.at("ramps").at(1).at("q"), speeds.at("averaged_ramps").at(1).at("q"));  // one participant
  EXPECT_EQ(settings().at("centres"), "clusters");
}

TEST_F(BuildSpeeds, LevelMeansAreCentresWhereAskedForAndTheModelSaysSo) {
  const Json one = jsonOf({"--centres", "level_means", "--alpha", "1", "--replicates", "0"}).at("speeds");
  EXPECT_EQ(one.at("replicates"), 0);
  const Json& participant = one.at("participants").at(0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(participant.at("centres")[k].get<double>(), participant.at("levels")[k].at("mean_mm_s").get<double>(),
                1e-12);
  }
  EXPECT_EQ(participant.at("centre_intervals"), nullptr);
  EXPECT_EQ(settings().at("centres"), "level_means");
  EXPECT_EQ(settings().at("averaging"), "mean");
  jsonOf({"--averaging", "median", "--replicates", "0"});
  EXPECT_EQ(settings().at("averaging"), "median");
  EXPECT_EQ(build({"--centres", "middles"}).status, 2);
  EXPECT_EQ(build({"--averaging", "sum"}).status, 2);
  EXPECT_EQ(build({"--replicates", "-1"}).status, 2);
}

TEST_F(BuildSpeeds, TooFewStrokesForIntervalsAreANote) {
  writeSpeeds(1);
  const ProgramRun run = build();
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(unwrapped(run.out).find(
                "note: There are no intervals of the speeds: speeds of participant S4, level slow: found 1 "
                "stroke, wanted at least 2 strokes of each level for an interval."),
            std::string::npos)
      << run.out;
  EXPECT_EQ(run.out.find("in brackets"), std::string::npos);
}

}  // namespace
}  // namespace tactus::cli
