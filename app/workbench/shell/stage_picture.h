// Pictures of the stages as line drawings: sharp at any scale, in the color of the text.
#pragma once

#include <QPainterPath>

#include "app/workbench/shell/stage.h"

namespace tactus::workbench {

/// Lines in a square of 24 x 24 units.
QPainterPath stagePicture(Stage stage);

}  // namespace tactus::workbench
