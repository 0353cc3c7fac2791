#include "app/workbench/base/muted_text.h"

#include <QWidget>

#include "app/workbench/base/ink.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {

void setMuted(QWidget& label) {
  label.setFont(theme::smallFont());
  setInk(label, theme::mutedInk());
}

}  // namespace tactus::workbench
