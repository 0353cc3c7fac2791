#include "app/workbench/kit/tab_look.h"

#include <QEvent>
#include <QTabBar>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

TabLook::TabLook(QTabBar& bar) : QObject(&bar), bar_(bar) { bar_.installEventFilter(this); }

bool TabLook::eventFilter(QObject* watched, QEvent* event) {
  // Another tab in front, a tab more or less, another look: whatever changed is painted, and so comes by here.
  if (event->type() == QEvent::Paint) show();
  return QObject::eventFilter(watched, event);
}

void TabLook::show() {
  // The window turns it on again for each bar it takes to another place.
  if (bar_.drawBase()) bar_.setDrawBase(false);
  // The style makes the tab in front a little lighter than this and the others darker.
  const QColor ground = theme::isDark() ? theme::card().lighter(125) : theme::window();
  QPalette colors = bar_.palette();
  if (colors.color(QPalette::Window) != ground) {
    colors.setColor(QPalette::Window, ground);
    bar_.setPalette(colors);
  }
  for (int i = 0; i < bar_.count(); ++i) {
    const QColor ink = i == bar_.currentIndex() ? theme::ink() : theme::mutedInk();
    if (bar_.tabTextColor(i) != ink) bar_.setTabTextColor(i, ink);
  }
}

}  // namespace tactus::workbench
