// Pictures of the stages, drawn as lines so that they are sharp at any scale and take the color of their text.
#pragma once

#include <QPainterPath>

#include "app/workbench/shell/stage.h"

namespace tactus::workbench {

/// Lines in a square of 24 x 24.
QPainterPath stagePicture(Stage stage);

}  // namespace tactus::workbench
