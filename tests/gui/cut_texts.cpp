#include "tests/gui/cut_texts.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <cmath>

#include "tests/gui/text_recorder.h"

namespace tactus::tests {
namespace {

constexpr double kSlack = 2;      // px, of rounding
constexpr double kBearing = 0.2;  // of the height of a line: above and below the
                                  // letters nothing is drawn
const QChar kEllipsis(0x2026);

QString textOf(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  if (const auto* choice = qobject_cast<const QComboBox*>(&widget)) return choice->currentText();
  if (const auto* number = qobject_cast<const QAbstractSpinBox*>(&widget)) return number->text();
  return {};
}

QString nameOf(const QWidget& widget) {
  const QWidget* panel = &widget;
  while (panel->parentWidget() != nullptr && panel->objectName().isEmpty()) panel = panel->parentWidget();
  return QLatin1String(widget.metaObject()->className()) + QStringLiteral(" in ") +
         QLatin1String(panel->metaObject()->className()) + QLatin1Char(' ') + panel->objectName();
}

bool scrolls(const QScrollBar& bar, Qt::ScrollBarPolicy policy) {
  return policy != Qt::ScrollBarAlwaysOff && bar.maximum() > bar.minimum();
}

/// Whether a scroll bar around `widget` leads to what is beyond an edge.
bool isReachable(const QWidget& widget, Qt::Orientation along) {
  for (const QWidget* up = &widget; up != nullptr; up = up->parentWidget()) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(up);
    if (area == nullptr) continue;
    if (along == Qt::Horizontal ? scrolls(*area->horizontalScrollBar(), area->horizontalScrollBarPolicy())
                                : scrolls(*area->verticalScrollBar(), area->verticalScrollBarPolicy())) {
      return true;
    }
  }
  return false;
}

/// What is beyond the edges of `clip`, in words; empty: nothing.
QString beyond(const QRectF& box, const QRectF& clip, const QWidget& widget, double slack_y) {
  QStringList out;
  if (!isReachable(widget, Qt::Horizontal)) {
    if (box.left() < clip.left() - kSlack) out << QStringLiteral("left");
    if (box.right() > clip.right() + kSlack) out << QStringLiteral("right %1 px").arg(box.right() - clip.right());
  }
  if (!isReachable(widget, Qt::Vertical)) {
    if (box.top() < clip.top() - slack_y) out << QStringLiteral("top");
    if (box.bottom() > clip.bottom() + slack_y) out << QStringLiteral("bottom %1 px").arg(box.bottom() - clip.bottom());
  }
  return out.join(QStringLiteral(", "));
}

/// Widgets whose place lies beyond an edge of one around them: they may not
/// even be painted.
void addMisplaced(QWidget& window, QStringList& out) {
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    const QString text = textOf(*widget);
    if (!widget->isVisible() || text.trimmed().isEmpty() || widget->window() != &window) continue;
    for (const QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget()) {
      const QRect place(widget->mapTo(up, QPoint()), widget->size());
      const QString where = beyond(place, up->rect(), *widget, kSlack);
      if (where.isEmpty()) continue;
      out << QStringLiteral("%1 \"%2\": place beyond %3").arg(nameOf(*widget), text, where);
      break;
    }
  }
}

/// What wrote the text that is seen at `seen`. The last px of a row of a table may lie on the edge of its viewport.
const QWidget* paintedBy(const QWidget& window, const QRectF& seen) {
  // Of a text that is scrolled away but for a px, a rounded place would lie beyond the area that scrolls.
  const auto pixelAt = [](const QPointF& place) {
    return QPoint(static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())));
  };
  for (const QPointF& place : {seen.center(), seen.topLeft()}) {
    const QWidget* widget = window.childAt(pixelAt(place));
    if (widget != nullptr && qobject_cast<const QAbstractScrollArea*>(widget->parentWidget()) != nullptr) return widget;
  }
  return window.childAt(pixelAt(seen.center()));
}

bool mustBeWhole(const QWidget& widget) {
  return qobject_cast<const QAbstractButton*>(&widget) != nullptr || qobject_cast<const QTabBar*>(&widget) != nullptr;
}

QString wholeTexts(const QWidget& widget) {
  const auto* tabs = qobject_cast<const QTabBar*>(&widget);
  if (tabs == nullptr) return textOf(widget).remove(QLatin1Char('&'));
  QString all;
  for (int i = 0; i < tabs->count(); ++i) all += tabs->tabText(i);
  return all;
}

}  // namespace

QStringList cutTexts(QWidget& window) {
  QStringList out;
  addMisplaced(window, out);
  for (const WrittenText& written : textsOf(window)) {
    if (written.text.trimmed().isEmpty()) continue;
    const QRectF seen = written.box & written.clip;
    if (seen.isEmpty()) continue;  // scrolled away, or a widget whose place is beyond an edge
    const QWidget* widget = paintedBy(window, seen);
    if (widget == nullptr) widget = &window;
    const QString where = beyond(written.box, written.clip, *widget, kSlack + kBearing * written.box.height());
    if (!where.isEmpty()) {
      out << QStringLiteral("%1 \"%2\": cut %3").arg(nameOf(*widget), written.text, where);
    } else if (mustBeWhole(*widget) && written.text.contains(kEllipsis) &&
               !wholeTexts(*widget).contains(written.text)) {
      out << QStringLiteral("%1 \"%2\": shortened").arg(nameOf(*widget), written.text);
    }
  }
  out.removeDuplicates();
  return out;
}

}  // namespace tactus::tests
