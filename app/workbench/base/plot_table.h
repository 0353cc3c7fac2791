// The contents of a plot as a table, with its settings in words: for a CSV file, the clipboard and a picture's caption.
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
  /// An empty cell, a number or a word.
  using Cell = std::variant<std::monostate, double, std::string>;

  QString file;                      ///< proposed file name with its folder, without an extension
  QStringList caption;               ///< lines: the model and the subject of the plot, then the settings
  std::vector<std::string> columns;  ///< unique names, with the unit: `depth_mm`
  std::vector<std::vector<Cell>> rows;
};

/// An id and its unit in small letters, the form of CSV column names: `depth_mm`, `force_n`. A ratio has no unit.
std::string columnName(const std::string& id, const std::string& unit);
std::string columnName(const fuzzy::Variable& variable);
/// The force of one expert: `force_S1_n`. The column of the mean is columnName(output).
std::string columnName(const fuzzy::Variable& output, const fuzzy::Expert& expert);

/// The force as a cell; empty if no rule fires.
PlotTable::Cell forceCell(const fuzzy::Evaluation& force);

/// CSV (RFC 4180) with the caption as lines that start with `#`; numbers are the shortest text that reads back.
std::string csvText(const PlotTable& table);
/// The same with tabs between the cells, the format that spreadsheets paste.
std::string tabText(const PlotTable& table);

}  // namespace tactus::workbench
