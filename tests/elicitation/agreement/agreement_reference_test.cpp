// Made-up questionnaires against other programs: tests/golden/agreement/README.md.
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "elicitation/agreement/agreement.h"
#include "elicitation/agreement/krippendorff_alpha.h"

namespace tactus::elicitation {
namespace {

using nlohmann::json;

// A few hundred additions in another order.
constexpr double kRounding = 1e-12;

Ratings ratingsFrom(const json& one) {
  const auto& rows = one.at("ratings");
  Ratings out(rows.size(), rows.at(0).size(), one.at("categories"));
  for (std::size_t unit = 0; unit < rows.size(); ++unit) {
    for (std::size_t rater = 0; rater < rows[unit].size(); ++rater) {
      if (!rows[unit][rater].is_null()) out.set(unit, rater, rows[unit][rater]);
    }
  }
  return out;
}

TEST(AgreementReference, OtherProgramsGiveTheSame) {
  std::ifstream file(TACTUS_GOLDEN_DIR "/agreement/cases.json");
  const json golden = json::parse(file);
  ASSERT_GE(golden.at("cases").size(), 10);
  int kappas = 0;
  int concordances = 0;
  for (const auto& one : golden.at("cases")) {
    SCOPED_TRACE(std::to_string(one.at("ratings").size()) + " units of " + std::to_string(one.at("ratings")[0].size()));
    const Ratings ratings = ratingsFrom(one);
    const auto counts = countRatings(ratings);
    const auto& alpha = one.at("krippendorff_alpha");
    EXPECT_NEAR(krippendorffAlpha(counts, AlphaLevel::kNominal).value(), alpha.at("nominal"), kRounding);
    EXPECT_NEAR(krippendorffAlpha(counts, AlphaLevel::kOrdinal).value(), alpha.at("ordinal"), kRounding);
    EXPECT_NEAR(krippendorffAlpha(counts, AlphaLevel::kInterval).value(), alpha.at("interval"), kRounding);
    const auto kappa = fleissKappa(counts);
    EXPECT_EQ(kappa.has_value(), !one.at("fleiss_kappa").is_null());
    if (kappa) {
      EXPECT_NEAR(kappa->kappa, one.at("fleiss_kappa"), kRounding);
      ++kappas;
    }
    const auto& kendall = one.at("kendall");
    if (kendall.is_null()) continue;
    const auto w = kendallW(ratings);
    ASSERT_TRUE(w);
    EXPECT_NEAR(w->w, kendall.at("w"), kRounding);
    EXPECT_NEAR(w->chi_square / kendall.at("chi_square").get<double>(), 1, kRounding);
    EXPECT_NEAR(w->p / kendall.at("p").get<double>(), 1, 1e-10);  // a tail of 1e-93 from logarithms
    EXPECT_EQ(w->units, kendall.at("units"));
    ++concordances;
  }
  EXPECT_GE(kappas, 5);
  EXPECT_GE(concordances, 10);
}

}  // namespace
}  // namespace tactus::elicitation
