// "Look at the data first": build, study check and study import say what is odd about the data before any number.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/study/csv_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

class DataFirst : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directory(study_); }
  /// Writes the study of seed 1, spoiled by `spoil`.
  template <class Spoil>
  void write(Spoil spoil) const {
    study::Study study = support::tableStudy(1);
    spoil(study);
    ASSERT_TRUE(study::writeStudyFolder(study, support::ngtInputIds(), study_).has_value());
  }
  void writeGood() const {
    write([](study::Study&) {});
  }
  ProgramRun build(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"build", study_, "--out", out_, "--replicates", "0"});
    return ProgramRun(more);
  }

  support::TempFolder folder_;
  std::string study_ = folder_.file("study");
  std::string out_ = folder_.file("m.tactus.json");
  std::string file_ = folder_.file("s.tactus");
};

TEST_F(DataFirst, NothingIsSaidOfWellMadeTables) {
  writeGood();
  const ProgramRun built = build();
  EXPECT_EQ(built.status, 0) << built.err;
  EXPECT_TRUE(built.out.starts_with(out_ + ": study; experts 6\n")) << built.out;
  const ProgramRun checked({"study", "check", study_});
  EXPECT_EQ(checked.status, 0);
  EXPECT_EQ(checked.out, study_ + ": findings 0\n");
  EXPECT_EQ(Json::parse(build({"--json"}).out).at("data"), Json::array());
}

TEST_F(DataFirst, WhatIsDoubtfulStandsBeforeTheNumbers) {
  write([](study::Study& study) {
    std::erase_if(study.speeds, [](const auto& row) { return row.participant == "N2" && row.level == "fast"; });
    for (auto& row : study.answers) row.term = row.participant == "N5" ? "small" : row.term;
  });
  const ProgramRun built = build();
  EXPECT_EQ(built.status, 0) << built.err;
  EXPECT_TRUE(built.out.starts_with("look at the data first: 2\n  speeds.csv, line ")) << built.out;
  EXPECT_NE(
      unwrapped(built.out).find(": N2 has no strokes at fast: the terms of the speed are made of the other levels"),
      std::string::npos)
      << built.out;
  EXPECT_NE(built.out.find("  answers.csv, line 182: N5 answers 45 of 45 items with 'small'"), std::string::npos)
      << built.out;
  EXPECT_EQ(built.out.find("0.0 ± 0.0"), std::string::npos) << "a level without strokes has no mean";
  EXPECT_NE(built.out.find("  fast no strokes; center "), std::string::npos) << built.out;
  const Json data = Json::parse(build({"--json"}).out).at("data");
  ASSERT_EQ(data.size(), 2U);
  EXPECT_EQ(data.at(1).at("kind"), "one_answer");
  EXPECT_EQ(data.at(1).at("severity"), "warning");
  EXPECT_EQ(data.at(1).at("participant"), "N5");
  EXPECT_EQ(data.at(1).at("table"), "answers.csv");
  EXPECT_EQ(data.at(1).at("line"), 182);
  EXPECT_EQ(data.at(1).at("column"), "term");
}

TEST_F(DataFirst, UnitsThatCannotBeMeantAreRefusedWithTheRemedy) {
  write([](study::Study& study) {
    for (auto& row : study.speeds) row.speed_mm_s /= row.participant == "N1" ? 10 : 1;
    for (auto& row : study.judgements) row.force_n *= row.participant == "N4" ? 1000 : 1;
  });
  const std::string sentence =
      "/speeds.csv: line 2, column 'speed_mm_s': found that in all 12 strokes of N1 the speeds look like cm/s, wanted "
      "multiply speed_mm_s by 10 there, so that s, mm and mm/s fit each other, or --accept speed_unit if the data "
      "are right as they are (1 more: tactus study check lists them)\n";
  const ProgramRun built = build();
  EXPECT_EQ(built.status, 1);
  EXPECT_EQ(built.err, "tactus: " + study_ + sentence);
  EXPECT_FALSE(std::filesystem::exists(out_));
  const ProgramRun imported({"study", "import", file_, study_});
  EXPECT_EQ(imported.status, 1);
  EXPECT_EQ(imported.err, "tactus: " + study_ + sentence);
  EXPECT_FALSE(std::filesystem::exists(file_));
  const ProgramRun checked({"study", "check", study_});
  EXPECT_EQ(checked.status, 0) << "findings are results";
  EXPECT_NE(checked.out.find("look at the data first: 2\n  refused: speeds.csv, line 2: In all 12 strokes of N1"),
            std::string::npos)
      << checked.out;
  EXPECT_NE(unwrapped(checked.out).find("The forces of N4 reach 1"), std::string::npos) << checked.out;
  EXPECT_NE(unwrapped(checked.out).find("look like mN: divide force_n by 1000"), std::string::npos) << checked.out;
}

