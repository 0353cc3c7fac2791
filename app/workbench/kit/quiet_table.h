// How tables look in the workbench: no grid, no frame, small heads, smooth scrolling, and Tab leads out of them.
#pragma once

#include <QTableView>

namespace tactus::workbench {

/// A table of `model` without row heads, whose heads are words alone. One row can be selected.
QTableView* makeQuietTable(QAbstractItemModel& model, const QString& accessible_name, QWidget* parent);

/// Cells are read whole: long ones wrap, and the rows are as high as their text, with room between them.
void readWhole(QTableView& view);

}  // namespace tactus::workbench
