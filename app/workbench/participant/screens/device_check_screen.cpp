#include "app/workbench/participant/screens/device_check_screen.h"

#include <QHBoxLayout>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {
namespace {

QString sentenceOf(DeviceStep step) {
  switch (step) {
    case DeviceStep::kWait: return QStringLiteral("dev.wait");
    case DeviceStep::kHold: return QStringLiteral("dev.hold");
    case DeviceStep::kStill: return QStringLiteral("dev.still");
    case DeviceStep::kPush: return QStringLiteral("dev.push");
    case DeviceStep::kPress: return QStringLiteral("dev.press");
    case DeviceStep::kRelease: return QStringLiteral("dev.release");
    case DeviceStep::kWarm: return QStringLiteral("dev.warm");
    case DeviceStep::kReady: return QStringLiteral("dev.ready");
    case DeviceStep::kWrong: return QStringLiteral("dev.wrong");
    case DeviceStep::kLost: break;
  }
  return QStringLiteral("dev.lost");
}

Light lightOf(DeviceStep step) {
  if (step == DeviceStep::kReady) return Light::kReady;
  return step == DeviceStep::kWrong || step == DeviceStep::kLost ? Light::kStop : Light::kWait;
}

}  // namespace

DeviceCheckScreen::DeviceCheckScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), texts_(new TextBlock(look)), light_(new TrafficLight(look)) {
  lead_ = texts_->add(TextRole::kLead, phrase(QStringLiteral("dev.wait")));
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

void DeviceCheckScreen::setState(const DeviceCheckState& state) {
  const bool ready = state.step == DeviceStep::kReady;
  const Phrase sentence = phrase(sentenceOf(state.step));
  lead_->setPhrase(sentence);
  virtual_->setVisible(state.virtual_device);
  light_->setLight(lightOf(state.step));
  light_->setAccessibleName(lead_->text());
  primaryButton().setVisible(ready || state.may_go_on);
  primaryButton().setPhrase(phrase(ready ? QStringLiteral("nav.next") : QStringLiteral("nav.repeat")));
  setSimulated(state.simulated);
}

}  // namespace tactus::workbench::nurse
