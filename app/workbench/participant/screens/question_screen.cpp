#include "app/workbench/participant/screens/question_screen.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kPictureShare = 0.4;
constexpr double kConditionMm = 14;

int levelOf(const QString& term) {
  for (const char* first : {"poor", "small", "slow"}) {
    if (term == QLatin1String(first)) return 1;
  }
  return term == QLatin1String("medium") ? 2 : 3;
}

}  // namespace

Picture pictureOf(const QString& condition, const QString& term) {
  if (condition == QLatin1String("lubrication")) return lubricationPicture(levelOf(term));
  if (condition == QLatin1String("speed")) return speedPicture(levelOf(term));
  return {};
}

anatomy::Posture postureOf(const QString& condition, const QString& term) {
  if (condition != QLatin1String("neck_flexion")) return anatomy::Posture::kUpright;
  return static_cast<anatomy::Posture>(levelOf(term) - 1);
}

QuestionScreen::QuestionScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      situation_(nullptr),
      usual_(nullptr),
      choices_(new Choices(look, this)),
      picture_(new anatomy::AnatomyView(this)),
      condition_picture_(new PictureBox(look, 1.5 * kConditionMm, kConditionMm, picture_)),
      corner_(new QHBoxLayout(picture_)) {
  // In front of the forehead, where nothing is drawn.
  corner_->addWidget(condition_picture_);
  situation_ = texts_->add(TextRole::kBody, plain(QStringLiteral(" ")));
  texts_->add(TextRole::kLead, phrase(QStringLiteral("q.question")));
  usual_ = texts_->add(TextRole::kMuted, phrase(QStringLiteral("q.usual")));
  texts_->center();
  setMain(texts_, picture_, kPictureShare);
  setAnswers(choices_);
  choices_->setAnswers(questionWords());
  primaryButton().setPhrase(phrase(QStringLiteral("nav.confirm")));
  primaryButton().reserve(phrase(QStringLiteral("err.choose")));
  connect(&look, &Look::changed, this, &QuestionScreen::show);
}

void QuestionScreen::setState(const ParticipantState& state) {
  state_ = state.question;
  setTitle(phrase(QStringLiteral("q.title"), {QString::number(state.part), QString::number(state.parts),
                                              QString::number(state_.position), QString::number(state_.count)}));
  Picture picture = pictureOf(state_.condition, state_.term);
  condition_picture_->setVisible(static_cast<bool>(picture));
  condition_picture_->setPicture(std::move(picture));
  picture_->setPosture(postureOf(state_.condition, state_.term));
  picture_->setMirrored(state.left_handed);
  corner_->setAlignment(condition_picture_, Qt::AlignTop | (state.left_handed ? Qt::AlignRight : Qt::AlignLeft));
  choices_->choose(state_.chosen);
  primaryButton().waitFor(state_.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.choose"))) : std::nullopt);
  setFreeHandLeft(!state.left_handed);
  show();
  ScreenFrame::setState(state);
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
  if (state_.region.isEmpty()) return;
  const QString condition = look().say(phrase(QStringLiteral("q.%1.%2").arg(state_.condition, state_.term)));
  const QString depth = look().say(phrase(QStringLiteral("q.depth.") + state_.region));
  // Chinese sentences follow each other without a space.
  situation_->setPhrase(plain(condition + QLatin1String(look().language() == Language::kEnglish ? " " : "") + depth));

  const auto region = anatomy::regionWithId(state_.region.toStdString());
  if (!region) return;
  const auto next = static_cast<std::size_t>(*region) + 1;
  const bool chest = *region == anatomy::Region::kEsophagus;
  picture_->setFont(look().font());
  picture_->setFraming(chest ? anatomy::Framing::kWhole : anatomy::Framing::kThroat);
  picture_->setDepth((anatomy::beginMm(*region) + anatomy::beginMm(anatomy::kRegions[next])) / 2);
  picture_->light(*region, look().say(phrase(QStringLiteral("a.") + state_.region)));
  picture_->setAccessibleName(situation_->text());
}

QString QuestionScreen::idOfKey(int key) const {
  if (key >= Qt::Key_1 && key <= Qt::Key_5) return choices_->onScale(key - Qt::Key_0);
  return key == Qt::Key_0 ? QStringLiteral("cant_tell") : QString();
}

}  // namespace tactus::workbench::nurse
