#include "app/workbench/base/plot_table.h"

#include <algorithm>
#include <cctype>

#include "core/base/tables/csv.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

// `mm/s` becomes `mm_s`: what is no letter or digit in a unit separates its parts.
std::string unitWord(const std::string& unit) {
  if (unit == "1") return {};
  std::string word;
  for (const char c : unit) {
    const bool plain = static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) {
      word += c;
    } else if (!word.empty() && word.back() != '_') {
      word += '_';
    }
  }
  return base::lowered(word);
}

std::string captionLines(const PlotTable& table) {
  std::string out;
  for (QString line : table.caption) {
    // A name may hold a line break, and what follows it must not become data.
    line.replace(QLatin1Char('\r'), QLatin1Char(' ')).replace(QLatin1Char('\n'), QLatin1Char(' '));
    out += "# " + line.toStdString() + '\n';
  }
  return out;
}

std::string wordFor(const PlotTable::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return base::formatNumber(*number);
  const auto* word = std::get_if<std::string>(&cell);
  return word ? *word : std::string();
}

// A tab or a line break inside a cell would shift the others.
std::string flat(std::string word) {
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return word;
}

}  // namespace

std::string columnName(const std::string& id, const std::string& unit) {
  const std::string word = unitWord(unit);
  return word.empty() ? id : id + '_' + word;
}

std::string columnName(const fuzzy::Variable& variable) { return columnName(variable.id, variable.unit); }

std::string columnName(const fuzzy::Variable& output, const fuzzy::Expert& expert) {
  return columnName(output.id + '_' + expert.id, output.unit);
}

PlotTable::Cell forceCell(const fuzzy::Evaluation& force) {
  if (!force.fired) return {};
  return force.force_n;
}

std::string csvText(const PlotTable& table) {
  base::CsvWriter writer(table.columns);
  for (const auto& row : table.rows) {
    for (const PlotTable::Cell& cell : row) writer.cell(wordFor(cell));
    writer.endRow();
  }
  return captionLines(table) + writer.text();
}

std::string tabText(const PlotTable& table) {
  std::string out = captionLines(table) + base::joined(table.columns, "\t") + '\n';
  for (const auto& row : table.rows) {
    std::string separator;
    for (const PlotTable::Cell& cell : row) {
      out += separator + flat(wordFor(cell));
      separator = "\t";
    }
    out += '\n';
  }
  return out;
}

}  // namespace tactus::workbench
