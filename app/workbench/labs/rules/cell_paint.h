// How a cell of the grids looks: a word, no word, not asked, or the newtons between the experts.
#pragma once

#include <QColor>
#include <QRectF>

#include "app/workbench/labs/rules/expert_grids.h"
#include "elicitation/agreement/conflict_map.h"

class QPainter;

namespace tactus::workbench {

/// `brief`: the initials of the word alone.
void paintAskedCell(QPainter& painter, const QRectF& place, const AskedCell& cell, const fuzzy::Variable& output,
                    bool brief);
/// `conflict`: null where no expert has a word. With fewer than two words there is nothing to compare.
void paintConflictCell(QPainter& painter, const QRectF& place, const elicitation::CellConflict* conflict);

/// The color of a distance in just-noticeable differences: the card at 0, a warning from 1 on.
QColor distanceColor(double noticeable);

}  // namespace tactus::workbench
