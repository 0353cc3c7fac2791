// The order in which Tab goes through a window: as it is read, part by part from top to bottom and from left to right,
// whatever the order in which the parts were made.
#pragma once

#include <QList>

class QWidget;

namespace tactus::workbench {

/// What can be reached with Tab in `window` as it stands on the screen now. What only could scroll is left out where
/// all of it can be seen.
QList<QWidget*> readingOrder(const QWidget& window);

/// Gives the keyboard to the one after (`forward`) or before the one that has it, and scrolls it into view. Returns
/// false where there is nothing.
bool focusNextAsRead(const QWidget& window, bool forward);

}  // namespace tactus::workbench
