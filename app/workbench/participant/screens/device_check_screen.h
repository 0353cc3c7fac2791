// The device check: one thing to do with the handle, and a traffic light.
#pragma once

#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

/// The id of the sentence that says how the tube is held on the device.
QString holdSentence(HoldMeans hold);

class DeviceCheckScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit DeviceCheckScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 private:
  TextBlock* texts_;
  Label* lead_;
  Label* hint_;
  PictureBox* picture_;
  Label* virtual_;
  TrafficLight* light_;
};

}  // namespace tactus::workbench::nurse
