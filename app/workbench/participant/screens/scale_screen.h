// A sentence with seven points between two ends: the effort and comfort of a part, and what clinical teachers say of
// the simulator.
#pragma once

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

class ScaleScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ScaleScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 protected:
  /// 1 to 7; 0: she would rather not say.
  QString idOfKey(int key) const override;

 private:
  TextBlock* texts_;
  Label* instructions_;
  Label* lead_;
  Label* low_;
  Label* high_;
  Choices* choices_;
};

}  // namespace tactus::workbench::nurse
