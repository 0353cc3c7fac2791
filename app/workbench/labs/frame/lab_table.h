// How tables look in the labs: no grid, small heads, smooth scrolling.
#pragma once

#include <QTableView>

namespace tactus::workbench {

/// A table of `model`, without row heads, as wide as its place; `stretched`: the column that takes the room, -1: each
/// column has its width and the last one takes the rest.
QTableView* makeLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name, QWidget* parent);

}  // namespace tactus::workbench
