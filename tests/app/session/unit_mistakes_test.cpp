// Wrong units and columns are named, and refused where they cannot be meant.
#include <cmath>
#include <set>

#include "tests/app/session/data_mistakes.h"

namespace tactus::session {
namespace {

std::vector<Mistake> unitMistakes() {
  const auto scaled = [](double time, double depth, double speed) {
    return [=](Study& study) {
      eachSample(study, [=](SpeedSample& row) {
        row.time_s *= time;
        row.depth_mm *= depth;
        row.speed_mm_s *= speed;
      });
    };
  };
  return {
      {"SpeedsInCmPerS", scaled(1, 1, 0.1), "speed_unit", Severity::kRefused},
      {"SpeedsInMPerS", scaled(1, 1, 1e-3), "speed_unit", Severity::kRefused},
      {"TimesInMs", scaled(1000, 1, 1), "time_unit", Severity::kRefused},
      {"DepthsInM", scaled(1, 1e-3, 1), "depth_unit", Severity::kRefused},
      {"DepthsInCm", scaled(1, 0.1, 1), "depth_unit", Severity::kRefused},
      {"MetersAndMPerS", scaled(1, 1e-3, 1e-3), "several_units", Severity::kRefused},
      {"MsAndMmPerMs", scaled(1000, 1, 1e-3), "several_units", Severity::kRefused},
      {"MsWithoutDepths",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           row.time_s *= 1000;
           row.depth_mm = 0;
         });
       },
       "time_unit", Severity::kRefused},
      {"CmAndCmPerS", scaled(1, 0.1, 0.1), "speed_scale"},
      {"SpeedsInKmPerH", scaled(1, 1, 3.6e-3), "speed_unit", Severity::kRefused},
      {"SpeedsWithoutTheirPoint", scaled(1, 1, 10), "speed_unit", Severity::kRefused},
      {"TimesInMinutes", scaled(1.0 / 60, 1, 1), "time_unit", Severity::kRefused},
      {"SpeedsTimesThree", scaled(1, 1, 3), "speed_against_depth"},
      {"DepthAndSpeedSwapped",
       [](Study& study) { eachSample(study, [](SpeedSample& row) { std::swap(row.depth_mm, row.speed_mm_s); }); },
       "columns_swapped", Severity::kRefused},
      {"TimeAndDepthSwapped",
       [](Study& study) { eachSample(study, [](SpeedSample& row) { std::swap(row.time_s, row.depth_mm); }); },
       "columns_swapped", Severity::kRefused},
      {"SpeedsBelowZero", scaled(1, 1, -1), "speed_sign", Severity::kRefused},
      {"DepthsFromTheOtherEnd",
       [](Study& study) { eachSample(study, [](SpeedSample& row) { row.depth_mm = 200 - row.depth_mm; }); },
       "depth_falls"},
      {"OneLevelInCmPerS",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           if (row.level == "fast") row.speed_mm_s *= 0.1;
         });
       },
       "speed_unit"},
      {"OneStrokeInCmPerS",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           if (row.level == "slow" && row.stroke == 2) row.speed_mm_s *= 0.1;
         });
       },
       "speed_unit"},
      {"AConstantAddedToTheSpeeds",
       [](Study& study) { eachSample(study, [](SpeedSample& row) { row.speed_mm_s += 12; }); }, "speed_against_depth"},
      {"ForcesInMn", [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.force_n *= 1000; }); },
       "force_unit", Severity::kRefused},
      {"ForcesInGrams",
       [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.force_n /= 0.00980665; }); }, "force_unit",
       Severity::kRefused},
      {"ForcesWithoutTheirComma",
       [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.force_n *= 10; }); }, "force_unit"},
  };
}

class UnitMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(UnitMistakes, AreNamedOnceAtTheParticipantWhoHasThem) { expectNamedOnce(GetParam()); }

// 25 samples in 125 ms: minutes and cm would fit as well, but no other stroke says so.
TEST(UnitFindings, OneShortStrokeIsNoReasonToRefuse) {
  Study study = support::tableStudy(1);
  removeRows<SpeedSample>(study.speeds, [](const SpeedSample& row) { return row.level == "fast" && row.stroke == 2; });
  const auto line = study.speeds.back().line;
  for (int i = 0; i < 25; ++i) {
    SpeedSample row{kWho, "fast", 2, i * 0.125 / 24, 20 + i * 0.125 / 24 * 20, 20, line};
    study.speeds.push_back(row);
  }
  EXPECT_TRUE(study::refuseData(dataFindings(study)));
}

INSTANTIATE_TEST_SUITE_P(Units, UnitMistakes, testing::ValuesIn(unitMistakes()), nameOf);

}  // namespace
}  // namespace tactus::session
