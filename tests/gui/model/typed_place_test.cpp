#include <gtest/gtest.h>

#include "app/workbench/model/places.h"

#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

class TypedPlaceTest : public testing::Test {
 protected:
  std::optional<TypedPlace> at(const char* typed) const {
    return typedPlace(QString::fromUtf8(typed), model, std::vector{0.5, 45.0, 300.0, 30.0});
  }
  fuzzy::ForceModel model = support::ngtVariables();
};

TEST_F(TypedPlaceTest, NumbersWithUnitsAndTermsInAnyOrder) {
  // Poor is fully true from 0 to 0.2.
  const auto place = at("130 mm poor, neck flexion 90");
  ASSERT_TRUE(place);
  EXPECT_EQ(place->point, (std::vector{0.1, 90.0, 130.0, 30.0}));
  EXPECT_EQ(place->words.join(QStringLiteral(" · ")),
            QStringLiteral("Depth 130 mm · Lubrication poor · Neck flexion 90 deg"));
  EXPECT_EQ(at("POOR 130mm")->point, (std::vector{0.1, 45.0, 130.0, 30.0}));
  EXPECT_EQ(at("50 mm/s 12,5 mm")->point, (std::vector{0.5, 45.0, 12.5, 50.0}));
  EXPECT_EQ(at("depth 130")->point, (std::vector{0.5, 45.0, 130.0, 30.0}));
  // A term of several words.
  EXPECT_EQ(at("nasal cavity poor")->point[2], at("nasal_cavity, poor")->point[2]);
}

TEST_F(TypedPlaceTest, ATermOfSeveralInputsNeedsTheInputsName) {
  EXPECT_FALSE(at("130 mm medium"));
  // Medium lubrication is fully true from 0.4 to 0.6.
  EXPECT_EQ(at("130 mm lubrication medium")->point[0], 0.5);
  EXPECT_EQ(at("130 mm medium lubrication")->point, at("130 mm lubrication medium")->point);
}

TEST_F(TypedPlaceTest, WhatIsNoPlaceIsNone) {
  for (const char* typed : {"", "poor", "130", "open", "130 mm open", "130 mm 140 mm", "9999 mm",
                            "poor 0.1 lubrication", "depth", "poor depth", "130 kg poor"}) {
    EXPECT_FALSE(at(typed)) << typed;
  }
}

}  // namespace
}  // namespace tactus::workbench
