// What agreement and the frequency curve of vote print.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/published_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

Json agreementOf(const std::string& text, const std::vector<std::string>& more = {}) {
  const support::TempFolder folder;
  const std::string file = folder.file("table.csv");
  writeText(file, text);
  std::vector<std::string> arguments{"agreement", file, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramRun run(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.status == 0 ? Json::parse(run.out) : Json();
}

std::string errorOf(const std::string& text, const std::vector<std::string>& more = {}) {
  const support::TempFolder folder;
  const std::string file = folder.file("table.csv");
  writeText(file, text);
  std::vector<std::string> arguments{"agreement", file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramRun run(arguments);
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  const auto name = run.err.find(file);
  return name == std::string::npos ? run.err : run.err.substr(name + file.size());
}

const std::string kJudgements =
    "participant,series,step,force_n,term\n"
    "A,ascending,1,0.1,very_small\nA,ascending,2,0.2,small\nA,ascending,3,0.3,large\n"
    "B,ascending,1,0.1,very_small\nB,ascending,2,0.2,medium\nB,ascending,3,0.3,very_large\n"
    "A,ascending,4,0.4,beyond_practice\nB,ascending,4,0.4,\nA,random,1,0.1,small\n";

const std::string kAnswers =
    "participant,form,item,term,status\n"
    "A,ngt-force-v1,1,large,answered\nB,ngt-force-v1,1,very_large,answered\n"
    "A,ngt-force-v1,2,small,answered\nB,ngt-force-v1,2,,cant_tell\nA,other,1,small,answered\n";

TEST(AgreementCommand, Table2HasItsPublishedAgreement) {
  const Json result = agreementOf(std::string(experiments::table2Csv()));
  // Digits of statsmodels and nltk, tests/golden/agreement.
  EXPECT_NEAR(result.at("fleiss_kappa"), 0.09318996415770603, 1e-14);
  EXPECT_NEAR(result.at("krippendorff_alpha").at("nominal"), 0.11379928315412202, 1e-14);
  EXPECT_NEAR(result.at("krippendorff_alpha").at("ordinal"), 0.5514634534319572, 1e-14);
  EXPECT_NEAR(result.at("krippendorff_alpha").at("interval"), 0.6030999651689306, 1e-14);
  EXPECT_TRUE(result.at("kendall_w").is_null());
  EXPECT_TRUE(result.at("reasons").contains("kendall_w"));
  EXPECT_NEAR(result.at("fleiss").at("z"), 1.44, 5e-3);
  EXPECT_EQ(result.at("source"), "counts");
  EXPECT_TRUE(result.at("raters").is_null());
  EXPECT_EQ(result.at("items").size(), 11);
  EXPECT_EQ(result.at("items").at(2).at("spread_terms"), 3);
  EXPECT_EQ(result.at("items").at(2).at("entropy_bits"), 2);
}

TEST(AgreementCommand, JudgementsOfOneSeries) {
  const Json result = agreementOf(kJudgements);
  // Both rank the three forces alike.
  EXPECT_EQ(result.at("kendall_w"), 1);
  EXPECT_EQ(result.at("units"), 3);
  EXPECT_EQ(result.at("raters"), Json({"A", "B"}));
  EXPECT_EQ(result.at("items").at(1).at("votes"), Json({0, 1, 1, 0, 0}));
  EXPECT_EQ(result.at("notes"), Json({"Left out, because no participant chose a term: 0.4 N."}));
  const Json random = agreementOf(kJudgements, {"--series", "random"});
  EXPECT_EQ(random.at("units"), 1);
  EXPECT_TRUE(random.at("fleiss_kappa").is_null());
  EXPECT_TRUE(random.at("krippendorff_alpha").at("ordinal").is_null());
  EXPECT_TRUE(random.at("items").at(0).at("consensus").is_null());
  EXPECT_EQ(random.at("reasons").size(), 3);
}

TEST(AgreementCommand, AnswersToTheFormAnsweredMost) {
  const Json result = agreementOf(kAnswers);
  EXPECT_EQ(result.at("form"), "ngt-force-v1");
  EXPECT_EQ(result.at("ratings"), 3);
  EXPECT_EQ(result.at("items").at(0).at("item"), 1);
  EXPECT_EQ(result.at("items").at(0).at("text").get<std::string>().find("IF Tube Lubrication IS Poor"), 0);
  EXPECT_TRUE(result.at("fleiss_kappa").is_null()) << "one item has one rating";
  EXPECT_EQ(agreementOf(kAnswers, {"--form", "other"}).at("form"), "other");
}

TEST(AgreementCommand, TheTextLeadsWithOrdinalAlphaAndWarnsOfKappa) {
  const support::TempFolder folder;
  const std::string file = folder.file("table2.csv");
  writeText(file, std::string(experiments::table2Csv()));
  const ProgramRun run({"agreement", file});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.find("ordinal Krippendorff alpha  0.5515"), 0U) << run.out;
  EXPECT_LT(run.out.find("0.3 N "), run.out.find("Fleiss' kappa  "));
  EXPECT_NE(run.out.find("Fleiss' kappa               0.0932 (z 1.44, p 0.1501)"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("Fleiss' kappa misleads here"), std::string::npos);
  EXPECT_EQ(run.out.find("nan"), std::string::npos);
}

TEST(AgreementCommand, RefusesInOneSentence) {
  EXPECT_EQ(errorOf("a,b\n1,2\n").find(": header: found the columns 'a', 'b', wanted answers ("), 0U);
  EXPECT_EQ(errorOf(kAnswers + "B,ngt-force-v1,3,huge,answered\n").find(": line 7, column 'term': found 'huge'"), 0U);
  EXPECT_EQ(errorOf(kAnswers, {"--form", "x"}).find(": answers: found no row of form 'x'"), 0U);
  EXPECT_EQ(errorOf(kJudgements, {"--series", "x"}).find(": judgements: found no row of series 'x'"), 0U);
  EXPECT_EQ(ProgramRun({"agreement"}).status, 2);
}

TEST(VoteCommand, SetsTheFrequencyCurveBesideTheVote) {
  const support::TempFolder folder;
  const std::string file = folder.file("judgements.csv");
  writeText(file, kJudgements);
  const ProgramRun run({"vote", file, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json frequency = Json::parse(run.out).at("frequency");
  ASSERT_EQ(frequency.at("shares").size(), 4);
  EXPECT_EQ(frequency.at("shares").at(1).at("shares"), Json({0, 0.5, 0.5, 0, 0}));
  EXPECT_TRUE(frequency.at("shares").at(3).at("shares").is_null()) << "no term was chosen at 0.4 N";
  EXPECT_EQ(frequency.at("terms").at(0).at("id"), "very_small");
  EXPECT_EQ(frequency.at("terms").at(0).at("points").size(), 4);
}

}  // namespace
}  // namespace tactus::cli
