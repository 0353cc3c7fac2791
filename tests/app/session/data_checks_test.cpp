// Well-made tables give no finding; each ordinary mistake is named, once, at the participant who has it.
#include "app/session/data_checks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <ostream>

#include "tests/support/table_study.h"

namespace tactus::session {
namespace {

using study::Answer;
using study::DataFinding;
using study::ForceJudgement;
using study::SpeedSample;
using study::Study;
using Severity = DataFinding::Severity;

const std::string kWho = "N3";

template <class Record>
void each(std::vector<Record>& records, const std::function<void(Record&)>& change) {
  for (auto& record : records) {
    if (record.participant == kWho) change(record);
  }
}
void eachSample(Study& study, const std::function<void(SpeedSample&)>& change) { each(study.speeds, change); }
void eachJudgement(Study& study, const std::function<void(ForceJudgement&)>& change) { each(study.judgements, change); }
void eachAnswer(Study& study, const std::function<void(Answer&)>& change) { each(study.answers, change); }

template <class Record>
void removeRows(std::vector<Record>& records, const std::function<bool(const Record&)>& gone) {
  std::erase_if(records, [&gone](const Record& record) { return record.participant == kWho && gone(record); });
}

/// The rows of kWho at `from` become those of `source`, each changed by `change`.
template <class Record>
void copyFrom(std::vector<Record>& records, const std::string& source, const std::function<void(Record&)>& change) {
  std::vector<Record> copies;
  for (const auto& record : records) {
    if (record.participant != source) continue;
    copies.push_back(record);
    copies.back().participant = kWho;
    change(copies.back());
  }
  std::erase_if(records, [](const Record& record) { return record.participant == kWho; });
  records.insert(records.end(), copies.begin(), copies.end());
}

void setTerm(ForceJudgement& judgement, const std::string& term) {
  judgement.kind = ForceJudgement::Kind::kTerm;
  judgement.term = term;
}

std::string opposite(const std::string& term) {
  static const std::vector<std::string> terms = {"very_small", "small", "medium", "large", "very_large"};
  const auto place = std::find(terms.begin(), terms.end(), term) - terms.begin();
  return terms[static_cast<std::size_t>(4 - place)];
}

struct Mistake {
  std::string name;
  std::function<void(Study&)> make;
  std::string kind;
  Severity severity = Severity::kWarning;
};

std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.name; }

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
       "speed_unit", Severity::kRefused},
      {"OneStrokeInCmPerS",
       [](Study& study) {
         eachSample(study, [](SpeedSample& row) {
           if (row.level == "slow" && row.stroke == 2) row.speed_mm_s *= 0.1;
         });
       },
       "speed_unit", Severity::kRefused},
      {"ForcesInMn", [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.force_n *= 1000; }); },
       "force_unit", Severity::kRefused},
      {"ForcesInGrams",
       [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.force_n /= 0.00980665; }); }, "force_unit",
       Severity::kRefused},
      {"ForcesWithoutTheirComma",
       [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.force_n *= 10; }); }, "force_unit"},
  };
}

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

std::vector<Mistake> judgementMistakes() {
  return {
      {"TheScaleReversed",
       [](Study& study) {
         eachJudgement(study, [](ForceJudgement& row) {
           if (row.kind == ForceJudgement::Kind::kTerm) row.term = opposite(row.term);
         });
       },
       "scale_reversed"},
      {"OneWordForAll", [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { setTerm(row, "medium"); }); },
       "one_word"},
      {"BeyondAtThreeTenths",
       [](Study& study) {
         eachJudgement(study, [](ForceJudgement& row) {
           if (row.step != 3) return;
           row.kind = ForceJudgement::Kind::kBeyondPractice;
           row.term.clear();
         });
       },
       "beyond_too_early"},
      {"NotFeltAboveFelt",
       [](Study& study) {
         eachJudgement(study, [](ForceJudgement& row) {
           if (row.step == 1) setTerm(row, "very_small");
           if (row.step != 5) return;
           row.kind = ForceJudgement::Kind::kNotFelt;
           row.term.clear();
         });
       },
       "not_felt_above_felt"},
      {"ForcesAgainstTheSeries",
       [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.step = 18 - row.step; }); },
       "force_order"},
      {"TermsThatJump",
       [](Study& study) {
         eachJudgement(study, [](ForceJudgement& row) { setTerm(row, row.step % 2 == 0 ? "small" : "large"); });
       },
       "terms_fall", Severity::kNote},
      {"ATermMisspelled",
       [](Study& study) {
         eachJudgement(study, [](ForceJudgement& row) {
           if (row.step == 2) setTerm(row, "smal");
         });
       },
       "unknown_force_term", Severity::kRefused},
      {"JudgementsOfAnother",
       [](Study& study) { copyFrom<ForceJudgement>(study.judgements, "N1", [](ForceJudgement&) {}); },
       "judgements_copied", Severity::kNote},
      {"NoJudgements",
       [](Study& study) { removeRows<ForceJudgement>(study.judgements, [](const auto&) { return true; }); },
       "without_judgements"},
  };
}

