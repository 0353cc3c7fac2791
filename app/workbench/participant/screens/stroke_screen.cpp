#include "app/workbench/participant/screens/stroke_screen.h"

#include <QHBoxLayout>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {
namespace {

QString sentenceOf(SpeedWord speed) {
  switch (speed) {
    case SpeedWord::kSlow: return QStringLiteral("spd.slow");
    case SpeedWord::kMedium: return QStringLiteral("spd.medium");
    case SpeedWord::kFast: break;
  }
  return QStringLiteral("spd.fast");
}

QString noteOf(StrokeNote note) {
  switch (note) {
    case StrokeNote::kStart: return QStringLiteral("spd.start");
    case StrokeNote::kReturn: return QStringLiteral("spd.return");
    case StrokeNote::kRecorded: return QStringLiteral("spd.recorded");
    case StrokeNote::kTooShort: return QStringLiteral("spd.too_short");
    case StrokeNote::kNotRecorded: return QStringLiteral("spd.not_recorded");
    case StrokeNote::kBackwards: return QStringLiteral("spd.backwards");
    case StrokeNote::kOutOfRange: break;
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
      lead_(texts_->add(TextRole::kLead, phrase(QStringLiteral("spd.slow")))),
      dots_(new Dots(look, texts_)),
      tick_(nullptr),
      note_(nullptr),
      picture_(new anatomy::AnatomyView(this)) {
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
  const auto name = [this, &look] { picture_->setAccessibleName(look.say(phrase(QStringLiteral("acc.way")))); };
  connect(&look, &Look::changed, this, name);
  name();
  setState({});
}

void StrokeScreen::setState(const StrokeState& state) {
  setTitle(state.practice
               ? phrase(QStringLiteral("pra.title"))
               : phrase(QStringLiteral("spd.title"), {QString::number(state.part), QString::number(state.parts)}));
  practice_->setVisible(state.practice);
  lead_->setPhrase(phrase(sentenceOf(state.speed)));
  dots_->setVisible(!state.practice);
  dots_->setCount(state.recorded, state.wanted);
  note_->setPhrase(phrase(noteOf(state.note)));
  tick_->setVisible(state.note == StrokeNote::kRecorded);
  primaryButton().setVisible(state.may_go_on);
  picture_->setMirrored(state.left_handed);
  setFreeHandLeft(!state.left_handed);
  setSimulated(state.simulated);
}

void StrokeScreen::setDepth(double depth_mm) { picture_->setDepth(depth_mm); }

}  // namespace tactus::workbench::nurse
