// How tables look in the workbench: no grid, no frame, small heads, smooth scrolling, and Tab leads out of them.
#pragma once

#include <QTableView>

namespace tactus::workbench {

/// A table of `model` without row heads, whose heads are words alone. One row can be selected.
QTableView* makeQuietTable(QAbstractItemModel& model, const QString& accessible_name, QWidget* parent);

}  // namespace tactus::workbench
