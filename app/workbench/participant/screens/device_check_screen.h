// The device check: one thing to do with the handle, and a traffic light.
#pragma once

#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

enum class DeviceStep { kWait, kHold, kStill, kPush, kPress, kRelease, kWarm, kReady, kWrong, kLost };

struct DeviceCheckState {
  DeviceStep step = DeviceStep::kWait;
  bool virtual_device = false;  ///< forces are drawn, not felt
  bool may_go_on = false;       ///< Next, or once more if something is wrong
  bool simulated = false;
};

class DeviceCheckScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit DeviceCheckScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const DeviceCheckState& state);

 private:
  TextBlock* texts_;
  Label* lead_;
  Label* virtual_;
  TrafficLight* light_;
};

}  // namespace tactus::workbench::nurse
