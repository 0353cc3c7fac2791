// Practice of strokes and the speed experiment: one word for the speed, the tube in the picture follows the hand, a dot
// for each stroke. Nothing moves by itself and nothing tells a speed.
#pragma once

#include <optional>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

class StrokeScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit StrokeScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;
  /// Where the hand is, mm from the start; drawn with the next frame.
  void setDepth(double depth_mm);

 private:
  TextBlock* texts_;
  Label* practice_;
  Label* lead_;
  Dots* dots_;
  PictureBox* tick_;
  Label* note_;
  anatomy::BodyView* picture_;
};

}  // namespace tactus::workbench::nurse
