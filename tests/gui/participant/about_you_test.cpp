#include <gtest/gtest.h>

#include "app/workbench/participant/questions.h"

namespace tactus::workbench {
namespace {

using Question = AboutYouState::Question;

void answer(AboutYou& about, const char* id) {
  about.choose(QLatin1String(id));
  about.next();
}

TEST(AboutYou, OneQuestionAfterAnotherGivesTheProfile) {
  AboutYou about;
  EXPECT_TRUE(about.state().chosen.isEmpty()) << "nothing is chosen at the start";
  about.next();
  EXPECT_EQ(about.state().question, Question::kYears) << "not without an answer";
  answer(about, "years_2");
  answer(about, "left");
  answer(about, "yes");
  answer(about, "haptic_1");
  EXPECT_EQ(about.state().question, Question::kComfort);
  EXPECT_TRUE(about.isLast());
  about.choose(QStringLiteral("no"));
  const study::ProfileRecord profile = about.profile();
  ASSERT_TRUE(about.experience());
  EXPECT_EQ(about.experience()->middle_years, 7.5);  // of 5 to 10
  EXPECT_EQ(profile.handedness, "left");
  EXPECT_EQ(profile.gloves, "yes");
  EXPECT_EQ(profile.haptic_experience, "some");
  EXPECT_TRUE(about.isLeftHanded());
  EXPECT_EQ(profile.comfort, "not_good");
}

TEST(AboutYou, WhatSheDoesNotSayStaysEmpty) {
  AboutYou about;
  for (int i = 0; i < 5; ++i) answer(about, "not_say");
  const study::ProfileRecord profile = about.profile();
  EXPECT_FALSE(about.experience());
  EXPECT_TRUE(profile.handedness.empty() && profile.gloves.empty() && profile.haptic_experience.empty());
}

TEST(AboutYou, TakesOnlyWhatIsOfferedAndGoesBack) {
  AboutYou about;
  about.choose(QStringLiteral("left"));  // of another question
  EXPECT_FALSE(about.isAnswered());
  answer(about, "years_4");
  about.back();
  EXPECT_EQ(about.state().chosen, QStringLiteral("years_4"));
  answer(about, "years_1");
  EXPECT_EQ(about.experience()->middle_years, 2.5);
}

}  // namespace
}  // namespace tactus::workbench