std::vector<Mistake> answerMistakes() {
  return {
      {"OneAnswer", [](Study& study) { eachAnswer(study, [](Answer& row) { row.term = "medium"; }); }, "one_answer"},
      {"NearlyOneAnswer",
       [](Study& study) { eachAnswer(study, [](Answer& row) { row.term = row.item % 20 == 0 ? "large" : "medium"; }); },
       "one_answer"},
      {"APatternOfAnswers",
       [](Study& study) {
         eachAnswer(study, [](Answer& row) {
           static const std::vector<std::string> terms = {"small", "medium", "large", "medium"};
           row.term = terms[static_cast<std::size_t>(row.item % 4)];
         });
       },
       "answer_pattern"},
      {"AnswersReversed", [](Study& study) { eachAnswer(study, [](Answer& row) { row.term = opposite(row.term); }); },
       "answers_reversed"},
      {"AnswersOfAnother", [](Study& study) { copyFrom<Answer>(study.answers, "N1", [](Answer&) {}); },
       "answers_copied"},
      {"AnswersOfAnotherButTwo",
       [](Study& study) {
         copyFrom<Answer>(study.answers, "N1", [](Answer& row) {
           if (row.item == 7 || row.item == 30) row.term = row.term == "medium" ? "large" : "medium";
         });
       },
       "answers_copied"},
      {"AnItemOutsideTheForm",
       [](Study& study) {
         eachAnswer(study, [](Answer& row) {
           if (row.item == 45) row.item = 46;
         });
       },
       "unknown_item", Severity::kRefused},
      {"AnAnswerMisspelled",
       [](Study& study) {
         eachAnswer(study, [](Answer& row) {
           if (row.item == 4) row.term = "lagre";
         });
       },
       "unknown_answer_term", Severity::kRefused},
      {"NoAnswers", [](Study& study) { removeRows<Answer>(study.answers, [](const auto&) { return true; }); },
       "without_answers"},
      {"NoStrokes", [](Study& study) { removeRows<SpeedSample>(study.speeds, [](const auto&) { return true; }); },
       "without_strokes"},
      {"ThreeHundredYears", [](Study& study) { study.participants[2].years_experience = 300; }, "years_unlikely",
       Severity::kRefused},
      {"AYearOfTheCalendar", [](Study& study) { study.participants[2].years_experience = 1987; }, "years_unlikely",
       Severity::kRefused},
      {"AnAge", [](Study& study) { study.participants[2].years_experience = 61; }, "years_unlikely"},
  };
}

class DataMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(DataMistakes, AreNamedOnceAtTheParticipantWhoHasThem) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Study study = support::tableStudy(seed);
    GetParam().make(study);
    const auto findings = dataFindings(study);
    int named = 0;
    for (const auto& finding : findings) {
      EXPECT_EQ(finding.participant, kWho) << text(finding);
      if (name(finding.kind) != GetParam().kind) continue;
      ++named;
      EXPECT_EQ(finding.severity, GetParam().severity) << text(finding);
      EXPECT_GT(finding.cell.line.number, 1U);
      EXPECT_NE(finding.sentence.find(kWho), std::string::npos) << finding.sentence;
    }
    EXPECT_EQ(named, 1) << "seed " << seed << ", " << findings.size() << " findings"
                        << (findings.empty() ? "" : ": " + text(findings.front()));
    EXPECT_EQ(study::refuseData(findings).has_value(), GetParam().severity != Severity::kRefused)
        << text(findings.front());
  }
}

const auto kNameOf = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Units, DataMistakes, testing::ValuesIn(unitMistakes()), kNameOf);
INSTANTIATE_TEST_SUITE_P(Rows, DataMistakes, testing::ValuesIn(rowMistakes()), kNameOf);
INSTANTIATE_TEST_SUITE_P(Judgements, DataMistakes, testing::ValuesIn(judgementMistakes()), kNameOf);
INSTANTIATE_TEST_SUITE_P(Answers, DataMistakes, testing::ValuesIn(answerMistakes()), kNameOf);

