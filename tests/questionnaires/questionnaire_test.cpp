#include "questionnaires/questionnaire.h"

#include <gtest/gtest.h>
#include <set>

#include "questionnaires/form_file.h"

#include "tests/support/default_procedure.h"

namespace tactus::questionnaires {
namespace {

TEST(Questionnaire, EveryFormComesInEachOfItsLanguages) {
  for (const auto& id : questionnaireIds(support::defaultProcedure())) {
    const auto languages = languagesOf(support::defaultProcedure(), id);
    ASSERT_FALSE(languages.empty());
    EXPECT_EQ(languages.front(), "en");
    const auto printed = questionnaire(support::defaultProcedure(), id, "en");
    ASSERT_TRUE(printed.has_value());
    for (const auto& language : languages) {
      const auto worded = questionnaire(support::defaultProcedure(), id, language);
      ASSERT_TRUE(worded.has_value()) << worded.error().message();
      EXPECT_EQ(worded->language, language);
      EXPECT_EQ(worded->form, printed->form);
      EXPECT_EQ(worded->version, printed->version);
      ASSERT_EQ(worded->questions.size(), printed->questions.size());
      ASSERT_EQ(worded->choices.size(), printed->choices.size());
      std::set<std::string> texts;
      for (std::size_t i = 0; i < printed->questions.size(); ++i) {
        EXPECT_EQ(worded->questions[i].number, printed->questions[i].number);
        EXPECT_TRUE(texts.insert(worded->questions[i].text).second) << worded->questions[i].text << " twice";
      }
      for (std::size_t i = 0; i < printed->choices.size(); ++i) {
        EXPECT_EQ(worded->choices[i].value, printed->choices[i].value);
      }
    }
  }
}

TEST(Questionnaire, ThePrintedFormHasThePapersWords) {
  const auto form = questionnaire(support::defaultProcedure(), "ngt-force-v1", "en", "published");
  ASSERT_TRUE(form.has_value());
  EXPECT_EQ(form->wording, "published");
  EXPECT_EQ(form->questions[0].text,
            "IF Tube Lubrication IS Poor AND Tube Tip Position IS in Nasal Cavity, THEN Force Change IS:");
  ASSERT_EQ(form->choices.size(), 5U);
  EXPECT_EQ(form->choices[4], (Choice{"very_large", "Very Large"}));
}

TEST(Questionnaire, PlainWordsSayTheSameCondition) {
  const auto form = questionnaire(support::defaultProcedure(), "ngt-force-v1", "en");
  ASSERT_TRUE(form.has_value());
  EXPECT_EQ(form->wording, "plain");
  EXPECT_EQ(form->questions[0].text,
            "The tube is poorly lubricated. The tip of the tube is in the nasal cavity. How large is the force?");
  ASSERT_NE(form->choice("medium"), nullptr);
  EXPECT_EQ(form->choice("medium")->label, "Medium");
  EXPECT_EQ(form->choice("Medium"), nullptr);
}

// The sentences of facts/participant.md 2: the condition, the depth, the question, joined by nothing.
TEST(Questionnaire, ChineseSentencesAreJoinedByNothingWithTheDepthBehind) {
  const auto traditional = questionnaire(support::defaultProcedure(), "ngt-force-v1", "zh-Hant");
  ASSERT_TRUE(traditional.has_value());
  ASSERT_EQ(traditional->questions.size(), 45U);
  EXPECT_EQ(traditional->questions[3].text, "管身潤滑不足，鼻胃管前端位於喉咽（下咽）。您手上感受到的阻力有多大？");
  const auto simplified = questionnaire(support::defaultProcedure(), "ngt-force-v1", "zh-Hans");
  ASSERT_TRUE(simplified.has_value());
  EXPECT_EQ(simplified->questions[3].text, "管身润滑不足，鼻胃管前端位于喉咽（下咽）。您手上感受到的阻力有多大？");
  EXPECT_EQ(simplified->choice("very_large")->label, "非常大");
  for (const auto& form : {*traditional, *simplified}) {
    EXPECT_EQ(form.remark, "A translation that no nurse has reviewed yet.");
    for (const auto& question : form.questions) {
      EXPECT_EQ(question.text.find(' '), std::string::npos) << question.text;
      // The condition ends in a comma, the depth in a full stop: in this order they are one sentence.
      EXPECT_LT(question.text.find("，"), question.text.find("。")) << question.text;
    }
  }
}

// Characters of the Traditional texts that Simplified Chinese writes in another way.
TEST(Questionnaire, NoTraditionalCharacterIsInTheSimplifiedWording) {
  const std::vector<std::string> traditional = {"個", "學", "實", "對", "擬", "於", "時", "標", "沒", "況", "準", "潤",
                                                "為", "畫", "練", "習", "見", "訓", "詞", "話", "課", "請", "護", "輔",
                                                "過", "選", "針", "錯", "頸", "後", "會", "厭", "顎", "聲", "氣"};
  for (const char* id : {"ngt-force-v1", "usability-v1"}) {
    const auto form = questionnaire(support::defaultProcedure(), id, "zh-Hans");
    ASSERT_TRUE(form.has_value());
    std::string all = form->title + form->instructions;
    for (const auto& question : form->questions) all += question.text;
    for (const auto& choice : form->choices) all += choice.label;
    for (const auto& character : traditional) {
      EXPECT_EQ(all.find(character), std::string::npos) << character;
    }
  }
}

TEST(Questionnaire, AScaleNamesItsEnds) {
  const auto form = questionnaire(support::defaultProcedure(), "usability-v1", "en");
  ASSERT_TRUE(form.has_value());
  ASSERT_EQ(form->choices.size(), 7U);
  EXPECT_EQ(form->choices.front(), (Choice{"1", "strongly disagree"}));
  EXPECT_EQ(form->choices[3], (Choice{"4", ""}));
  EXPECT_EQ(form->choices.back(), (Choice{"7", "strongly agree"}));
  ASSERT_EQ(form->questions.size(), 6U);
  EXPECT_EQ(form->questions[2].text, "The insertion forces of the simulator are realistic.");
}

TEST(Questionnaire, UnknownOnesAreRefusedWithTheKnown) {
  const auto form = questionnaire(support::defaultProcedure(), "ngt-force-v9", "en");
  ASSERT_FALSE(form.has_value());
  EXPECT_NE(form.error().message().find("ngt-force-v1, usability-v1"), std::string::npos) << form.error().message();
  const auto language = questionnaire(support::defaultProcedure(), "usability-v1", "fr");
  ASSERT_FALSE(language.has_value());
  EXPECT_NE(language.error().message().find("en, de"), std::string::npos) << language.error().message();
  EXPECT_TRUE(languagesOf(support::defaultProcedure(), "other").empty());
  EXPECT_EQ(languagesOf(support::defaultProcedure(), "ngt-force-v1", "published"), std::vector<std::string>{"en"});
  for (const auto& unknown : {questionnaire(support::defaultProcedure(), "ngt-force-v1", "en", "plainer"),
                              questionnaire(support::defaultProcedure(), "usability-v1", "en", "plain")})
    EXPECT_FALSE(unknown.has_value());
  EXPECT_FALSE(questionnaire(support::defaultProcedure(), "ngt-force-v1", "zh-Hant", "published").has_value());
}

constexpr std::string_view kHalfAWording = R"({"format": "tactus-form-wording", "form": "ngt-force-v1",
  "form_version": 1, "wording": "plain", "language": "xx", "title": "t", "instructions": "i", "question": "?",
  "phrases": {"lubrication": {"poor": "P."}, "depth": {"nasal_cavity": "N."}},
  "answers": {"very_small": "1", "small": "2", "medium": "3", "large": "4", "very_large": "5"}})";

