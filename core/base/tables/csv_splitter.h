// Splits the text of a CSV table into cells, in place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::base {

/// How the cells of a table are separated.
struct CsvDialect {
  char separator = ',';
  std::size_t begin = 0;  ///< where the table begins: behind a line `sep=;`
};

/// The dialect of `text` (UTF-8): semicolons or tabs where the first line has them, and no commas but between digits;
/// otherwise commas. A first line `sep=;` decides it.
CsvDialect csvDialect(std::string_view text);

/// Splits a buffer into records. The cells move together in place, unquoted, with one byte between neighbours: that
/// never needs more room than the text had, and one offset says where a cell starts and where the one before ends.
class CsvSplitter {
 public:
  CsvSplitter(std::string& text, const CsvDialect& dialect);

  /// Reads the next record into `cells`; false at the end of the text. Lines that start with # before the first record
  /// and empty lines are passed over. Refused: an open quote, text after a closing one, a line longer than 1 MiB.
  Result<bool> next(std::vector<std::string_view>& cells);

  /// Gives the room of `cell` and of the cells behind it back: cells of the record that was read last.
  void drop(std::string_view cell) { out_ = static_cast<std::size_t>(cell.data() - text_.data()); }

  std::size_t recordLine() const { return record_line_; }
  /// Whether the record that was read last has a cell in quotes.
  bool sawQuotes() const { return saw_quotes_; }
  /// Where the next cell would start.
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
  std::size_t out_ = 0;  // never beyond at_
  std::size_t line_ = 1;
  std::size_t record_line_ = 1;
  bool begun_ = false;
  bool saw_quotes_ = false;
};

}  // namespace tactus::base