TEST_F(DataFirst, WhatWasRefusedWronglyCanBeAcceptedAndIsRecorded) {
  write([](study::Study& study) {
    for (auto& row : study.speeds) row.speed_mm_s /= row.participant == "N1" || row.participant == "N5" ? 10 : 1;
    study.participants[3].years_experience = 300;
  });
  EXPECT_EQ(build({"--accept", "speed_unit"}).status, 1);
  const ProgramRun built = build({"--accept", "speed_unit", "--accept", "years_unlikely", "--accept", "force_unit"});
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_NE(built.out.find("\n  accepted: speeds.csv, line 2: In all 12 strokes of N1"), std::string::npos)
      << built.out;
  const std::string text = unwrapped(built.out);
  EXPECT_NE(text.find("note: Accepted as it is: speed_unit of N1, N5; years_unlikely of N4."), std::string::npos)
      << text;
  EXPECT_NE(text.find("note: Nothing was refused for force_unit: --accept has no effect."), std::string::npos) << text;
  EXPECT_EQ(Json::parse(readText(out_)).at("provenance").at("settings").at("accepted_data"),
            Json::parse(R"({"speed_unit": ["N1", "N5"], "years_unlikely": ["N4"]})"));
  const Json result = Json::parse(build({"--accept", "speed_unit", "--accept", "years_unlikely", "--json"}).out);
  EXPECT_EQ(result.at("accepted"), Json({"speed_unit", "years_unlikely"}));
  EXPECT_EQ(result.at("data").size(), 3U);

  const ProgramRun imported({"study", "import", file_, study_, "--accept", "speed_unit", "--accept", "years_unlikely"});
  EXPECT_EQ(imported.status, 0) << imported.err;
}

TEST_F(DataFirst, AWordThatIsNoKindToAcceptIsNamedWithTheKnownOnes) {
  writeGood();
  const ProgramRun run = build({"--accept", "sped_unit"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("found 'sped_unit', wanted one of speed_unit, depth_unit, time_unit, several_units, "
                         "columns_swapped, speed_sign, force_unit, years_unlikely (speed_unit?)"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(build({"--accept", "unknown_level"}).status, 2) << "no model can be built of it";
  EXPECT_EQ(build().status, 0);
  EXPECT_FALSE(Json::parse(readText(out_)).at("provenance").at("settings").contains("accepted_data"));
}

TEST_F(DataFirst, AStudyFileIsLookedAtToo) {
  write([](study::Study& study) {
    for (auto& row : study.judgements) {
      if (row.participant == "N6" && row.kind == study::ForceJudgement::Kind::kTerm) row.term = "large";
    }
  });
  const ProgramRun imported({"study", "import", file_, study_});
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_TRUE(imported.out.starts_with("look at the data first: 1\n  judgements.csv, line ")) << imported.out;
  const ProgramRun checked({"study", "check", file_});
  EXPECT_EQ(checked.status, 0);
  EXPECT_NE(checked.out.find("look at the data first: 1\n  N6 calls all "), std::string::npos) << checked.out;
  const Json data = Json::parse(ProgramRun({"study", "check", file_, "--json"}).out).at("data");
  ASSERT_EQ(data.size(), 1U);
  EXPECT_EQ(data.at(0).at("line"), nullptr);
  EXPECT_EQ(data.at(0).at("table"), nullptr);
}

}  // namespace
}  // namespace tactus::cli
