#include "app/workbench/participant/screens/device_check_screen.h"

#include <QHBoxLayout>

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

}  // namespace tactus::workbench::nurse
