#include "app/workbench/kit/reading_order.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QWidget>
#include <algorithm>

namespace tactus::workbench {
namespace {

bool canScroll(const QScrollArea& area) {
  const auto moves = [](const QScrollBar* bar) { return bar->maximum() > bar->minimum(); };
  return moves(area.verticalScrollBar()) || moves(area.horizontalScrollBar());
}

bool takesTab(const QWidget& widget) {
  if (!widget.isEnabled() || (widget.focusPolicy() & Qt::TabFocus) == 0 || widget.focusProxy()) return false;
  const auto* area = qobject_cast<const QScrollArea*>(&widget);
  return !area || canScroll(*area);
}

struct Part {
  QRect place;
  QList<QWidget*> stops;
};

// Where no part begins before `end` of the ones before it, the line of parts can be cut: groups of parts between cuts.
template <class From, class To>
QList<QList<Part>> cut(QList<Part> parts, From from, To to) {
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const Part& one, const Part& other) { return from(one) < from(other); });
  QList<QList<Part>> groups;
  int end = 0;
  for (const Part& part : parts) {
    if (groups.isEmpty() || from(part) >= end) groups << QList<Part>{};
    groups.back() << part;
    end = std::max(groups.back().size() == 1 ? to(part) : end, to(part));
  }
  return groups;
}

// Rows from top to bottom; where there are no rows, columns from left to right; and so on in each of them.
QList<QWidget*> inOrder(const QList<Part>& parts) {
  QList<QWidget*> out;
  if (parts.size() < 2) {
    for (const Part& part : parts) out << part.stops;
    return out;
  }
  auto groups = cut(
      parts, [](const Part& part) { return part.place.top(); },
      [](const Part& part) { return part.place.bottom() + 1; });
  if (groups.size() == 1) {
    groups = cut(
        parts, [](const Part& part) { return part.place.left(); },
        [](const Part& part) { return part.place.right() + 1; });
  }
  if (groups.size() == 1) {
    // They overlap each other; as sorted by `cut`, from left to right.
    for (const Part& part : groups.front()) out << part.stops;
    return out;
  }
  for (const QList<Part>& group : groups) out << inOrder(group);
  return out;
}

QList<QWidget*> stopsIn(const QWidget& parent) {
  QList<Part> parts;
  for (QObject* child : parent.children()) {
    auto* widget = qobject_cast<QWidget*>(child);
    if (!widget || widget->isWindow() || !widget->isVisible()) continue;
    // Qt keeps unused tab bars of docks outside the visible area.
    if (!parent.rect().intersects(widget->geometry())) continue;
    QList<QWidget*> stops;
    if (takesTab(*widget)) stops << widget;
    stops << stopsIn(*widget);
    if (!stops.isEmpty()) parts << Part{widget->geometry(), stops};
  }
  return inOrder(parts);
}

}  // namespace

QList<QWidget*> readingOrder(const QWidget& window) { return stopsIn(window); }

bool focusNextAsRead(const QWidget& window, bool forward) {
  const QList<QWidget*> stops = readingOrder(window);
  if (stops.isEmpty()) return false;
  const auto now = stops.indexOf(window.focusWidget());
  const auto count = stops.size();
  const auto next = now < 0 ? (forward ? 0 : count - 1) : (now + (forward ? 1 : count - 1)) % count;
  QWidget* const widget = stops[next];
  for (QWidget* above = widget->parentWidget(); above && above != &window; above = above->parentWidget()) {
    if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(widget);
  }
  widget->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  return true;
}

}  // namespace tactus::workbench
