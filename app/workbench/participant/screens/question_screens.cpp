#include "app/workbench/participant/screens/question_screens.h"

#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kPosePictureMm = 20;
constexpr int kRegionsShare = 3;  // of the width; an inset has 1

}  // namespace

GlossaryPage::GlossaryPage(const Look& look, TextRole role, const Phrase& sentence, QWidget* parent)
    : QWidget(parent), look_(look), row_(new QHBoxLayout) {
  auto* column = new QVBoxLayout(this);
  keepSpacing(look, *column, 3);
  column->addWidget(new Label(look, role, sentence, this));
  keepSpacing(look, *row_, 3);
  column->addLayout(row_, 1);
  connect(&look, &Look::changed, this, &GlossaryPage::alignCaptions);
}

void GlossaryPage::addColumn(const Phrase& word, QWidget* picture, bool grows) {
  auto* column = new QVBoxLayout;
  keepSpacing(look_, *column, 1.5);
  if (!grows) column->addStretch(1);
  column->addWidget(picture, grows ? 1 : 0, grows ? Qt::Alignment() : Qt::AlignHCenter);
  if (!word.isEmpty()) {
    auto* label = new Label(look_, TextRole::kBody, word, this);
    label->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    column->addWidget(label);
    if (grows) captions_.push_back(label);
  }
  if (!grows) column->addStretch(2);
  row_->addLayout(column, 1);
}

void GlossaryPage::alignCaptions() {
  const int count = static_cast<int>(captions_.size());
  if (count < 2) return;
  const int wide = (width() - (count - 1) * row_->spacing()) / count;
  int high = 0;
  for (const Label* caption : captions_) high = std::max(high, caption->heightForWidth(wide));
  for (Label* caption : captions_) caption->setMinimumHeight(high);
}

void GlossaryPage::resizeEvent(QResizeEvent* /*event*/) { alignCaptions(); }

void GlossaryPage::addPicture(const Phrase& word, Picture picture) {
  auto* box = new PictureBox(look_, 1.5 * kPosePictureMm, kPosePictureMm, this);
  box->setPicture(std::move(picture));
  addColumn(word, box, false);
}

anatomy::BodyView* GlossaryPage::newBody() { return anatomy::makeBodyView(look_.about(), this); }

void GlossaryPage::addPose(const Phrase& word, const study::ItemCondition& condition) {
  anatomy::BodyView* const view = newBody();
  view->showWhole();
  view->setDepth(std::nullopt);
  view->setPose(condition);
  addColumn(word, view, true);
}

void GlossaryPage::addRegions() {
  anatomy::BodyView* const view = newBody();
  const auto name = [this, view] {
    view->setFont(look_.font());
    view->setRegionNames(regionNames(look_));
    view->showNames();
    view->setAccessibleName(look_.say(phrase(QStringLiteral("acc.way"))));
  };
  connect(&look_, &Look::changed, view, name);
  name();
  row_->addWidget(view, kRegionsShare);
}

void GlossaryPage::addWay(const Phrase& word) {
  anatomy::BodyView* const view = newBody();
  view->showWhole();
  addColumn(word, view, true);
}

void GlossaryPage::addOtherViews(bool of_regions) {
  const procedure::Procedure& about = *look_.about();
  for (const procedure::OtherView& view : about.other_views) {
    if (view.of_regions != of_regions) continue;
    addColumn(phrase(QString::fromStdString(view.word)),
              new anatomy::InsetView(QByteArray::fromStdString(about.files.at(view.file)), this), true);
  }
}

GlossaryScreen::GlossaryScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), pages_(new QStackedWidget(this)) {
  const procedure::Procedure& about = *look.about();
  // The picture says from where it is, where others stand beside it.
  const bool has_others = std::any_of(about.other_views.begin(), about.other_views.end(),
                                      [](const procedure::OtherView& view) { return !view.of_regions; });
  GlossaryPage* start = addPage(phrase(QStringLiteral("q.instructions")), TextRole::kBody);
  start->addWay(has_others ? phrase(QStringLiteral("glo.from_side")) : Phrase{});
  start->addOtherViews(false);
  GlossaryPage* force = addPage(phrase(QStringLiteral("glo.force")));
  for (const Answer& word : questionWords(look)) {
    if (!word.apart) force->addPicture(word.word, word.picture);
  }
  GlossaryPage* way = addPage(phrase(QStringLiteral("glo.way")));
  way->addRegions();
  way->addOtherViews(true);
  for (std::size_t i = 0; i < about.inputs.size(); ++i) {
    if (i != about.way()) addWords(about.inputs[i]);
  }
  setTitle(phrase(QStringLiteral("glo.title")));
  setMain(pages_);
}

GlossaryPage* GlossaryScreen::addPage(const Phrase& sentence, TextRole role) {
  auto* page = new GlossaryPage(look(), role, sentence, pages_);
  pages_->addWidget(page);
  return page;
}

void GlossaryScreen::addWords(const fuzzy::Variable& input) {
  const procedure::Procedure& about = *look().about();
  const QString id = QString::fromStdString(input.id);
  GlossaryPage* const page = addPage(phrase(QStringLiteral("glo.") + id));
  for (const fuzzy::Term& term : input.terms) {
    const QString word = QStringLiteral("%1.%2").arg(id, QString::fromStdString(term.id));
    const study::ItemCondition condition{input.id, term.id};
    if (anatomy::showsPose(about, input.id)) {
      const QString pose = QStringLiteral("glo.") + word;
      page->addPose(phrase(look().knows(pose) ? pose : QStringLiteral("s.") + word), condition);
    } else {
      page->addPicture(phrase(QStringLiteral("s.") + word), conditionPicture(about, condition));
    }
  }
}

void GlossaryScreen::setPage(int page) {
  pages_->setCurrentIndex(std::clamp(page, 0, pages() - 1));
  showBack();
}

bool GlossaryScreen::turnPage(int by) {
  const int page = pages_->currentIndex() + by;
  if (page < 0 || page >= pages()) return false;
  setPage(page);
  return true;
}

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
