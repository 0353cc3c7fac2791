#include "elicitation/agreement/agreement.h"

#include <gtest/gtest.h>

#include "tests/elicitation/table2.h"

namespace tactus::elicitation {
namespace {

using study::Answer;
using study::ForceJudgement;

const std::vector<std::string> kTerms{"very_small", "small", "medium", "large", "very_large"};

/// One split of Table 2 over four persons whose terms never fall: a reconstruction, not the nurses' real answers.
std::vector<ForceJudgement> split() {
  const std::vector<std::vector<std::size_t>> people{{1, 2, 3, 4, 4, 4, 4, 4, 4, 4, 4},
                                                     {0, 1, 2, 2, 3, 3, 3, 4, 4, 4, 4},
                                                     {0, 0, 1, 1, 2, 2, 3, 3, 3, 4, 4},
                                                     {0, 0, 0, 1, 2, 2, 2, 2, 3, 3, 4}};
  std::vector<ForceJudgement> out;
  for (std::size_t p = 0; p < people.size(); ++p) {
    for (std::size_t i = 0; i < people[p].size(); ++i) {
      out.push_back({"P" + std::to_string(p + 1), "ascending", static_cast<int>(i) + 1,
                     0.1 * static_cast<double>(i + 1), ForceJudgement::Kind::kTerm, kTerms[people[p][i]]});
    }
  }
  return out;
}

void expectTable2(const Agreement& agreement) {
  // The digits that statsmodels and nltk give (tests/golden/agreement); z by the formula of 1979. Half of the last
  // digit.
  EXPECT_NEAR(agreement.fleiss_kappa->kappa, 0.09319, 5e-6);
  EXPECT_NEAR(agreement.fleiss_kappa->z, 1.44, 5e-3);
  EXPECT_NEAR(agreement.alpha_nominal.value(), 0.1138, 5e-5);
  EXPECT_NEAR(agreement.alpha_ordinal.value(), 0.5515, 5e-5);
  EXPECT_NEAR(agreement.alpha_interval.value(), 0.6031, 5e-5);
}

TEST(Agreement, OfTable2FromItsCounts) {
  const auto data = agreementData(table2(), kTerms);
  const auto result = agreement(data);
  expectTable2(result);
  EXPECT_FALSE(result.kendall_w);
  EXPECT_NE(result.kendall_w.error().find("who chose what"), std::string::npos);
  ASSERT_EQ(result.items.size(), 11);
  EXPECT_EQ(result.ratings, 44);
  EXPECT_EQ(data.units[2].name, "0.3 N");
  EXPECT_DOUBLE_EQ(result.items[2]->entropy_bits, 2);  // four answers, four terms
  EXPECT_EQ(result.items[2]->spread_terms, 3);
  EXPECT_EQ(result.items[10]->consensus, 1);
}

TEST(Agreement, OfTheSplitFromItsJudgements) {
  auto judgements = split();
  for (const char* who : {"P1", "P2", "P3", "P4"}) {
    judgements.push_back({who, "ascending", 12, 1.2, ForceJudgement::Kind::kBeyondPractice, ""});
    judgements.push_back({who, "random", 1, 0.1, ForceJudgement::Kind::kTerm, "large"});
  }
  judgements.push_back({"P5", "ascending", 1, 0.1, ForceJudgement::Kind::kNotFelt, ""});
  const auto data = agreementData(judgements, "ascending", kTerms);
  ASSERT_TRUE(data);
  const auto result = agreement(*data);
  expectTable2(result);
  EXPECT_NEAR(result.kendall_w->w, 0.8938, 5e-5);  // scipy, the same place
  EXPECT_EQ(data->raters, (std::vector<std::string>{"P1", "P2", "P3", "P4"}));
  EXPECT_EQ(data->notes, (std::vector<std::string>{"Left out, because no participant chose a term: 1.2 N.",
                                                   "Left out, because they chose no term: 'P5'."}));
}

TEST(Agreement, OneRaterHasNoneAndNeverNaN) {
  const auto data =
      agreementData(std::vector<VoteCounts>{{0.1, {1, 0}}, {0.2, {0, 1}}}, std::vector<std::string>{"low", "high"});
  const auto result = agreement(data);
  EXPECT_FALSE(result.fleiss_kappa);
  EXPECT_FALSE(result.alpha_ordinal);
  EXPECT_FALSE(result.kendall_w);
  EXPECT_FALSE(result.items[0]);
}

Answer answered(const char* who, const char* form, int item, const char* term) {
  return {who, form, item, term, Answer::Status::kAnswered};
}

study::Form smallForm() {
  study::Form form;
  form.id = "form-1";
  form.answers = {{"Low", "low"}, {"High", "high"}};
  form.items = {{1, "first", {}}, {2, "second", {}}, {3, "third", {}}};
  return form;
}

TEST(AgreementData, OnlyAnsweredItemsAreRatings) {
  const std::vector<Answer> answers{answered("A", "form-1", 2, "high"),
                                    answered("B", "form-1", 2, "low"),
                                    answered("A", "form-1", 1, "low"),
                                    {"B", "form-1", 1, "low", Answer::Status::kCleared},
                                    {"A", "form-1", 3, "", Answer::Status::kSkipped},
                                    {"B", "form-1", 3, "", Answer::Status::kCantTell},
                                    {"C", "form-1", 1, "", Answer::Status::kSkipped}};
  const std::vector<study::Form> forms{smallForm()};
  const auto data = agreementData(answers, "", forms, kTerms);
  ASSERT_TRUE(data) << data.error().message();
  EXPECT_EQ(data->terms, (std::vector<std::string>{"low", "high"})) << "the form's own";
  ASSERT_EQ(data->units.size(), 2);
  EXPECT_EQ(data->units[0].name, "item 1");
  EXPECT_EQ(data->units[1].text, "second");
  EXPECT_EQ(data->counts.units, (std::vector<std::vector<int>>{{1, 0}, {1, 1}}));
  EXPECT_EQ(data->ratings->at(1, 0), 1U);
  EXPECT_EQ(data->notes, (std::vector<std::string>{"Left out, because no participant chose a term: item 3.",
                                                   "Left out, because they chose no term: 'C'."}));
}

TEST(AgreementData, TakesOneFormAndNamesTheOthers) {
  const std::vector<Answer> answers{answered("A", "other", 7, "small"), answered("A", "form-1", 1, "low"),
                                    answered("B", "form-1", 1, "high")};
  const std::vector<study::Form> forms{smallForm()};
  const auto most = agreementData(answers, "", forms, kTerms);
  ASSERT_TRUE(most);
  EXPECT_EQ(most->form, "form-1");
  ASSERT_FALSE(most->notes.empty());
  EXPECT_NE(most->notes[0].find("'other' (1 rating)"), std::string::npos) << most->notes[0];
  const auto other = agreementData(answers, "other", forms, kTerms);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->terms, kTerms);
  EXPECT_EQ(other->units[0].name, "item 7");
  EXPECT_NE(other->notes[1].find("'other' is not known here"), std::string::npos);
}

TEST(AgreementData, RefusesWhatCannotBeCompared) {
  const std::vector<study::Form> forms{smallForm()};
  const auto message = [&forms](const std::vector<Answer>& answers, std::string_view form = {}) {
    const auto data = agreementData(answers, form, forms, kTerms);
    return data ? std::string("no error") : data.error().message();
  };
  EXPECT_EQ(message({}), "answers: found no row, wanted answers to a form");
  EXPECT_EQ(message({answered("A", "form-1", 1, "low")}, "x"),
            "answers: found no row of form 'x', wanted answers to a form (there are: 'form-1')");
  EXPECT_EQ(message({answered("A", "form-1", 1, "medium")}),
            "answer of participant A to item 1 of form form-1: found 'medium', wanted one of low, high");
  EXPECT_EQ(message({answered("A", "form-1", 9, "low")}),
            "answer of participant A to item 9 of form form-1: found item 9, which form form-1 does not have, wanted "
            "one of its 3 items");
  EXPECT_EQ(message({answered("A", "form-1", 1, "low"), answered("A", "form-1", 1, "low")}),
            "answer of participant A to item 1 of form form-1: found item 1 of participant A again, wanted one answer "
            "per participant and item");
}

}  // namespace
}  // namespace tactus::elicitation
