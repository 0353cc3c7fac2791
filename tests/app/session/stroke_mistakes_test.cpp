// Strokes that are missing, twice, copied or cut are named.
#include <cmath>
#include <set>

#include "tests/app/session/data_mistakes.h"

namespace tactus::session {
namespace {

std::vector<Mistake> rowMistakes() {
  return {
      {"EverySampleTwice",
       [](Study& study) {
         std::vector<SpeedSample> rows;
         for (const auto& row : study.speeds) {
           rows.push_back(row);
           if (row.participant == kWho) rows.push_back(row);
         }
         study.speeds = rows;
       },
       "rows_twice"},
      {"TheBlockTwice",
       [](Study& study) {
         const auto rows = study.speeds;
         for (const auto& row : rows) {
           if (row.participant == kWho) study.speeds.push_back(row);
         }
       },
       "rows_twice"},
      {"RowsBackwards",
       [](Study& study) {
         std::vector<std::size_t> places;
         for (std::size_t i = 0; i < study.speeds.size(); ++i) {
           if (study.speeds[i].participant == kWho) places.push_back(i);
         }
         for (std::size_t i = 0; 2 * i < places.size(); ++i) {
           std::swap(study.speeds[places[i]], study.speeds[places[places.size() - 1 - i]]);
         }
       },
       "rows_backwards"},
      {"RowsShuffled",
       [](Study& study) {
         for (std::size_t i = 7; i < study.speeds.size(); i += 3) {
           if (study.speeds[i].participant == kWho && study.speeds[i - 5].participant == kWho) {
             std::swap(study.speeds[i], study.speeds[i - 5]);
           }
         }
       },
       "rows_unsorted"},
      {"AStrokeNumberTwice",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           if (row.level == "medium" && row.stroke == 2) row.stroke = 1;
         });
       },
       "stroke_twice"},
      {"NoStrokesAtALevel",
       [](Study& study) { removeRows<SpeedSample>(study.speeds, [](const auto& row) { return row.level == "fast"; }); },
       "level_without_strokes"},
      {"AStrokeIsMissing",
       [](Study& study) {
         removeRows<SpeedSample>(study.speeds, [](const auto& row) { return row.level == "fast" && row.stroke == 3; });
       },
       "strokes_missing", Severity::kNote},
      {"ALevelMisspelled",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           if (row.level == "medium") row.level = "meduim";
         });
       },
       "unknown_level", Severity::kRefused},
      {"LevelsSwapped",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           row.level = row.level == "slow" ? "fast" : row.level == "fast" ? "slow" : row.level;
         });
       },
       "levels_swapped"},
      {"OneSpeedForAStroke",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           if (row.level == "slow" && row.stroke == 1) {
             row.speed_mm_s = 60;
             row.depth_mm = 60 * row.time_s;
           }
         });
       },
       "constant_speed"},
      {"ASampleTimesThousand",
       [](Study& study) {
         int count = 0;
         eachSample(study, [&count](SpeedSample& row) { row.speed_mm_s *= ++count == 40 ? 1000 : 1; });
       },
       "outliers"},
      {"ADepthTimesThousand",
       [](Study& study) {
         int count = 0;
         eachSample(study, [&count](SpeedSample& row) { row.depth_mm *= ++count == 40 ? 1000 : 1; });
       },
       "outliers"},
      {"AStrokeThatStopsEarly",
       [](Study& study) {
         removeRows<SpeedSample>(study.speeds, [](const auto& row) {
           return row.level == "medium" && row.stroke == 4 && row.depth_mm > 20;
         });
       },
       "stroke_too_short", Severity::kNote},
      {"SamplesMissing",
       [](Study& study) {
         removeRows<SpeedSample>(study.speeds, [](const auto& row) {
           return row.level == "slow" && row.stroke == 4 && row.depth_mm > 20 && row.depth_mm < 35;
         });
       },
       "samples_missing", Severity::kNote},
      {"ACodeForMissing",
       [](Study& study) {
         int count = 0;
         eachSample(study, [&count](SpeedSample& row) {
           if (++count % 50 == 0) row.speed_mm_s = -999;
         });
       },
       "outliers"},
      {"AWithdrawalInTheStroke",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           if (row.depth_mm < 40 || row.level != "slow") return;
           row.depth_mm = 80 - row.depth_mm;
           row.speed_mm_s = -row.speed_mm_s;
         });
       },
       "withdrawal"},
      {"StrokesOfAnother", [](Study& study) { copyFrom<SpeedSample>(study.speeds, "N1", [](SpeedSample&) {}); },
       "stroke_copied"},
      {"StrokesOfAnotherShifted",
       [](Study& study) {
         copyFrom<SpeedSample>(study.speeds, "N1", [](SpeedSample& row) {
           row.speed_mm_s = std::round(10 * (row.speed_mm_s + 0.3)) / 10;
           row.depth_mm += 1.5;
           row.time_s += 0.01;
         });
       },
       "stroke_copied"},
      {"StrokesOfAnotherWithNoise",
       [](Study& study) {
         int count = 0;
         copyFrom<SpeedSample>(study.speeds, "N1",
                               [&count](SpeedSample& row) { row.speed_mm_s += 0.1 * (++count % 5 - 2); });
       },
       "stroke_copied"},
      {"StrokesOfAnotherWithRowsLeftOut",
       [](Study& study) {
         copyFrom<SpeedSample>(study.speeds, "N1", [](SpeedSample&) {});
         int count = 0;
         removeRows<SpeedSample>(study.speeds, [&count](const auto&) { return ++count % 10 == 0; });
       },
       "stroke_copied"},
      {"StrokesOfAnotherFromTheThirdRow",
       [](Study& study) {
         copyFrom<SpeedSample>(study.speeds, "N1", [](SpeedSample&) {});
         removeRows<SpeedSample>(study.speeds, [](const auto& row) { return row.time_s < 0.025; });
         eachSample(study, [](SpeedSample& row) { row.time_s -= 0.03; });
       },
       "stroke_copied"},
      {"StrokesOfAnotherLaterWithNoise",
       [](Study& study) {
         int count = 0;
         copyFrom<SpeedSample>(study.speeds, "N1",
                               [&count](SpeedSample& row) { row.speed_mm_s += 0.1 * (++count % 7 - 3); });
         removeRows<SpeedSample>(study.speeds, [](const auto& row) { return row.time_s < 0.005; });
         eachSample(study, [](SpeedSample& row) { row.time_s -= 0.01; });
       },
       "stroke_copied"},
      {"AStrokeCopiedToTheNextNumberWithRowsLeftOut",
       [](Study& study) {
         std::vector<SpeedSample> copies;
         int count = 0;
         for (const auto& row : study.speeds) {
           if (row.participant != kWho || row.level != "slow" || row.stroke != 1 || ++count % 6 == 0) continue;
           copies.push_back(row);
           copies.back().stroke = 2;
         }
         removeRows<SpeedSample>(study.speeds, [](const auto& row) { return row.level == "slow" && row.stroke == 2; });
         study.speeds.insert(study.speeds.end(), copies.begin(), copies.end());
       },
       "stroke_copied"},
      {"AStrokeCopiedToTheNextNumber",
       [](Study& study) {
         std::vector<SpeedSample> copies;
         for (const auto& row : study.speeds) {
           if (row.participant != kWho || row.level != "slow" || row.stroke != 1) continue;
           copies.push_back(row);
           copies.back().stroke = 2;
         }
         removeRows<SpeedSample>(study.speeds, [](const auto& row) { return row.level == "slow" && row.stroke == 2; });
         study.speeds.insert(study.speeds.end(), copies.begin(), copies.end());
       },
       "stroke_copied"},
      {"NoTimes", [](Study& study) { eachSample(study, [](SpeedSample& row) { row.time_s = 0; }); }, "no_times",
       Severity::kNote},
      {"NoDepths", [](Study& study) { eachSample(study, [](SpeedSample& row) { row.depth_mm = 0; }); }, "no_depths",
       Severity::kNote},
  };
}

class StrokeMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(StrokeMistakes, AreNamedOnceAtTheParticipantWhoHasThem) { expectNamedOnce(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Rows, StrokeMistakes, testing::ValuesIn(rowMistakes()), nameOf);

}  // namespace
}  // namespace tactus::session
