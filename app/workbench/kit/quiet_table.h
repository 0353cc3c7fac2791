// How tables look in the workbench: no grid, no frame, small heads, smooth scrolling, and Tab leads out of them.
#pragma once

#include <QTableView>

class QPainter;
class QStyleOptionViewItem;

namespace tactus::workbench {

/// A table of `model` without row heads, whose heads are words alone. One row can be selected.
QTableView* makeQuietTable(QAbstractItemModel& model, const QString& accessible_name, QWidget* parent);

/// Cells are read whole: long ones wrap, and the rows are as high as their text, with room between them.
void readWhole(QTableView& view);

/// The ground of a cell whose contents a delegate paints itself: whether its row is selected.
void paintGround(QPainter& painter, const QStyleOptionViewItem& option);

}  // namespace tactus::workbench
