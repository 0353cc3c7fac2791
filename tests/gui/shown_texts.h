// Every text that a window holds: of labels, buttons, menus, tabs, lists, plots, tool tips, and what a screen reader
// says.
#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace tactus::tests {

struct ShownText {
  QString where;  ///< classes from the window down to what holds the text, and the kind of the text
  QString text;
};

/// Of `window` and all that is in it, hidden or not. Left out: what a person typed.
std::vector<ShownText> shownTexts(QWidget& window);

}  // namespace tactus::tests
