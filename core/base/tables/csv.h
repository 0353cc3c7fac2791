// CSV tables (RFC 4180) with a header, commas, and UTF-8 with or without a byte order mark. Also reads spreadsheet
// variants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::base {

// Decides whether commas in the cells of a table are decimal points.

/// Counts the kinds of commas in a table, cell by cell.
class DecimalCommas {
 public:
  enum class Cell {
    kOther,      ///< not a number with a comma
    kDecimal,    ///< `1,5`, `0,125`, `-12,50`, `1,5e3`: the comma must be a decimal point
    kEither,     ///< `1,234`: a thousands separator or a decimal point
    kThousands,  ///< `1,234,567`, `1,234.5`
    kPoint,      ///< a number with a decimal point
  };
  static Cell kindOf(std::string_view cell);

  void add(std::string_view cell);

  /// Whether all commas between digits are decimal points: at least one must be, none must be a thousands separator,
  /// and no number has a decimal point.
  bool decimal() const { return decimal_ > 0 && thousands_ == 0 && points_ == 0; }

 private:
  std::size_t decimal_ = 0;
  std::size_t thousands_ = 0;
  std::size_t points_ = 0;
};

/// A table read from CSV. The cells are views into one buffer owned by the table. Each cell costs four bytes besides
/// its text, so millions of rows fit into memory.
class CsvTable {
 public:
  enum class Header {
    kRequired,  ///< the first line has the names of the columns
    kOptional,  ///< a first line of numbers only is data; the columns are then called 1, 2, …
  };

  /// Reads `text`, said to be of `file` in errors. Lines that start with `#` before the first record are
  /// comments; empty lines, rows of empty cells and empty columns at the end are skipped. Where it is plain, tables of
  /// other spreadsheets are read too, and `readAs` says so: semicolons or tabs (csv_splitter.h), decimal commas
  /// (csv.h; the cells then hold points), other encodings (text_encoding.h).
  /// Refused: no header, a doubled or empty column name, a row with another number of cells than the header, the header
  /// again below, an open
  /// quote, text of no known encoding, a line longer than 1 MiB, more than 2 GiB.
  static Result<CsvTable> parse(std::string text, std::string file, Header header = Header::kRequired);

  /// Reads the file `path` of at most 2 GiB, or a pipe or device up to kMostPipeBytes (file.h).
  static Result<CsvTable> read(const std::string& path, Header header = Header::kRequired);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& columns() const { return columns_; }
  bool hasHeader() const { return has_header_; }
  /// Whether the text began with a byte order mark, as written for spreadsheet programs.
  bool hasMark() const { return has_mark_; }
  /// The variant of the table, e.g. `semicolons between the cells, decimal commas`; empty for a plain table.
  const std::string& readAs() const { return read_as_; }
  /// `file` and `readAs` as a sentence; nothing for a plain table.
  std::optional<std::string> note() const;
  std::size_t rowCount() const { return rows_; }

  /// Index of the column `name`, or of the only column whose columnKey is `name`; nothing if there is none.
  std::optional<std::size_t> find(std::string_view name) const;
  /// Index of the column `name`. Returns an error with the list of columns if it is missing.
  Result<std::size_t> require(std::string_view name) const;

  /// The text of a cell, including spaces at its ends.
  std::string_view cell(std::size_t row, std::size_t column) const {
    const std::size_t at = row * columns_.size() + column;
    return std::string_view(*text_).substr(starts_[at], starts_[at + 1] - 1 - starts_[at]);
  }
  /// The cell as a finite number. Returns an error with line, column and text otherwise.
  Result<double> number(std::size_t row, std::size_t column) const;
  /// The cell as an integer. Returns an error otherwise.
  Result<long long> integer(std::size_t row, std::size_t column) const;

  /// The first line of the row, from 1.
  std::size_t line(std::size_t row) const;
  /// `line 12, column 'speed_mm_s'`, for errors in a cell.
  std::string place(std::size_t row, std::size_t column) const;
  /// An error in a cell: its place, its text, and `wanted`.
  tl::unexpected<Error> refuse(std::size_t row, std::size_t column, ErrorCode code, std::string wanted) const;

 private:
  Result<void> fill(std::string& text, Header header);
  void readCommas(std::string& text);
  Result<void> takeHeader(const std::vector<std::string_view>& names, std::size_t line);
  Result<void> takeRow(const std::vector<std::string_view>& cells, std::size_t line);

  /// A row after which the line numbers are not consecutive.
  struct LineJump {
    std::uint32_t row;
    std::uint32_t line;
  };

  std::string file_;
  std::shared_ptr<const std::string> text_;
  std::vector<std::string> columns_;
  std::size_t header_cells_ = 0;  // including empty ones at the end
  std::string read_as_;
  bool has_header_ = true;
  bool has_mark_ = false;
  // The start of each cell in *text_, row by row, plus one more. A cell ends one byte before the start of the next.
  std::vector<std::uint32_t> starts_;
  std::vector<LineJump> jumps_;
  std::size_t rows_ = 0;
};

/// Whether a spreadsheet program may execute the cell as a formula: it begins with = + - @, a tab or a carriage return.
bool looksLikeFormula(std::string_view cell) noexcept;

/// The expected content in the error for such a text.
inline constexpr const char* kNoFormula = "a name that does not begin with = + - @, a tab or a carriage return";

/// The cell for a spreadsheet program: with an apostrophe in front if the cell, or its text after leading apostrophes,
/// looks like a formula. `withoutGuard` restores the original.
std::string guarded(std::string_view cell);
std::string_view withoutGuard(std::string_view cell) noexcept;

/// The standard spelling of a column name: lower-case letters and digits, all other characters replaced by one
/// underscore.
/// `Speed [mm/s]` gives `speed_mm_s`.
std::string columnKey(std::string_view name);

/// Builds CSV text row by row. Quotes a cell only if necessary.
class CsvWriter {
 public:
  explicit CsvWriter(std::span<const std::string> columns);
  CsvWriter(std::initializer_list<std::string_view> columns);

  CsvWriter& cell(std::string_view text);
  CsvWriter& cell(double value);
  CsvWriter& cell(long long value);
  CsvWriter& cell(std::size_t value) { return cell(static_cast<long long>(value)); }
  CsvWriter& cell(int value) { return cell(static_cast<long long>(value)); }
  /// Ends the row. The row must have one cell per column (checked as our own bug).
  void endRow();

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t columns_ = 0;
  std::size_t filled_ = 0;
};

}  // namespace tactus::base
