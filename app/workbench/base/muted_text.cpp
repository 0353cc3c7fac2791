#include "app/workbench/base/muted_text.h"

#include <QPalette>
#include <QWidget>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

void setMuted(QWidget& label) {
  label.setFont(theme::smallFont());
  QPalette muted = label.palette();
  muted.setColor(QPalette::WindowText, theme::mutedInk());
  label.setPalette(muted);
}

}  // namespace tactus::workbench
