// The Fusion style with visible edges of fields. Fusion derives the edges from the color of the window, which gives a
// contrast of 1.3 to a card; 3 is wanted (WCAG 2.1, 1.4.11). Fusion cuts the words of a choice or a button that is too
// narrow; here they end in an ellipsis. Fusion leaves 3 px beside the words of a button; here it is as much as inside a
// card.
#pragma once

#include <QColor>
#include <QProxyStyle>

namespace tactus::workbench::theme {

/// Edge of fields to type in, of choices, of check boxes and of round buttons: contrast at least 3 to cards, window and
/// buttons.
QColor fieldEdge();

class FieldStyle : public QProxyStyle {
  Q_OBJECT

 public:
  FieldStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
};

}  // namespace tactus::workbench::theme
