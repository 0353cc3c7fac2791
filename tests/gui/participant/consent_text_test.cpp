// What a participant agrees to follows from the protocol, and no person sits down before somebody said whose study it
// is.
#include "app/workbench/participant/consent_text.h"

#include <gtest/gtest.h>

#include "core/study/record_id.h"

namespace tactus::workbench {
namespace {

using nurse::Language;
using session::Block;

ParticipantPlan planOf(std::vector<Block> blocks) {
  ParticipantPlan plan;
  plan.settings.blocks = std::move(blocks);
  plan.languages = {QStringLiteral("en"), QStringLiteral("zh-Hant")};
  plan.protocol = study::RecordIds(1).next();
  plan.consent_texts = {{QStringLiteral("en"), QStringLiteral("Run by the School of Nursing.\nApproved: 17/2026.")},
                        {QStringLiteral("zh-Hant"), QStringLiteral("本研究由護理學院進行。")}};
  plan.contact = QStringLiteral("Dr. Lee, 2766 0000");
  return plan;
}

std::string textOf(const ParticipantPlan& plan, bool usability = false, const Language& language = Language::kEnglish) {
  return consentText(plan, consentParagraphs(plan, language, usability), language).toStdString();
}

bool says(const std::string& text, const char* what) { return text.find(what) != std::string::npos; }

TEST(ConsentText, NamesMovementsOnlyWhereTheyAreRecorded) {
  for (const auto& blocks : std::vector<std::vector<Block>>{{Block::kSpeed}, {Block::kForce, Block::kForm}}) {
    EXPECT_TRUE(says(textOf(planOf(blocks)), "the movements of the device"));
  }
  const std::string questions = textOf(planOf({Block::kForm}));
  EXPECT_FALSE(says(questions, "the movements of the device"));
  EXPECT_FALSE(says(questions, "You will move"));
  for (const char* stored :
       {"years of experience", "the hand you use", "gloves", "how long they took", "the researcher notes"}) {
    EXPECT_TRUE(says(questions, stored)) << stored;
  }
  const std::string teacher = textOf(planOf({Block::kForm}), true);
  EXPECT_FALSE(says(teacher, "device"));
}

TEST(ConsentText, TheLargestForceAndTheMinutesAreTheProtocols) {
  ParticipantPlan plan = planOf({Block::kForm});
  // 45 items of 10 s and 5 min: 12.5 min, upwards to 15.
  EXPECT_EQ(minutesOf(plan), 15);
  EXPECT_TRUE(says(textOf(plan), "about 15 minutes"));
  plan.force_cap_n = 0.5;  // 51 g
  EXPECT_TRUE(says(textOf(plan), "about 60 g"));
  EXPECT_GT(minutesOf(planOf({Block::kSpeed, Block::kForce, Block::kForm})), minutesOf(plan));
}

TEST(ConsentText, TheStudysTextAndWhomToAskStandBelow) {
  const ParticipantPlan plan = planOf({Block::kForm});
  const auto paragraphs = consentParagraphs(plan, Language::kEnglish, false);
  ASSERT_GE(paragraphs.size(), 4U);
  EXPECT_EQ(paragraphs[paragraphs.size() - 3].plain, QStringLiteral("Run by the School of Nursing."));
  EXPECT_EQ(paragraphs[paragraphs.size() - 2].plain, QStringLiteral("Approved: 17/2026."));
  EXPECT_TRUE(says(textOf(plan), "Dr. Lee, 2766 0000"));
  const std::string chinese = textOf(plan, false, Language::kTraditionalChinese);
  EXPECT_TRUE(says(chinese, "本研究由護理學院進行。"));
  EXPECT_FALSE(says(chinese, "School"));
}

TEST(ConsentText, OtherStatementsReplaceTheGeneralOnesInTheirLanguage) {
  ParticipantPlan plan = planOf({Block::kForm});
  plan.statements[QStringLiteral("en")] = QStringLiteral("As our committee worded it.");
  EXPECT_TRUE(textOf(plan).starts_with("As our committee worded it.\nRun by"));
  EXPECT_FALSE(says(textOf(plan, false, Language::kTraditionalChinese), "committee"));
}

TEST(ConsentText, WithoutATextOrAContactNoPersonSitsDown) {
  ParticipantPlan plan = planOf({Block::kForm});
  EXPECT_EQ(whyNoSession(plan), QString());
  plan.contact.clear();
  EXPECT_TRUE(whyNoSession(plan).contains(QStringLiteral("ask")));
  plan = planOf({Block::kForm});
  plan.consent_texts.erase(QStringLiteral("zh-Hant"));
  EXPECT_TRUE(whyNoSession(plan).contains(QStringLiteral("no text of the study")));
  plan = ParticipantPlan{};
  EXPECT_TRUE(whyNoSession(plan).contains(QStringLiteral("no protocol")));
  plan.simulated = true;
  EXPECT_EQ(whyNoSession(plan), QString()) << "a program needs no consent";
}

}  // namespace
}  // namespace tactus::workbench
