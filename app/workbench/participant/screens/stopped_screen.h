// The end before the end: stopped for today, withdrawn, or no consent; also what keeps her from going on.
#pragma once

#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

enum class StopReason { kForToday, kWithdrawn, kNoConsent, kPaused, kNotSaved, kDeviceLost };

struct StoppedState {
  StopReason reason = StopReason::kForToday;
  QString code;
  bool may_go_on = false;
  bool simulated = false;
};

class StoppedScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit StoppedScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const StoppedState& state);

 private:
  TextBlock* texts_;
  Label* lead_;
};

}  // namespace tactus::workbench::nurse
