#include "app/workbench/participant/screens/stroke_screen.h"

#include <QHBoxLayout>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/screens/device_check_screen.h"

namespace tactus::workbench::nurse {
namespace {

QString noteOf(SpeedState::Note note) {
  using Note = SpeedState::Note;
  switch (note) {
    case Note::kStart: return QStringLiteral("spd.start");
    case Note::kReturn: return QStringLiteral("spd.return");
    case Note::kRecorded: return QStringLiteral("spd.recorded");
    case Note::kTooShort: return QStringLiteral("spd.too_short");
    case Note::kNotRecorded: return QStringLiteral("spd.not_recorded");
    case Note::kBackwards: return QStringLiteral("spd.backwards");
    case Note::kOutOfRange: break;
  }
  return QStringLiteral("spd.out_of_range");
}

constexpr double kStrokePictureShare = 0.46;
constexpr double kStrokeTickMm = 9;

}  // namespace

StrokeScreen::StrokeScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      practice_(nullptr),
      lead_(texts_->add(TextRole::kLead, plain(QStringLiteral(" ")))),
      dots_(new Dots(look, texts_)),
      tick_(nullptr),
      note_(nullptr),
      picture_(anatomy::makeBodyView(look.about(), this)) {
  texts_->add(dots_);
  auto* row = new QWidget(texts_);
  auto* line = new QHBoxLayout(row);
  keepSpacing(look, *line, 1.5);
  tick_ = new PictureBox(look, kStrokeTickMm, kStrokeTickMm, row);
  tick_->setPicture(tickPicture());
  note_ = new Label(look, TextRole::kBody, phrase(QStringLiteral("spd.start")), row);
  line->addWidget(tick_, 0, Qt::AlignVCenter);
  line->addWidget(note_, 1);
  texts_->add(row);
  practice_ = texts_->add(TextRole::kMuted, phrase(QStringLiteral("pra.line")));
  texts_->center();
  setMain(texts_, picture_, kStrokePictureShare);
  const auto name = [this, &look] {
    picture_->setFont(look.font());
    picture_->setRegionNames(regionNames(look));
    picture_->setAccessibleName(look.say(phrase(QStringLiteral("acc.way"))));
  };
  connect(&look, &Look::changed, this, name);
  name();
}

void StrokeScreen::setState(const ParticipantState& state) {
  const bool practice = state.screen == ParticipantScreen::kPractice;
  setTitle(practice ? phrase(QStringLiteral("pra.title"))
                    : phrase(QStringLiteral("spd.title"), {QString::number(state.part), QString::number(state.parts)}));
  practice_->setVisible(practice);
  lead_->setPhrase(phrase(QStringLiteral("spd.") + state.speed.level));
  dots_->setVisible(!practice);
  dots_->setCount(state.speed.recorded, state.speed.wanted);
  const bool asks = state.speed.note == SpeedState::Note::kStart && state.waits != HoldWait::kNot;
  note_->setPhrase(phrase(asks ? holdSentence(state.hold) : noteOf(state.speed.note)));
  tick_->setVisible(state.speed.note == SpeedState::Note::kRecorded);
  primaryButton().setVisible(state.can_go_on);
  picture_->setMirrored(state.left_handed);
  setFreeHandLeft(!state.left_handed);
  ScreenFrame::setState(state);
}

void StrokeScreen::setDepth(double depth_mm) { picture_->setDepth(depth_mm); }

}  // namespace tactus::workbench::nurse
