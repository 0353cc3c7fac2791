#include "app/workbench/base/field_style.h"

#include <QPainter>
#include <QStyleOption>
#include <QTabWidget>
#include <algorithm>

#include "app/workbench/base/theme.h"

namespace tactus::workbench::theme {
namespace {

constexpr double kRound = 2;         // px, as in Fusion
constexpr int kBesideWords = kGrid;  // px, of a button

// Focus has a frame of its own, and what is disabled may be pale.
bool wantsEdge(const QStyleOption& option) {
  return option.state.testFlag(QStyle::State_Enabled) && !option.state.testFlag(QStyle::State_HasFocus);
}

void drawEdge(QPainter& painter, const QRectF& place, double round) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(fieldEdge(), 1));
  painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), round, round);
  painter.restore();
}

QString shortened(const QString& text, const QFontMetrics& metrics, int room) {
  return metrics.elidedText(text, Qt::ElideRight, room, Qt::TextShowMnemonic);
}

}  // namespace

QColor fieldEdge() { return isDark() ? QColor(0x7A, 0x86, 0x92) : QColor(0x7D, 0x88, 0x94); }

FieldStyle::FieldStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void FieldStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
  // There is no line below tabs (kit/tab_look.h), so there is none below what stands beside them.
  if (element == PE_FrameTabBarBase && qobject_cast<const QTabWidget*>(widget) != nullptr) return;
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (!wantsEdge(*option)) return;
  if (element == PE_FrameLineEdit) drawEdge(*painter, option->rect, kRound);
  if (element == PE_IndicatorCheckBox) drawEdge(*painter, option->rect, 0);
  if (element == PE_IndicatorRadioButton) drawEdge(*painter, option->rect, option->rect.height() / 2.0);
}

void FieldStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
  constexpr int kBesideIcon = 4;  // px, as in Fusion
  if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
      box != nullptr && element == CE_ComboBoxLabel) {
    QStyleOptionComboBox fitting = *box;
    int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - 2;
    if (!box->currentIcon.isNull()) room -= box->iconSize.width() + kBesideIcon;
    // An ampersand is none here.
    fitting.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
    QProxyStyle::drawControl(element, &fitting, painter, widget);
    return;
  }
  if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
      button != nullptr && element == CE_PushButtonLabel) {
    QStyleOptionButton fitting = *button;
    int room = button->rect.width();
    if (!button->icon.isNull()) room -= button->iconSize.width() + kBesideIcon;
    if (button->features.testFlag(QStyleOptionButton::HasMenu)) {
      room -= pixelMetric(PM_MenuButtonIndicator, button, widget);
    }
    fitting.text = shortened(button->text, button->fontMetrics, room);
    QProxyStyle::drawControl(element, &fitting, painter, widget);
    return;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

void FieldStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const {
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (!wantsEdge(*option)) return;
  if (control == CC_ComboBox) {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (box != nullptr && box->frame) drawEdge(*painter, option->rect, kRound);
  }
  if (control == CC_SpinBox) {
    const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
    // Fusion leaves a line above and below.
    if (box != nullptr && box->frame) drawEdge(*painter, QRectF(option->rect).adjusted(0, 1, 0, -1), kRound);
  }
}

QSize FieldStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                   const QWidget* widget) const {
  QSize out = QProxyStyle::sizeFromContents(type, option, size, widget);
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
  if (type == CT_PushButton && button != nullptr && !button->text.isEmpty()) {
    out.setWidth(std::max(out.width(), size.width() + 2 * kBesideWords));
  }
  return out;
}

}  // namespace tactus::workbench::theme
