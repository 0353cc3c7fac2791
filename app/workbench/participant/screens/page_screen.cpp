#include "app/workbench/participant/screens/page_screen.h"

#include <QGridLayout>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/participant/kit/button.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kPictureMm = 34;

Picture painterOf(PageState::Picture picture) {
  switch (picture) {
    case PageState::Picture::kCup: return cupPicture();
    case PageState::Picture::kPush: return pushPicture();
    case PageState::Picture::kNone: break;
  }
  return {};
}

std::vector<Answer> answersOf(const PageState& page) {
  std::vector<Answer> answers;
  for (const PageCard& card : page.cards) answers.push_back({card.id, card.word, {}, card.apart});
  return answers;
}

}  // namespace

PageScreen::PageScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      picture_(new PictureBox(look, kPictureMm, kPictureMm, texts_)),
      instructions_(nullptr),
      sentence_(nullptr),
      remark_(nullptr),
      low_(new Label(look, TextRole::kMuted, this)),
      high_(new Label(look, TextRole::kMuted, this)),
      choices_(new Choices(look, this)) {
  picture_->hide();
  for (Label* end : {low_, high_}) {
    end->setWordWrap(false);
    end->setContentsMargins(kRingRoom, 0, kRingRoom, 0);
    end->hide();
  }
  choices_->hide();
  setMain(texts_);
}

void PageScreen::arrange(const PageState& page) {
  arranged_ = true;
  has_scale_ = !page.low.isEmpty();
  if (page.picture != PageState::Picture::kNone) {
    texts_->add(picture_);
    picture_->show();
  }
  instructions_ = texts_->add(TextRole::kBody);
  sentence_ = texts_->add(TextRole::kLead);
  remark_ = texts_->add(TextRole::kBody);
  primaryButton().reserve(page.wanted);
  if (page.cards.empty()) return texts_->center();
  choices_->show();
  if (!has_scale_) return setAnswers(choices_);
  auto* scale = new QWidget(this);
  auto* grid = new QGridLayout(scale);
  keepSpacing(look(), *grid, 0.5);
  for (Label* end : {low_, high_}) end->show();
  grid->addWidget(low_, 0, 0, Qt::AlignLeft);
  grid->addWidget(high_, 0, 1, Qt::AlignRight);
  grid->addWidget(choices_, 1, 0, 1, 2);
  setAnswers(choices_, scale);
  scale->show();  // what comes into a window on the screen is hidden
}

void PageScreen::setState(const ParticipantState& state) {
  const PageState& page = state.page;
  if (!arranged_) arrange(page);
  setTitle(page.title);
  picture_->setPicture(painterOf(page.picture));
  showOrHide(*instructions_, page.instructions);
  showOrHide(*sentence_, page.sentence);
  showOrHide(*remark_, page.remark);
  low_->setPhrase(page.low);
  high_->setPhrase(page.high);
  choices_->setAnswers(answersOf(page));
  choices_->choose(page.chosen);
  primaryButton().setPhrase(page.primary);
  const bool waits = !page.cards.empty() && page.chosen.isEmpty();
  primaryButton().waitFor(waits ? std::optional(page.wanted) : std::nullopt);
  if (page.is_end) primaryButton().setVisible(state.can_go_on);
  ScreenFrame::setState(state);
}

QString PageScreen::idOfKey(int key) const {
  if (!has_scale_) return {};
  if (key >= Qt::Key_1 && key <= Qt::Key_9) return choices_->onScale(key - Qt::Key_0);
  return key == Qt::Key_0 ? choices_->apart() : QString();
}

}  // namespace tactus::workbench::nurse
