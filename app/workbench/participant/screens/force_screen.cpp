#include "app/workbench/participant/screens/force_screen.h"

#include <QKeyEvent>

namespace tactus::workbench::nurse {
namespace {

constexpr double kPushMm = 26;

}  // namespace

ForceScreen::ForceScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      push_(new PictureBox(look, 2 * kPushMm, kPushMm, texts_)),
      practice_(nullptr),
      lead_(nullptr),
      hint_(nullptr),
      choices_(new Choices(look, this)),
      feel_again_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("nav.feel_again")), this)) {
  push_->setPicture(pushPicture());
  texts_->add(push_);
  lead_ = texts_->add(TextRole::kLead, phrase(QStringLiteral("for.do")));
  hint_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("for.nothing")));
  practice_ = texts_->add(TextRole::kMuted, phrase(QStringLiteral("pra.line")));
  texts_->center();
  setMain(texts_);
  setAnswers(choices_);
  addExtra(feel_again_);
  choices_->setAnswers(forceWords());
  backButton().hide();
  primaryButton().setPhrase(phrase(QStringLiteral("nav.confirm")));
  primaryButton().reserve(phrase(QStringLiteral("err.choose")));
  connect(choices_, &Choices::picked, this, &ForceScreen::picked);
  connect(feel_again_, &QAbstractButton::clicked, this, &ForceScreen::feelAgain);
  connect(this, &ScreenFrame::primary, this, &ForceScreen::confirmed);
  setState({});
}

void ForceScreen::setState(const ForceState& state) {
  state_ = state;
  const bool answering = state.step == JudgingPhase::kAnswer;
  // In the practice she felt it and asks for the next one.
  const bool between = answering && !state.asks;
  setTitle(state.practice
               ? phrase(QStringLiteral("pra.title"))
               : phrase(QStringLiteral("for.title"), {QString::number(state.part), QString::number(state.parts)}));
  practice_->setVisible(state.practice && !between);
  QString sentence = QStringLiteral("for.ask");
  if (state.step == JudgingPhase::kPause)
    sentence = state.warm ? QStringLiteral("dev.warm") : QStringLiteral("for.pause");
  if (between) sentence = QStringLiteral("pra.line");
  if (state.step == JudgingPhase::kFeel)
    sentence = state.again ? QStringLiteral("for.again") : QStringLiteral("for.do");
  lead_->setPhrase(phrase(sentence));
  push_->setVisible(state.step == JudgingPhase::kFeel);
  hint_->setPhrase(phrase(state.before ? QStringLiteral("for.before") : QStringLiteral("for.nothing")));
  hint_->setVisible((state.step == JudgingPhase::kFeel && state.practice) || (answering && state.before));
  choices_->setVisible(answering && state.asks);
  choices_->choose(state.chosen);
  choices_->light(state.lit);
  feel_again_->setVisible(answering && state.may_feel_again && !state.before);
  primaryButton().setVisible(answering);
  primaryButton().setPhrase(phrase(state.asks ? QStringLiteral("nav.confirm") : QStringLiteral("nav.next")));
  primaryButton().waitFor(state.asks && state.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.choose")))
                                                               : std::nullopt);
  setFreeHandLeft(!state.left_handed);
  setSimulated(state.simulated);
}

void ForceScreen::keyPressEvent(QKeyEvent* event) {
  if (state_.step != JudgingPhase::kAnswer || !state_.asks || event->isAutoRepeat())
    return ScreenFrame::keyPressEvent(event);
  QString word;
  if (event->key() >= Qt::Key_1 && event->key() <= Qt::Key_5) word = choices_->onScale(event->key() - Qt::Key_0);
  if (event->key() == Qt::Key_0) word = QStringLiteral("not_felt");
  if (event->key() == Qt::Key_9) word = QStringLiteral("beyond_practice");
  if (!word.isEmpty()) {
    emit picked(word);
  } else if (event->key() == Qt::Key_F) {
    if (feel_again_->isVisible()) emit feelAgain();
  } else {
    ScreenFrame::keyPressEvent(event);
  }
}

}  // namespace tactus::workbench::nurse
