#include "app/workbench/participant/screens/about_you_screen.h"

namespace tactus::workbench::nurse {

using AboutQuestion = AboutYouState::Question;

namespace {

QString questionId(AboutQuestion question) {
  switch (question) {
    case AboutQuestion::kYears: return QStringLiteral("you.years");
    case AboutQuestion::kHand: return QStringLiteral("you.hand");
    case AboutQuestion::kGloves: return QStringLiteral("you.gloves");
    case AboutQuestion::kHaptic: return QStringLiteral("you.haptic");
    case AboutQuestion::kComfort: break;
  }
  return QStringLiteral("you.comfort");
}

QStringList idsOf(AboutQuestion question) {
  switch (question) {
    case AboutQuestion::kYears:
      return {QStringLiteral("years_1"), QStringLiteral("years_2"), QStringLiteral("years_3"),
              QStringLiteral("years_4")};
    case AboutQuestion::kHand: return {QStringLiteral("left"), QStringLiteral("right"), QStringLiteral("both")};
    case AboutQuestion::kHaptic:
      return {QStringLiteral("haptic_0"), QStringLiteral("haptic_1"), QStringLiteral("haptic_2")};
    case AboutQuestion::kGloves:
    case AboutQuestion::kComfort: break;
  }
  return {QStringLiteral("yes"), QStringLiteral("no")};
}

}  // namespace

std::vector<Answer> answersTo(AboutQuestion question) {
  std::vector<Answer> answers;
  const QString prefix = question == AboutQuestion::kHand ? QStringLiteral("you.hand_") : QStringLiteral("you.");
  for (const QString& id : idsOf(question)) answers.push_back({id, phrase(prefix + id)});
  // Which hand guides the tube must be known: the picture and the device follow it.
  if (question != AboutQuestion::kHand)
    answers.push_back({QStringLiteral("not_say"), phrase(QStringLiteral("you.not_say")), {}, true});
  return answers;
}

AboutYouScreen::AboutYouScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      lead_(texts_->add(TextRole::kLead, phrase(QStringLiteral("you.years")))),
      unwell_(texts_->add(TextRole::kBody, phrase(QStringLiteral("you.comfort_no")))),
      choices_(new Choices(look, this)) {
  setTitle(phrase(QStringLiteral("you.title")));
  setMain(texts_);
  setAnswers(choices_);
  primaryButton().reserve(phrase(QStringLiteral("err.answer")));
  setState({});
}

void AboutYouScreen::setState(const ParticipantState& state) {
  const AboutYouState& asked = state.about;
  lead_->setPhrase(phrase(questionId(asked.question)));
  unwell_->setVisible(asked.question == AboutQuestion::kComfort && asked.chosen == QLatin1String("no"));
  choices_->setAnswers(answersTo(asked.question));
  choices_->choose(asked.chosen);
  primaryButton().waitFor(asked.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.answer"))) : std::nullopt);
  ScreenFrame::setState(state);
}

}  // namespace tactus::workbench::nurse
