#include "app/workbench/shell/panel.h"

#include "app/workbench/kit/layout.h"

namespace tactus::workbench {

void Panel::reveal() {
  show();
  raise();
}

// Out of the window it is a window of its own.
bool Panel::focusNextPrevChild(bool next) {
  return isWindow() ? focusNextAsRead(*this, next) : QDockWidget::focusNextPrevChild(next);
}

}  // namespace tactus::workbench
