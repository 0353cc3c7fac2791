// What a widget writes: each piece of text with its place, font and clip, as the paint engine gets it. It sees labels,
// buttons and own painting alike.
#pragma once

#include <QFont>
#include <QPaintDevice>
#include <QRectF>
#include <QString>
#include <memory>
#include <vector>

class QWidget;

namespace tactus::tests {

struct WrittenText {
  QString text;
  QRectF box;   ///< from ascent to descent, px of the widget
  QRectF clip;  ///< what of it is seen
  QFont font;
};

/// Everything that `widget` and its children write when they are painted.
std::vector<WrittenText> textsOf(QWidget& widget);

}  // namespace tactus::tests
