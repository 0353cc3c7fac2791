#include "core/study/table_line.h"

#include <filesystem>
#include <utility>

namespace tactus::study {

tl::unexpected<base::Error> atCell(base::Error error, const TableCell& cell, std::string found) {
  if (cell.line.number == 0) return tl::unexpected(std::move(error));
  error.file = cell.table;
  error.place = "line " + std::to_string(cell.line.number) + ", column " + base::quoted(cell.column);
  error.found = std::move(found);
  return tl::unexpected(std::move(error));
}

tl::unexpected<base::Error> inTable(base::Error error, std::string_view table, TableLine line) {
  if (line.number == 0) return tl::unexpected(std::move(error));
  return base::inFile(std::move(error), table);
}

tl::unexpected<base::Error> inStudyFolder(base::Error error, const std::string& folder) {
  error.file = error.file.empty() ? folder : (std::filesystem::path(folder) / error.file).string();
  return tl::unexpected(std::move(error));
}

}  // namespace tactus::study