TEST(Wording, EveryItemNeedsWords) {
  const auto wording = parseWording(kHalfAWording, "xx.json");
  ASSERT_TRUE(wording.has_value()) << wording.error().message();
  const auto form = inWords(support::ngtForceForm(), *wording, "depth");
  ASSERT_FALSE(form.has_value());  // item 2 asks about the nasopharynx
  EXPECT_NE(form.error().message().find("item 2"), std::string::npos) << form.error().message();
}

TEST(Wording, BelongsToOneFormAndVersion) {
  auto wording = parseWording(kHalfAWording, "xx.json");
  ASSERT_TRUE(wording.has_value());
  EXPECT_FALSE(inWords(usabilityForm(), *wording).has_value());
  wording->version = 2;
  const auto form = inWords(support::ngtForceForm(), *wording, "depth");
  ASSERT_FALSE(form.has_value());
  EXPECT_NE(form.error().message().find("version 2"), std::string::npos) << form.error().message();
}

TEST(Wording, BrokenFilesAreRefusedWithTheirPlace) {
  const auto refused = [](std::string_view text, std::string_view what) {
    const auto wording = parseWording(text, "w.json");
    ASSERT_FALSE(wording.has_value()) << text;
    EXPECT_NE(wording.error().message().find(what), std::string::npos) << wording.error().message();
    EXPECT_EQ(wording.error().file, "w.json");
  };
  refused("{", "line 1, column 2");
  refused(R"({"format": "tactus-form-wording", "form": "f", "from": 1})", "'language'");
  refused(R"({"format": "tactus-form"})", "tactus-form-wording");
  refused(R"({"format": "tactus-form-wording", "form": "f"})", "'language'");
  const std::string head =
      R"({"format": "tactus-form-wording", "form": "f", "form_version": 1, "wording": "plain", "language": "l", "title": "t", "instructions": "i")";
  refused(head + "}", "'phrases'");
  refused(head + R"(, "items": [{"number": 1, "text": "a"}]})", "'answers'");
  refused(head + R"(, "items": [{"number": 1, "text": "a"}, {"number": 1, "text": "b"}], "answers": {}})",
          "/items/1/number");
  refused(head + R"(, "phrases": {"depth": {"nose": 3}}, "answers": {}})", "/phrases/depth/nose");
}

}  // namespace
}  // namespace tactus::questionnaires
