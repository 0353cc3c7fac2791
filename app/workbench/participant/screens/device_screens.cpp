#include "app/workbench/participant/screens/device_screens.h"

#include <QHBoxLayout>
#include <QKeyEvent>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench::nurse {

QString holdSentence(HoldMeans hold) {
  switch (hold) {
    case HoldMeans::kButton: break;
    case HoldMeans::kLatch: return QStringLiteral("dev.hold_latch");
    case HoldMeans::kPedal: return QStringLiteral("dev.hold_pedal");
    case HoldMeans::kMouse: return QStringLiteral("dev.hold_mouse");
  }
  return QStringLiteral("dev.hold");
}

namespace {

QString releaseSentence(HoldMeans hold) {
  switch (hold) {
    case HoldMeans::kMouse: return QStringLiteral("dev.release_mouse");
    case HoldMeans::kLatch: return QStringLiteral("dev.release_latch");
    case HoldMeans::kPedal: return QStringLiteral("dev.release_pedal");
    case HoldMeans::kButton: break;
  }
  return QStringLiteral("dev.release");
}

QString deviceSentence(const ParticipantState& state) {
  switch (state.device) {
    case DeviceStep::kWait: return QStringLiteral("dev.wait");
    case DeviceStep::kHold: return holdSentence(state.hold);
    case DeviceStep::kStill: return QStringLiteral("dev.still");
    case DeviceStep::kPush: return QStringLiteral("dev.push");
    case DeviceStep::kRelease: return releaseSentence(state.hold);
    case DeviceStep::kReady: return QStringLiteral("dev.ready");
    case DeviceStep::kWrong: return QStringLiteral("dev.wrong");
    case DeviceStep::kLost: break;
  }
  return QStringLiteral("dev.lost");
}

QString hintSentence(HoldMeans hold) {
  return hold == HoldMeans::kMouse ? QStringLiteral("dev.hint_mouse") : QStringLiteral("dev.hint");
}

constexpr double kHoldWidthMm = 60;
constexpr double kHoldHeightMm = 40;

Light lightOf(DeviceStep step) {
  if (step == DeviceStep::kReady) return Light::kReady;
  return step == DeviceStep::kWrong || step == DeviceStep::kLost ? Light::kStop : Light::kWait;
}

}  // namespace

DeviceCheckScreen::DeviceCheckScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), texts_(new TextBlock(look)), light_(new TrafficLight(look)) {
  lead_ = texts_->add(TextRole::kLead, phrase(QStringLiteral("dev.wait")));
  hint_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("dev.hint")));
  picture_ = new PictureBox(look, kHoldWidthMm, kHoldHeightMm, texts_);
  texts_->add(picture_);
  virtual_ = texts_->add(TextRole::kMuted, phrase(QStringLiteral("dev.virtual")));
  texts_->center();
  auto* main = new QWidget(this);
  auto* row = new QHBoxLayout(main);
  keepSpacing(look, *row, 6);
  row->addWidget(light_, 0, Qt::AlignVCenter);
  row->addWidget(texts_, 1);
  setTitle(phrase(QStringLiteral("dev.title")));
  setMain(main);
  setState({});
}

void DeviceCheckScreen::setState(const ParticipantState& state) {
  const bool ready = state.device == DeviceStep::kReady;
  lead_->setPhrase(phrase(deviceSentence(state)));
  const bool holds = state.device == DeviceStep::kHold;
  hint_->setVisible(holds && state.waits != HoldWait::kNot);
  hint_->setPhrase(phrase(state.waits == HoldWait::kStuck ? QStringLiteral("dev.stuck") : hintSentence(state.hold)));
  picture_->setVisible(holds);
  picture_->setPicture(holdPicture(state.hold));
  // Its forces are drawn, not felt.
  virtual_->setVisible(state.simulated && state.virtual_device);
  light_->setLight(lightOf(state.device));
  light_->setAccessibleName(lead_->text());
  primaryButton().setVisible(ready || state.can_go_on);
  primaryButton().setPhrase(phrase(ready ? QStringLiteral("nav.next") : QStringLiteral("nav.repeat")));
  ScreenFrame::setState(state);
}

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

namespace {

constexpr double kOwnPictureShare = 0.4;

}  // namespace

OwnModelScreen::OwnModelScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      region_(texts_->add(TextRole::kLead, plain(QStringLiteral(" ")))),
      do_(nullptr),
      line_(nullptr),
      mark_(nullptr),
      choices_(new Choices(look, this)),
      picture_(anatomy::makeBodyView(look.about(), this)) {
  do_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("for.do")));
  line_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("own.line")));
  texts_->center();
  setTitle(phrase(QStringLiteral("own.title")));
  setMain(texts_, picture_, kOwnPictureShare);
  setAnswers(choices_);
  std::vector<Answer> answers;
  for (const char* id : {"lighter", "right", "heavier", "cant_tell"})
    answers.push_back({QString::fromLatin1(id),
                       phrase(QStringLiteral("own.") + QString::fromLatin1(id)),
                       {},
                       qstrcmp(id, "cant_tell") == 0});
  choices_->setAnswers(std::move(answers));
  mark_ = new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("own.mark")), this);
  addExtra(mark_);
  primaryButton().reserve(phrase(QStringLiteral("own.push")));
  connect(mark_, &QAbstractButton::clicked, this, &OwnModelScreen::marked);
  connect(&look, &Look::changed, this, &OwnModelScreen::show);
}

void OwnModelScreen::setState(const ParticipantState& state) {
  state_ = state.own;
  const bool unavailable = !state_.unavailable.isEmpty();
  choices_->choose(state_.chosen);
  const bool feels = state_.ready && !unavailable;
  for (QWidget* widget : std::initializer_list<QWidget*>{do_, line_, choices_, mark_}) widget->setVisible(feels);
  primaryButton().setVisible(feels || unavailable);
  const QString missing = state_.felt ? QStringLiteral("err.choose") : QStringLiteral("own.push");
  primaryButton().waitFor(feels && state_.chosen.isEmpty() ? std::optional(phrase(missing)) : std::nullopt);
  picture_->setMirrored(state.left_handed);
  setFreeHandLeft(!state.left_handed);
  show();
  ScreenFrame::setState(state);
}

void OwnModelScreen::setDepth(std::optional<double> depth_mm) { picture_->setDepth(depth_mm); }

void OwnModelScreen::show() {
  if (!state_.unavailable.isEmpty() || !state_.ready) {
    region_->setPhrase(phrase(!state_.unavailable.isEmpty() ? QStringLiteral("own.none") : QStringLiteral("dev.wait")));
    picture_->lightRegion({});
    return;
  }
  region_->setPhrase(phrase(QStringLiteral("a.") + state_.region));
  picture_->setFont(look().font());
  picture_->setRegionNames(regionNames(look()));
  picture_->lightRegion(state_.region);
  picture_->setAccessibleName(look().say(phrase(QStringLiteral("acc.way"))));
}

QString OwnModelScreen::idOfKey(int key) const {
  if (key == Qt::Key_0) return QStringLiteral("cant_tell");
  return key >= Qt::Key_1 && key <= Qt::Key_3 ? choices_->onScale(key - Qt::Key_0) : QString();
}

}  // namespace tactus::workbench::nurse
