#include "tests/bench/feel_results.h"

#include <algorithm>

#include "core/base/tables/csv.h"

#include "tests/bench/text_table.h"

namespace tactus::bench {
namespace {

using Row = std::vector<std::string>;

std::size_t placeOf(Row& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  const auto place = static_cast<std::size_t>(found - names.begin());
  if (found == names.end()) names.push_back(name);
  return place;
}

std::string tableOf(const FeelPart& part) {
  Row columns = {part.name};
  Row subjects;
  std::vector<Row> cells;
  for (const FeelFigure& figure : part.figures) {
    const std::size_t row = placeOf(subjects, figure.subject);
    const std::size_t column = placeOf(columns, figure.quantity + (figure.unit == "1" ? "" : ", " + figure.unit));
    cells.resize(subjects.size());
    if (cells[row].size() <= column) cells[row].resize(column + 1, "-");
    cells[row][column] = threeDigits(figure.value);
  }
  std::vector<Row> rows = {columns};
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    cells[i].front() = subjects[i];
    cells[i].resize(columns.size(), "-");
    rows.push_back(cells[i]);
  }
  return alignedTable(rows, 1);
}

}  // namespace

std::string feelTables(const FeelResults& results) {
  std::string text;
  for (const auto& line : results.circumstances) text += line + '\n';
  for (const FeelPart& part : results.parts) {
    text += '\n' + part.title + "\n\n" + tableOf(part);
    if (!part.notes.empty()) text += '\n';
    for (const auto& note : part.notes) text += note + '\n';
  }
  return text;
}

std::string feelCsv(const FeelResults& results) {
  base::CsvWriter csv({"part", "subject", "quantity", "unit", "value"});
  for (const FeelPart& part : results.parts) {
    for (const FeelFigure& figure : part.figures) {
      csv.cell(part.name).cell(figure.subject).cell(figure.quantity).cell(figure.unit).cell(figure.value);
      csv.endRow();
    }
  }
  return csv.text();
}

}  // namespace tactus::bench
