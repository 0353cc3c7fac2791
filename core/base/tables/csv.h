// CSV tables (RFC 4180): a header, commas, UTF-8 with or without a byte order mark; and as spreadsheets save them.
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

/// A table read from CSV. The cells are views into one buffer that the table keeps alive; beside the text each cell
/// costs four bytes, so millions of rows fit into memory.
class CsvTable {
 public:
  enum class Header {
    kRequired,  ///< the first line holds the names of the columns
    kOptional,  ///< a first line of nothing but numbers is data, and the columns are called 1, 2, …
  };

  /// Reads `text`, said to be of `file` in errors. Lines that start with `#` before the first record are
  /// comments; empty lines, rows of empty cells and empty columns at the end are skipped. Where it is plain, tables of
  /// other spreadsheets are read too, and `readAs` says so: semicolons or tabs (csv_splitter.h), decimal commas
  /// (decimal_comma.h; the cells then hold points), other encodings (text_encoding.h).
  /// Refused: no header, a doubled or empty column name, a row with another number of cells than the header, the header
  /// again below, an open
  /// quote, text of no known encoding, a line longer than 1 MiB, more than 2 GiB.
  static Result<CsvTable> parse(std::string text, std::string file, Header header = Header::kRequired);

  /// Reads the file `path` of at most 2 GiB; from a pipe or device at most kMostPipeBytes (file.h).
  static Result<CsvTable> read(const std::string& path, Header header = Header::kRequired);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& columns() const { return columns_; }
  bool hasHeader() const { return has_header_; }
  /// Whether the text began with a byte order mark, as tables for spreadsheet programs do.
  bool hasMark() const { return has_mark_; }
  /// How the table was read where it is no plain one: `semicolons between the cells, decimal commas`; otherwise empty.
  const std::string& readAs() const { return read_as_; }
  /// `file` and `readAs` as a sentence, or nothing.
  std::optional<std::string> note() const;
  std::size_t rowCount() const { return rows_; }

  /// Index of the column `name`, or of the only one that columnKey makes it; or nothing.
  std::optional<std::size_t> find(std::string_view name) const;
  /// Index of the column `name`; its absence is an error that lists the columns there are.
  Result<std::size_t> require(std::string_view name) const;

  /// The cell as text, spaces at the ends kept.
  std::string_view cell(std::size_t row, std::size_t column) const {
    const std::size_t at = row * columns_.size() + column;
    return std::string_view(*text_).substr(starts_[at], starts_[at + 1] - 1 - starts_[at]);
  }
  /// The cell as a finite number, or an error with line, column and text.
  Result<double> number(std::size_t row, std::size_t column) const;
  /// The cell as an integer, or an error.
  Result<long long> integer(std::size_t row, std::size_t column) const;

  /// The line that the row begins on, from 1.
  std::size_t line(std::size_t row) const;
  /// `line 12, column 'speed_mm_s'`, for errors about a cell.
  std::string place(std::size_t row, std::size_t column) const;
  /// An error about a cell: its place, its text, and what was wanted.
  tl::unexpected<Error> refuse(std::size_t row, std::size_t column, ErrorCode code, std::string wanted) const;

 private:
  Result<void> fill(std::string& text, Header header);
  void readCommas(std::string& text);
  Result<void> takeHeader(const std::vector<std::string_view>& names, std::size_t line);
  Result<void> takeRow(const std::vector<std::string_view>& cells, std::size_t line);

  /// Where the lines of the rows stop being consecutive.
  struct LineJump {
    std::uint32_t row;
    std::uint32_t line;
  };

  std::string file_;
  std::shared_ptr<const std::string> text_;
  std::vector<std::string> columns_;
  std::size_t header_cells_ = 0;  // with the empty ones at the end
  std::string read_as_;
  bool has_header_ = true;
  bool has_mark_ = false;
  // Row by row where each cell starts in *text_, and one more: a cell ends one byte before the next one starts.
  std::vector<std::uint32_t> starts_;
  std::vector<LineJump> jumps_;
  std::size_t rows_ = 0;
};

/// Whether a spreadsheet program may take the cell for a formula and run it: it begins with = + - @, a tab or a
/// carriage return.
bool looksLikeFormula(std::string_view cell) noexcept;

/// What is wanted where such a text is refused.
inline constexpr const char* kNoFormula = "a name that does not begin with = + - @, a tab or a carriage return";

/// The cell for a spreadsheet program: with an apostrophe in front where it, or what stands behind its apostrophes,
/// looks like a formula. `withoutGuard` gives back what it was.
std::string guarded(std::string_view cell);
std::string_view withoutGuard(std::string_view cell) noexcept;

/// A column's name as the formats write it: small letters and digits, everything else one underscore.
/// `Speed [mm/s]` gives `speed_mm_s`.
std::string columnKey(std::string_view name);

/// Builds CSV text: rows in, text out; cells are quoted only where they must be.
class CsvWriter {
 public:
  explicit CsvWriter(std::span<const std::string> columns);
  CsvWriter(std::initializer_list<std::string_view> columns);

  CsvWriter& cell(std::string_view text);
  CsvWriter& cell(double value);
  CsvWriter& cell(long long value);
  CsvWriter& cell(std::size_t value) { return cell(static_cast<long long>(value)); }
  CsvWriter& cell(int value) { return cell(static_cast<long long>(value)); }
  /// Ends the row. The number of cells must be the number of columns (a check of our own code).
  void endRow();

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t columns_ = 0;
  std::size_t filled_ = 0;
};

}  // namespace tactus::base
