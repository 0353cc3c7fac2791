// The Tab order of a window: reading order, group by group, from top to bottom and from left to right. The order of
// creation does not matter.
#pragma once

#include <QList>

class QWidget;

namespace tactus::workbench {

/// The visible widgets of `window` that Tab can reach, in reading order. Leaves out a scroll area if all its content is
/// visible.
QList<QWidget*> readingOrder(const QWidget& window);

/// Moves the focus to the next widget (`forward`) or the previous one, and scrolls it into view. Returns false if there
/// is none.
bool focusNextAsRead(const QWidget& window, bool forward);

}  // namespace tactus::workbench
