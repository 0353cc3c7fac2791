#include "app/workbench/kit/layout.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QWidget>
#include <algorithm>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

template <class Layout>
Layout* filled(Layout* layout, std::initializer_list<LayoutPart> parts, int between, QMargins around) {
  layout->setContentsMargins(around);
  layout->setSpacing(between);
  for (const LayoutPart& part : parts) {
    if (part.widget != nullptr) {
      layout->addWidget(part.widget, part.stretch, part.at);
    } else if (part.layout != nullptr) {
      layout->addLayout(part.layout, part.stretch);
    } else if (part.gap_px > 0) {
      layout->addSpacing(part.gap_px);
    } else {
      layout->addStretch(part.stretch);
    }
  }
  return layout;
}

}  // namespace

LayoutPart spring(int share) { return {static_cast<QWidget*>(nullptr), share}; }

LayoutPart gap(int px) {
  LayoutPart part = spring();
  part.gap_px = px;
  return part;
}

QHBoxLayout* makeRow(QWidget* owner, std::initializer_list<LayoutPart> parts, int between, QMargins around) {
  return filled(new QHBoxLayout(owner), parts, between, around);
}

QHBoxLayout* makeRow(std::initializer_list<LayoutPart> parts, int between, QMargins around) {
  return makeRow(nullptr, parts, between, around);
}

QVBoxLayout* makeColumn(QWidget* owner, std::initializer_list<LayoutPart> parts, int between, QMargins around) {
  return filled(new QVBoxLayout(owner), parts, between, around);
}

QVBoxLayout* makeColumn(std::initializer_list<LayoutPart> parts, int between, QMargins around) {
  return makeColumn(nullptr, parts, between, around);
}

QSplitter* makeSplit(Qt::Orientation along, std::initializer_list<LayoutPart> widgets) {
  auto* split = new QSplitter(along);
  split->setChildrenCollapsible(false);
  split->setHandleWidth(theme::kGrid);
  for (const LayoutPart& part : widgets) {
    split->addWidget(part.widget);
    split->setStretchFactor(split->count() - 1, part.stretch);
  }
  return split;
}

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

namespace {

// The text that is edited in `part`, its own or that of a number box.
const QLineEdit* textOf(const QWidget& part) {
  const auto* own = qobject_cast<const QLineEdit*>(&part);
  return own ? own : part.findChild<const QLineEdit*>();
}

bool leavesText(const QWidget& part, bool forward) {
  const QLineEdit* text = textOf(part);
  if (!text || text->selectedText() == text->text()) return true;
  return !text->hasSelectedText() && text->cursorPosition() == (forward ? text->text().size() : 0);
}

}  // namespace

RowStop::RowStop(const QList<QWidget*>& parts, QObject* parent, Qt::Orientation along)
    : QObject(parent), along_(along) {
  for (QWidget* part : parts) {
    const bool click = (part->focusPolicy() & Qt::ClickFocus) != 0;
    parts_ << Part{part, click ? Qt::ClickFocus : Qt::NoFocus};
    part->installEventFilter(this);
  }
  stopSomewhere();
}

bool RowStop::canStop(qsizetype part) const {
  const QWidget* widget = parts_[part].widget;
  return widget != nullptr && widget->isEnabled() && !widget->isHidden();
}

void RowStop::stopAt(qsizetype part) {
  stop_ = part;
  for (qsizetype i = 0; i < parts_.size(); ++i) {
    const int tab = i == part ? Qt::TabFocus : Qt::NoFocus;
    if (parts_[i].widget) parts_[i].widget->setFocusPolicy(static_cast<Qt::FocusPolicy>(parts_[i].by_click | tab));
  }
}

void RowStop::stopSomewhere() {
  qsizetype part = 0;
  while (part < parts_.size() && !canStop(part)) ++part;
  stopAt(part < parts_.size() ? part : 0);
}

bool RowStop::eventFilter(QObject* watched, QEvent* event) {
  const auto found =
      std::find_if(parts_.begin(), parts_.end(), [&](const Part& one) { return one.widget.data() == watched; });
  if (found == parts_.end()) return QObject::eventFilter(watched, event);
  const qsizetype part = found - parts_.begin();
  switch (event->type()) {
    case QEvent::FocusIn: stopAt(part); break;
    case QEvent::EnabledChange:
    case QEvent::ShowToParent:
    case QEvent::HideToParent:
      // The row keeps a stop while any part of it can be used.
      if (!canStop(stop_)) stopSomewhere();
      break;
    case QEvent::KeyPress:
      if (goFrom(part, static_cast<const QKeyEvent&>(*event))) return true;
      break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

bool RowStop::goFrom(qsizetype part, const QKeyEvent& key) {
  const bool row = along_ == Qt::Horizontal;
  const bool forward = key.key() == (row ? Qt::Key_Right : Qt::Key_Down);
  if (!forward && key.key() != (row ? Qt::Key_Left : Qt::Key_Up)) return false;
  if ((key.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier || !leavesText(*parts_[part].widget, forward)) {
    return false;
  }
  for (qsizetype next = part + (forward ? 1 : -1); next >= 0 && next < parts_.size(); next += forward ? 1 : -1) {
    if (!canStop(next)) continue;
    parts_[next].widget->setFocus(Qt::TabFocusReason);
    return true;
  }
  return true;
}

FoldingRow::FoldingRow(QBoxLayout* first, QBoxLayout* second, QWidget* parent)
    : QWidget(parent), first_(first), second_(second), parts_(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  parts_->setContentsMargins({});
  parts_->setSpacing(theme::kGrid);
  parts_->addLayout(first, 1);
  parts_->addLayout(second);
}

QSize FoldingRow::minimumSizeHint() const {
  return {std::max(first_->minimumSize().width(), second_->minimumSize().width()), parts_->minimumSize().height()};
}

void FoldingRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fold();
}

bool FoldingRow::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) fold();
  return QWidget::event(event);
}

void FoldingRow::fold() {
  const int needed = first_->sizeHint().width() + parts_->spacing() + second_->minimumSize().width();
  const auto direction = width() < needed ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (parts_->direction() == direction) return;
  parts_->setDirection(direction);
  updateGeometry();
}

namespace {

class WholeContents : public QObject {
 public:
  explicit WholeContents(QWidget& window) : QObject(&window), window_(window) { window.installEventFilter(this); }

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest)
      QTimer::singleShot(0, this, &WholeContents::grow);
    return QObject::eventFilter(watched, event);
  }

 private:
  void grow() {
    const QLayout& layout = *window_.layout();
    const int needed =
        layout.hasHeightForWidth() ? layout.totalHeightForWidth(window_.width()) : layout.totalMinimumSize().height();
    if (needed > window_.height()) window_.resize(window_.width(), needed);
  }

  QWidget& window_;
};

}  // namespace

void keepWhole(QWidget& window) { new WholeContents(window); }

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

QTabWidget* makeTabs(QWidget* parent) {
  auto* tabs = new QTabWidget(parent);
  new TabLook(*tabs->tabBar());
  tabs->setDocumentMode(true);
  return tabs;
}

}  // namespace tactus::workbench
