#include "app/workbench/participant/screens/force_screen.h"

#include <QKeyEvent>

#include "app/workbench/participant/screens/device_check_screen.h"

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
      stop_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("for.stop")), this)),
      feel_again_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("nav.feel_again")), this)) {
  push_->setPicture(pushPicture());
  texts_->add(push_);
  lead_ = texts_->add(TextRole::kLead, phrase(QStringLiteral("for.do")));
  hint_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("for.nothing")));
  practice_ = texts_->add(TextRole::kMuted, phrase(QStringLiteral("pra.line")));
  texts_->center();
  setMain(texts_);
  setAnswers(choices_);
  stop_->setCheckable(true);
  addExtra(stop_);
  addExtra(feel_again_);
  choices_->setAnswers(forceWords(look));
  primaryButton().setPhrase(phrase(QStringLiteral("nav.confirm")));
  primaryButton().reserve(phrase(QStringLiteral("err.choose")));
  connect(stop_, &QAbstractButton::clicked, this, [this] { emit picked(QStringLiteral("would_stop")); });
  connect(feel_again_, &QAbstractButton::clicked, this, &ForceScreen::feelAgain);
  setState({});
}

void ForceScreen::setState(const ParticipantState& state) {
  using Phase = ForceState::Phase;
  state_ = state.force;
  const bool practice = state.screen == ParticipantScreen::kPractice;
  const bool feels = state_.phase == Phase::kFeel;
  const bool answering = state_.phase == Phase::kAnswer;
  setTitle(practice ? phrase(QStringLiteral("pra.title"))
                    : phrase(QStringLiteral("for.title"), {QString::number(state.part), QString::number(state.parts)}));
  practice_->setVisible(practice);
  QString sentence = state_.sure ? QStringLiteral("for.sure") : QStringLiteral("for.ask");
  if (state_.phase == Phase::kPause) sentence = state_.warm ? QStringLiteral("dev.warm") : QStringLiteral("for.pause");
  if (feels) sentence = state_.again ? QStringLiteral("for.again") : QStringLiteral("for.do");
  lead_->setPhrase(phrase(sentence));
  push_->setVisible(feels);
  const bool unheld = feels && state.waits != HoldWait::kNot;
  hint_->setPhrase(phrase(state_.waits_for_push ? QStringLiteral("for.push_hint")
                          : unheld              ? holdSentence(state.hold)
                          : state_.before       ? QStringLiteral("for.before")
                                                : QStringLiteral("for.nothing")));
  hint_->setVisible(unheld || (feels && practice) || (answering && state_.before));
  choices_->setVisible(answering);
  choices_->choose(state_.chosen);
  choices_->light(state_.lit);
  feel_again_->setVisible(answering && !state_.before);
  stop_->setVisible(answering && state_.asks_stop);
  stop_->setChecked(state_.stops);
  primaryButton().setVisible(answering);
  primaryButton().setPhrase(phrase(state_.sure ? QStringLiteral("for.sure_yes") : QStringLiteral("nav.confirm")));
  primaryButton().waitFor(state_.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.choose"))) : std::nullopt);
  setFreeHandLeft(!state.left_handed);
  ScreenFrame::setState(state);
}

QString ForceScreen::idOfKey(int key) const {
  if (state_.phase != ForceState::Phase::kAnswer) return {};
  if (key >= Qt::Key_1 && key <= Qt::Key_5) return choices_->onScale(key - Qt::Key_0);
  if (key == Qt::Key_S && state_.asks_stop) return QStringLiteral("would_stop");
  if (key == Qt::Key_0) return QStringLiteral("not_felt");
  return key == Qt::Key_9 ? QStringLiteral("beyond_practice") : QString();
}

void ForceScreen::keyPressEvent(QKeyEvent* event) {
  const bool answering = state_.phase == ForceState::Phase::kAnswer;
  if (event->key() != Qt::Key_F || !answering || event->isAutoRepeat()) return ScreenFrame::keyPressEvent(event);
  if (feel_again_->isVisible()) emit feelAgain();
}

}  // namespace tactus::workbench::nurse
