#include "app/workbench/participant/screens/about_you_screen.h"

namespace tactus::workbench::nurse {
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
      choices_(new Choices(look, this)) {
  setTitle(phrase(QStringLiteral("you.title")));
  setMain(texts_);
  setAnswers(choices_);
  primaryButton().reserve(phrase(QStringLiteral("err.answer")));
  connect(choices_, &Choices::picked, this, &AboutYouScreen::picked);
  connect(this, &ScreenFrame::primary, this, [this] { emit confirmed(state_.question); });
  setState({});
}

void AboutYouScreen::setState(const AboutYouState& state) {
  state_ = state;
  lead_->setPhrase(phrase(questionId(state.question)));
  choices_->setAnswers(answersTo(state.question));
  choices_->choose(state.chosen);
  primaryButton().waitFor(state.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.answer"))) : std::nullopt);
  setSimulated(state.simulated);
}

}  // namespace tactus::workbench::nurse
