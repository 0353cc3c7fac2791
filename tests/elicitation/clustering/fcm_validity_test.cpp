#include "elicitation/clustering/fcm_validity.h"

#include <gtest/gtest.h>

#include "elicitation/clustering/fcm.h"

#include "tests/elicitation/clustering/fcm_cases.h"

namespace tactus::elicitation {
namespace {

TEST(FcmValidity, AgreesWithTheReference) {
  int cases = 0;
  for (const auto& one : readFcmCases()) {
    if (!one.contains("validity")) continue;
    const std::string title = one.at("name");
    SCOPED_TRACE(title);
    ++cases;
    const auto& wanted = one.at("validity");
    const auto found = fcmValidity(readFirstColumn(one.at("file")), one.at("centres").get<std::vector<double>>(),
                                   one.at("m").get<double>());
    // Sums of up to 24,000 terms of one sign; at the offset of 1e9 the centers themselves are good to 1e-7 of 60.
    const double tolerance = title == "offset_1e9" ? 1e-8 : 1e-11;
    EXPECT_NEAR(found.partition_coefficient, wanted.at("PC").get<double>(), tolerance);
    EXPECT_NEAR(found.partition_entropy, wanted.at("PE_nat").get<double>(), tolerance);
    EXPECT_NEAR(found.modified_coefficient.value(), wanted.at("MPC").get<double>(), tolerance);
    EXPECT_NEAR(found.xie_beni.value(), wanted.at("XB").get<double>(), tolerance);
    EXPECT_NEAR(found.fuzzy_silhouette.value(), wanted.at("SIL_F_alpha1").get<double>(), tolerance);
    EXPECT_NEAR(found.crisp_silhouette.value(), wanted.at("SIL_crisp").get<double>(), tolerance);
    EXPECT_EQ(found.sizes, wanted.at("hard_sizes").get<std::vector<std::size_t>>());
  }
  EXPECT_EQ(cases, 15);
}

TEST(FcmValidity, CrispClustersByHand) {
  // Clusters {0, 2} and {10}: silhouettes (10-2)/10, (8-2)/8 and, alone in its cluster, 0. Memberships of centers
  // 1, 10.
  const std::vector<double> samples{0, 2, 10};
  const std::vector<double> centres{1, 10};
  const auto found = fcmValidity(samples, centres, 2);
  EXPECT_DOUBLE_EQ(found.crisp_silhouette.value(), (0.8 + 0.75) / 3);
  // u = 100/101 and 64/65 for the nearer center, so differences 99/101, 63/65 and 1.
  EXPECT_DOUBLE_EQ(found.fuzzy_silhouette.value(), (0.8 * 99 / 101 + 0.75 * 63 / 65) / (99.0 / 101 + 63.0 / 65 + 1));
  EXPECT_EQ(found.sizes, (std::vector<std::size_t>{2, 1}));
}

TEST(FcmValidity, OneClusterHasNothingToCompare) {
  const auto found = fcmValidity(std::vector<double>{1, 2, 3}, std::vector<double>{2}, 2);
  EXPECT_EQ(found.partition_coefficient, 1);
  EXPECT_EQ(found.partition_entropy, 0);
  EXPECT_FALSE(found.xie_beni);
  EXPECT_FALSE(found.crisp_silhouette);
}

}  // namespace
}  // namespace tactus::elicitation
