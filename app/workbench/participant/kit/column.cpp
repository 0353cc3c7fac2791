#include "app/workbench/participant/kit/column.h"

namespace tactus::workbench::nurse {

void keepSpacing(const Look& look, QLayout& layout, double steps) {
  layout.setContentsMargins(0, 0, 0, 0);
  const auto set = [&look, &layout, steps] { layout.setSpacing(look.gap(steps)); };
  set();
  QObject::connect(&look, &Look::changed, &layout, set);
}

}  // namespace tactus::workbench::nurse
