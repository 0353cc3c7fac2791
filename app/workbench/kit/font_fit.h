// Sizes that follow from the font of a widget, also after the size of the text was changed while the program runs.
#pragma once

#include <functional>

class QWidget;

namespace tactus::workbench {

/// Calls `fit` now, and again whenever the font of `widget` has changed.
void keepFitted(QWidget& widget, std::function<void()> fit);

}  // namespace tactus::workbench
