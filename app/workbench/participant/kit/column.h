// Distances in layouts of the nurse's screens, in steps of the grid, which follow the size of the screen.
#pragma once

#include <QLayout>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

/// `layout` gets no margins and `steps` of the grid between its items, now and after each change.
void keepSpacing(const Look& look, QLayout& layout, double steps);

}  // namespace tactus::workbench::nurse
