// The word of a rule's consequent on the color of its term, with the marks of the rule: how cells, buttons and lists
// show it.
#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

class QPainter;

namespace tactus::workbench {

struct ForceWord {
  QString word;
  QColor color;           ///< of the term
  bool enabled = true;    ///< otherwise an outline with the word struck out
  double weight = 1;      ///< shown where it is below 1
  bool conflict = false;  ///< an exclamation mark in the corner
  double strength = 0;    ///< how much the rule acts here; a bar at the left where it does
};

/// Fills `place`; uses the font of the painter.
void paintForceWord(QPainter& painter, const QRectF& place, const ForceWord& word);

/// A place without an answer.
void paintNoWord(QPainter& painter, const QRectF& place);

}  // namespace tactus::workbench
