// How tables look in the labs: quiet ones (kit/quiet_table.h) with roomy cells, as wide as their place.
#pragma once

#include <QTableView>

namespace tactus::workbench {

/// A table of `model`, without row heads, as wide as its place; `stretched`: the column that takes the room, -1: each
/// column has its width and the last one takes the rest.
QTableView* makeLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name, QWidget* parent);

/// Lets a click on a head sort the rows of `view`; at first, and after a third click, they stand in the model's order.
void sortByHeads(QTableView& view);

}  // namespace tactus::workbench
