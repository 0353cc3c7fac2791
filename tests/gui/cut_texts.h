// What of the texts of a window cannot be read: beyond an edge, or shortened where a text must be whole.
#pragma once

#include <QStringList>

class QWidget;

namespace tactus::tests {

/// One line for each text that `window` shows in part: `QPushButton "Record": cut at the right`. What a scroll bar
/// leads to is not cut. A label or a choice may end in an ellipsis; a button, a check box and a tab may not.
QStringList cutTexts(QWidget& window);

}  // namespace tactus::tests
