// Draws a force word: the label of a rule's consequent on the color of its term, with the marks of the rule. Cells,
// buttons and lists use it.
#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

class QPainter;

namespace tactus::workbench {

struct ForceWord {
  QString word;
  QColor color;           ///< of the term
  bool enabled = true;    ///< false: an outline with the word struck out
  double weight = 1;      ///< shown if below 1
  bool conflict = false;  ///< true: an exclamation mark in the corner
  double strength = 0;    ///< strength of the rule here; > 0: a bar at the left
};

/// Fills `place`; uses the font of the painter.
void paintForceWord(QPainter& painter, const QRectF& place, const ForceWord& word);

/// Paints a cell without an answer.
void paintNoWord(QPainter& painter, const QRectF& place);

}  // namespace tactus::workbench