TEST(DataChecks, CodesThatAPersonTakesForOne) {
  for (const std::string code : {"n1", "N 1", "N-1", "N01", "N_001",
                                 "N\xE2\x80\x93"
                                 "1",
                                 "N\xC2\xA0"
                                 "1"}) {
    Study study = support::tableStudy(4);
    for (auto* rows : {&study.speeds}) {
      for (auto& row : *rows) row.participant = row.participant == kWho ? code : row.participant;
    }
    for (auto& row : study.judgements) row.participant = row.participant == kWho ? code : row.participant;
    for (auto& row : study.answers) row.participant = row.participant == kWho ? code : row.participant;
    study.participants[2].code = code;
    const auto findings = dataFindings(study);
    ASSERT_EQ(findings.size(), 1U) << code;
    EXPECT_EQ(name(findings[0].kind), "codes_alike");
    EXPECT_EQ(findings[0].participant, code);
    EXPECT_EQ(findings[0].cell.line.number, 4U);
  }
}

TEST(DataChecks, CodesWithOtherNumbersAreNotAlike) {
  Study study = support::tableStudy(4, {.nurses = 12});
  for (const auto& finding : dataFindings(study)) EXPECT_NE(name(finding.kind), "codes_alike") << text(finding);
}

TEST(DataChecks, CodesThatLookLikeNames) {
  Study study;
  for (const char* code :
       {"Anna Schmidt", "anna.schmidt", "a.s@clinic.example", "S1", "NURSE A", "Nurse 12", "expert-one2"})
    study.participants.emplace_back().code = code;
  std::vector<std::string> named;
  for (const auto& finding : dataFindings(study)) {
    if (name(finding.kind) == "code_like_name") named.push_back(finding.participant);
  }
  EXPECT_EQ(named, (std::vector<std::string>{"Anna Schmidt", "anna.schmidt", "a.s@clinic.example"}));
}

TEST(DataChecks, SimulatedBesideReal) {
  Study study = support::tableStudy(5);
  study.participants[1].simulated = true;
  const auto findings = dataFindings(study);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(text(findings[0]), "participants.csv, line 3: Simulated participants stand beside real ones: N2.");
  for (auto& participant : study.participants) participant.simulated = true;
  EXPECT_TRUE(dataFindings(study).empty());
}

TEST(DataChecks, SentencesSayWhatAndTheRemedy) {
  Study study = support::tableStudy(6);
  eachSample(study, [](SpeedSample& row) { row.speed_mm_s /= 10; });
  const auto findings = dataFindings(study);
  ASSERT_EQ(findings.size(), 1U);
  const auto refused = study::refuseData(findings);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(findings[0].sentence,
            "In all 12 strokes of N3 the speeds look like cm/s: multiply speed_mm_s by 10 there, so that s, mm and "
            "mm/s fit each other.");
  EXPECT_EQ(refused.error().message(),
            "speeds.csv: line " + std::to_string(findings[0].cell.line.number) +
                ", column 'speed_mm_s': found that in all 12 strokes of N3 the speeds look like cm/s, wanted multiply "
                "speed_mm_s by 10 there, so that s, mm and mm/s fit each other");
}

TEST(DataChecks, AStudyFromAFileHasNoLines) {
  Study study = support::tableStudy(6);
  study.participants[2].years_experience = 300;
  for (auto& participant : study.participants) participant.line = {};
  const auto findings = dataFindings(study);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(text(findings[0]), findings[0].sentence);
  EXPECT_EQ(study::refuseData(findings).error().file, "");
}

// Chance gives two participants one series of words in about one of a thousand pairs (15 pairs a study here), and the
// sentence says so; nothing else is ever said of well-made tables.
TEST(DataChecks, WellMadeTablesGiveNoFinding) {
  int copied_by_chance = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    for (const double noise : {0.0, 0.05}) {
      for (const auto& finding : dataFindings(support::tableStudy(seed, {.noise = noise}))) {
        EXPECT_EQ(name(finding.kind), "judgements_copied") << "seed " << seed << ": " << text(finding);
        ++copied_by_chance;
      }
    }
  }
  EXPECT_LE(copied_by_chance, 6);  // of 120 studies with 15 pairs each, 1.8 are expected
  EXPECT_TRUE(dataFindings({}).empty());
}

}  // namespace
}  // namespace tactus::session
