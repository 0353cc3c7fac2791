// Mistakes in judgements, answers, rules and participants are named.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/session/study_source.h"

#include "tests/app/session/data_mistakes.h"
#include "tests/support/default_procedure.h"

namespace tactus::session {
namespace {

/// The answers of kWho `rows` rows further up, the first ones behind the last.
void moveAnswers(Study& study, std::size_t rows) {
  std::vector<std::string> terms;
  eachAnswer(study, [&terms](Answer& row) { terms.push_back(row.term); });
  std::size_t next = rows;
  eachAnswer(study, [&terms, &next](Answer& row) { row.term = terms[next++ % terms.size()]; });
}

/// The answers of kWho for each level of `input` become those that they gave for the level that `levels` names.
void exchangeLevels(Study& study, const std::string& input, const std::map<std::string, std::string>& levels) {
  const auto items = knownForms(support::defaultProcedure()).front().items;
  std::map<int, std::string> terms;
  eachAnswer(study, [&terms](Answer& row) { terms[row.item] = row.term; });
  eachAnswer(study, [&](Answer& row) {
    auto wanted = items[static_cast<std::size_t>(row.item - 1)].conditions;
    for (auto& condition : wanted) {
      if (condition.input == input && levels.contains(condition.term)) condition.term = levels.at(condition.term);
    }
    for (const auto& item : items) {
      if (item.conditions == wanted) row.term = terms.at(item.number);
    }
  });
}

/// The levels of an input in the order of the form, each with the one at the mirrored place.
std::map<std::string, std::string> mirrored(const std::string& input) {
  std::vector<std::string> levels;
  for (const auto& item : knownForms(support::defaultProcedure()).front().items) {
    for (const auto& condition : item.conditions) {
      if (condition.input == input && std::find(levels.begin(), levels.end(), condition.term) == levels.end())
        levels.push_back(condition.term);
    }
  }
  std::map<std::string, std::string> out;
  for (std::size_t k = 0; k < levels.size(); ++k) out[levels[k]] = levels[levels.size() - 1 - k];
  return out;
}

/// Gives `who` the answers of `source` as rules.
void giveRules(Study& study, const std::string& who, const std::string& source) {
  const auto items = knownForms(support::defaultProcedure()).front().items;
  for (const auto& answer : study.answers) {
    if (answer.participant != source) continue;
    study::GivenRule rule;
    rule.participant = who;
    rule.conditions = items[static_cast<std::size_t>(answer.item - 1)].conditions;
    rule.then = answer.term;
    rule.line.number = static_cast<std::uint32_t>(study.rules.size() + 2);
    study.rules.push_back(std::move(rule));
  }
}

std::vector<Mistake> judgementMistakes() {
  return {
      {"ASeriesWithoutItsName",
       [](Study& study) { eachJudgement(study, [](ForceJudgement& row) { row.series = "A"; }); }, "unknown_series"},
      {"ASeriesLeftEmptyBelowTheFirstRow",
       [](Study& study) {
         eachJudgement(study, [](ForceJudgement& row) {
           if (row.step > 1) row.series.clear();
         });
       },
       "unknown_series"},
      {"OnlyADescendingSeries",
       [](Study& study) {
         eachJudgement(study, [](ForceJudgement& row) {
           row.series = "descending";
           row.step = 18 - row.step;
         });
       },
       "without_judgements"},
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
      {"AnswersOneRowUp", [](Study& study) { moveAnswers(study, 1); }, "answers_shifted"},
      {"AnswersOneRowDown", [](Study& study) { moveAnswers(study, 44); }, "answers_shifted"},
      {"RegionsExchanged",
       [](Study& study) {
         exchangeLevels(study, "depth", {{"nasopharynx", "oropharynx"}, {"oropharynx", "nasopharynx"}});
       },
       "answers_shifted"},
      // The regions of these studies are alike from both ends, so all participants get a slope first.
      {"RegionsInReverseOrder",
       [](Study& study) {
         const auto items = knownForms(support::defaultProcedure()).front().items;
         for (auto& answer : study.answers) {
           for (const auto& condition : items[static_cast<std::size_t>(answer.item - 1)].conditions) {
             if (condition.term == "nasal_cavity" || condition.term == "nasopharynx") answer.term = "very_small";
             if (condition.term == "esophagus") answer.term = "large";
           }
         }
         exchangeLevels(study, "depth", mirrored("depth"));
       },
       "answers_shifted"},
      {"LubricationWordsExchanged",
       [](Study& study) {
         exchangeLevels(study, "lubrication", {{"poor", "well"}, {"well", "poor"}});
       },
       "answers_shifted"},
      {"AnswersSorted",
       [](Study& study) {
         std::vector<std::string> terms;
         eachAnswer(study, [&terms](Answer& row) { terms.push_back(row.term); });
         std::sort(terms.begin(), terms.end());
         std::size_t next = 0;
         eachAnswer(study, [&terms, &next](Answer& row) { row.term = terms[next++]; });
       },
       "answer_pattern"},
      {"RulesWithOneConsequent",
       [](Study& study) {
         giveRules(study, kWho, kWho);
         for (auto& rule : study.rules) rule.then = "medium";
       },
       "one_consequent"},
      {"RulesOfAnother",
       [](Study& study) {
         giveRules(study, "N1", "N1");
         giveRules(study, kWho, "N1");
       },
       "rules_copied"},
      {"RulesOfAnotherButTwo",
       [](Study& study) {
         giveRules(study, "N1", "N1");
         giveRules(study, kWho, "N1");
         for (const std::size_t i : {50, 70}) study.rules[i].then = study.rules[i].then == "large" ? "small" : "large";
       },
       "rules_copied"},
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

class AnswerMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(AnswerMistakes, AreNamedOnceAtTheParticipantWhoHasThem) { expectNamedOnce(GetParam()); }

// One form asked in two wordings is two questions.
TEST(Wordings, ThoseOfTheOthersAreNamedOnce) {
  const auto findingsFor = [](const std::string& others) {
    Study study = support::tableStudy(1);
    for (Answer& row : study.answers) row.wording = row.participant == kWho ? "plain" : others;
    return dataFindings(study);
  };
  EXPECT_TRUE(findingsFor("plain").empty());
  const auto mixed = findingsFor("published");
  ASSERT_EQ(mixed.size(), 1U);
  EXPECT_EQ(name(mixed[0].kind), "wordings_mixed");
  EXPECT_EQ(mixed[0].severity, Severity::kWarning);
  EXPECT_NE(mixed[0].sentence.find("'plain' (" + std::string(kWho) + ")"), std::string::npos) << mixed[0].sentence;
  const auto unknown = findingsFor("");
  ASSERT_EQ(unknown.size(), 1U);
  EXPECT_EQ(unknown[0].severity, Severity::kNote);
}

INSTANTIATE_TEST_SUITE_P(Judgements, AnswerMistakes, testing::ValuesIn(judgementMistakes()), nameOf);
INSTANTIATE_TEST_SUITE_P(Answers, AnswerMistakes, testing::ValuesIn(answerMistakes()), nameOf);

}  // namespace
}  // namespace tactus::session
