#include "app/workbench/participant/screens/question_screen.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kPictureShare = 0.4;
constexpr double kConditionMm = 14;

}  // namespace

QuestionScreen::QuestionScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      situation_(nullptr),
      ask_(nullptr),
      usual_(nullptr),
      choices_(new Choices(look, this)),
      picture_(anatomy::makeBodyView(look.about(), this)),
      condition_pictures_(new QWidget(picture_)),
      corner_(new QHBoxLayout(picture_)) {
  // In front of the forehead, where nothing is drawn.
  corner_->addWidget(condition_pictures_);
  situation_ = texts_->add(TextRole::kBody, plain(QStringLiteral(" ")));
  ask_ = texts_->add(TextRole::kLead, plain(QStringLiteral(" ")));
  usual_ = texts_->add(TextRole::kMuted, phrase(QStringLiteral("q.usual")));
  texts_->center();
  setMain(texts_, picture_, kPictureShare);
  setAnswers(choices_);
  choices_->setAnswers(questionWords(look));
  primaryButton().setPhrase(phrase(QStringLiteral("nav.confirm")));
  primaryButton().reserve(phrase(QStringLiteral("err.choose")));
  connect(&look, &Look::changed, this, &QuestionScreen::show);
}

void QuestionScreen::setState(const ParticipantState& state) {
  const bool others = state.question.conditions != state_.conditions;
  state_ = state.question;
  setTitle(phrase(QStringLiteral("q.title"), {QString::number(state.part), QString::number(state.parts),
                                              QString::number(state_.position), QString::number(state_.count)}));
  if (others) showConditions();
  corner_->setAlignment(condition_pictures_, Qt::AlignTop | (state.left_handed ? Qt::AlignRight : Qt::AlignLeft));
  picture_->setMirrored(state.left_handed);
  choices_->choose(state_.chosen);
  primaryButton().waitFor(state_.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.choose"))) : std::nullopt);
  setFreeHandLeft(!state.left_handed);
  show();
  ScreenFrame::setState(state);
}

// One small picture for each condition that the body does not show as a pose.
void QuestionScreen::showConditions() {
  study::ItemCondition pose;
  delete condition_pictures_;
  condition_pictures_ = new QWidget(picture_);
  auto* const row = new QHBoxLayout(condition_pictures_);
  keepSpacing(look(), *row, 1);
  for (const study::ItemCondition& condition : state_.conditions) {
    if (anatomy::showsPose(*look().about(), condition.input)) {
      pose = condition;
    } else if (Picture picture = conditionPicture(*look().about(), condition)) {
      auto* const box = new PictureBox(look(), 1.5 * kConditionMm, kConditionMm, condition_pictures_);
      box->setPicture(std::move(picture));
      row->addWidget(box);
    }
  }
  corner_->addWidget(condition_pictures_);
  condition_pictures_->setVisible(row->count() > 0);
  picture_->setPose(pose);
}

// Said in the glossary too: with the largest text on a small screen there is no room for it here.
void QuestionScreen::resizeEvent(QResizeEvent* event) {
  ScreenFrame::resizeEvent(event);
  showUsual();
}

void QuestionScreen::showUsual() {
  constexpr int kRoomTexts = 24;  // heights of text
  usual_->setVisible(height() >= kRoomTexts * look().textPx());
}

void QuestionScreen::show() {
  showUsual();
  if (state_.item == 0) return;
  situation_->setPhrase(phrase(QStringLiteral("q.item.%1").arg(state_.item)));
  showOrHide(*ask_, plain(look().say(phrase(QStringLiteral("q.ask.%1").arg(state_.item)))));
  picture_->setFont(look().font());
  picture_->setRegionNames(regionNames(look()));
  picture_->lightRegion(state_.region);
  picture_->showTipIn(state_.region);
  picture_->setAccessibleName(situation_->text());
}

QString QuestionScreen::idOfKey(int key) const {
  if (key >= Qt::Key_1 && key <= Qt::Key_9) return choices_->onScale(key - Qt::Key_0);
  return key == Qt::Key_0 ? QStringLiteral("cant_tell") : QString();
}

}  // namespace tactus::workbench::nurse
