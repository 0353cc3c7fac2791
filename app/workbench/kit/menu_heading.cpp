#include "app/workbench/kit/menu_heading.h"

#include <QFontMetrics>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

void addMenuHeading(QMenu& menu, const QString& text) {
  menu.addSection(text);
  const int wanted = QFontMetrics(menu.font()).horizontalAdvance(text) + 4 * theme::kGrid;
  menu.setMinimumWidth(qMax(menu.minimumWidth(), wanted));
}

}  // namespace tactus::workbench
