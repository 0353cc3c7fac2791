// What a plot shows as a table, with its settings in words: for a CSV file, the clipboard and the caption of a picture.
#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <variant>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

struct PlotTable {
  /// Nothing, a number or a word.
  using Cell = std::variant<std::monostate, double, std::string>;

  QString file;                      ///< proposal for the name of a file, with its folder and without an ending
  QStringList caption;               ///< lines: the model and what is shown, then the settings
  std::vector<std::string> columns;  ///< each once, with the unit in the name: `depth_mm`
  std::vector<std::vector<Cell>> rows;
};

/// `depth_mm`, `force_n`: an id and its unit, in small letters, as columns of CSV tables are called. A ratio has no
/// unit.
std::string columnName(const std::string& id, const std::string& unit);
std::string columnName(const fuzzy::Variable& variable);
/// The force of one expert: `force_S1_n`. The mean is columnName(output).
std::string columnName(const fuzzy::Variable& output, const fuzzy::Expert& expert);

/// The force as a cell: empty where no rule fires.
PlotTable::Cell forceCell(const fuzzy::Evaluation& force);

/// CSV (RFC 4180) with the caption as lines that start with `#`; numbers are the shortest text that reads back.
std::string csvText(const PlotTable& table);
/// The same with tabs between the cells, which a spreadsheet takes from the clipboard.
std::string tabText(const PlotTable& table);

}  // namespace tactus::workbench
