// Splits the text of a CSV table into cells, in place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::base {

/// The separator of a table's cells.
struct CsvDialect {
  char separator = ',';
  std::size_t begin = 0;  ///< start of the table: after a line `sep=;`
};

/// The dialect of `text` (UTF-8). A first line `sep=;` decides. Otherwise semicolons or tabs, if the first line has
/// them and has commas only between digits; vertical bars or carets, if it has none of these; else commas.
CsvDialect csvDialect(std::string_view text);

/// Splits a buffer into records. It moves the unquoted cells to the front of the buffer, with one byte between
/// neighbors. This never needs more space than the text had, and one offset gives the start of a cell and the end of
/// the previous one.
class CsvSplitter {
 public:
  CsvSplitter(std::string& text, const CsvDialect& dialect);

  /// Reads the next record into `cells`. Returns false at the end of the text. Skips empty lines, and lines that start
  /// with # before the first record. Returns an error for an open quote, text after a closing quote, or a line longer
  /// than 1 MiB.
  Result<bool> next(std::vector<std::string_view>& cells);

  /// Releases the space of `cell` and of the cells after it. Only for cells of the last record.
  void drop(std::string_view cell) { out_ = static_cast<std::size_t>(cell.data() - text_.data()); }

  std::size_t recordLine() const { return record_line_; }
  /// Whether the last record has a quoted cell.
  bool sawQuotes() const { return saw_quotes_; }
  /// The start of the next cell.
  std::size_t end() const { return out_; }

 private:
  std::string linePlace() const { return "line " + std::to_string(record_line_); }
  void endLine();
  void skipToRecord();
  bool endsCell() const;
  Result<std::string_view> plainCell();
  Result<std::string_view> quotedCell();
  std::string_view taken(std::size_t size);

  std::string& text_;
  char separator_;
  std::size_t at_ = 0;
  std::size_t out_ = 0;  // never greater than at_
  std::size_t line_ = 1;
  std::size_t record_line_ = 1;
  bool begun_ = false;
  bool saw_quotes_ = false;
};

}  // namespace tactus::base
