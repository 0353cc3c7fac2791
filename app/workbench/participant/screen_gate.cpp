#include "app/workbench/participant/screen_gate.h"

namespace tactus::workbench {

void ScreenGate::painted(std::int64_t now_ns) {
  if (painted_) return;
  painted_ = true;
  painted_ns_ = free_ns_ = now_ns;
  let_go_ = !held_;
}

void ScreenGate::held(bool held, std::int64_t now_ns) {
  held_ = held;
  if (!painted_ || held || let_go_) return;
  let_go_ = true;
  free_ns_ = now_ns;
}

bool ScreenGate::takesInput(std::int64_t now_ns) const { return painted_ && let_go_ && now_ns - free_ns_ >= kSettleNs; }

}  // namespace tactus::workbench
