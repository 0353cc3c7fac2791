#include "app/workbench/base/display_text.h"

#include <gtest/gtest.h>

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

TEST(DisplayText, NumbersHaveAPointAndNoZerosAtTheEnd) {
  EXPECT_EQ(numberText(1.25), QStringLiteral("1.25"));
  EXPECT_EQ(numberText(30), QStringLiteral("30"));
  EXPECT_EQ(numberText(0.5, 4), QStringLiteral("0.5"));
  EXPECT_EQ(numberText(-0.001), QStringLiteral("0"));
}

TEST(DisplayText, AForceHasThreeDigitsAndNoSignAtZero) {
  EXPECT_EQ(forceText(0.4684, "N"), QStringLiteral("0.468 N"));
  EXPECT_EQ(forceText(-0.2, "N"), QStringLiteral("-0.200 N"));
  EXPECT_EQ(forceText(-0.0004, "N"), QStringLiteral("0.000 N"));
}

TEST(DisplayText, ARatioHasNoUnit) {
  EXPECT_EQ(quantityText(0.5, "1"), QStringLiteral("0.5"));
  EXPECT_EQ(quantityText(30, "mm/s"), QStringLiteral("30 mm/s"));
}

TEST(DisplayText, OutsideTextTurnsNoSentenceAround) {
  const QString evil = QStringLiteral("/home/a/n\u202Excod.\u2066\n\u009B.tactus");
  EXPECT_EQ(shownFileName(evil), QStringLiteral("n\\u202excod.\\u2066\\x0a\\u009b.tactus"));
  EXPECT_EQ(shownFileName(QStringLiteral("/home/a/größe – 1.tactus")), QStringLiteral("größe – 1.tactus"));
}

TEST(DisplayText, MembershipsOfAValue) {
  const fuzzy::ForceModel model = tests::twoExperts();
  EXPECT_EQ(membershipText(model.inputs[0].terms, 45), QStringLiteral("Slow 0.75 · Fast 0.25"));
  EXPECT_EQ(membershipText(model.inputs[1].terms, 5.5), QString());
}

}  // namespace
}  // namespace tactus::workbench
