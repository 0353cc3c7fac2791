// Feel your own model, region by region: lighter, about the same, heavier than in practice, and "mark this moment". The
// researcher sees the marks; they change nothing by themselves.
#pragma once

#include <optional>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

class OwnModelScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit OwnModelScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;
  void setDepth(std::optional<double> depth_mm);

 signals:
  void marked();

 protected:
  /// 1 to 3: lighter, about the same, heavier.
  QString idOfKey(int key) const override;

 private:
  void show();

  OwnModelState state_;
  TextBlock* texts_;
  Label* region_;
  Label* do_;
  Label* line_;
  Button* mark_;
  Choices* choices_;
  anatomy::BodyView* picture_;
};

}  // namespace tactus::workbench::nurse
