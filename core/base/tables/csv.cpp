#include "core/base/tables/csv.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv_splitter.h"
#include "core/base/tables/odd_cell.h"
#include "core/base/tables/text_encoding.h"
#include "core/base/text.h"

namespace tactus::base {
namespace {

/// Groups of three digits behind the first comma, two or more or with a decimal point behind them: `1,234,567.8`.
bool hasThousands(std::string_view number) {
  const std::size_t point = number.find('.');
  std::string_view groups = number.substr(0, point);
  const auto commas = std::count(groups.begin(), groups.end(), ',');
  if (commas == 0 || (commas == 1 && point == std::string_view::npos)) return false;
  const std::size_t first = groups.find(',');
  if (first == 0 || first > 3 || groups.size() - first != 4 * static_cast<std::size_t>(commas)) return false;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const bool comma_here = i >= first && (i - first) % 4 == 0;
    if (comma_here ? groups[i] != ',' : !isDigit(groups[i])) return false;
  }
  return true;
}

}  // namespace

DecimalCommas::Cell DecimalCommas::kindOf(std::string_view cell) {
  std::string_view number = trimmed(cell);
  if (number.find(',') == std::string_view::npos) {
    const bool point = number.find('.') != std::string_view::npos;
    return point && parseNumber(number) ? Cell::kPoint : Cell::kOther;
  }
  if (number.starts_with('-')) number.remove_prefix(1);
  if (number.size() > 40) return Cell::kOther;
  if (hasThousands(number)) return Cell::kThousands;
  std::string plain(number);
  const std::size_t comma = plain.find(',');
  plain[comma] = '.';
  const bool digits = comma > 0 && comma + 1 < plain.size() && isDigit(plain[comma - 1]) && isDigit(plain[comma + 1]);
  if (!digits || !parseNumber(plain)) return Cell::kOther;
  const std::string_view after = number.substr(comma + 1);
  const bool group = after.size() == 3 && std::all_of(after.begin(), after.end(), isDigit);
  const bool can_be_thousands = group && comma <= 3 && number.front() != '0';
  return can_be_thousands ? Cell::kEither : Cell::kDecimal;
}

void DecimalCommas::add(std::string_view cell) {
  switch (kindOf(cell)) {
    case Cell::kDecimal: ++decimal_; break;
    case Cell::kThousands: ++thousands_; break;
    case Cell::kPoint: ++points_; break;
    case Cell::kEither:
    case Cell::kOther: break;
  }
}

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 31U;
/// Cells up to the last one that is not empty.
std::size_t filledCells(const std::vector<std::string_view>& cells) {
  const auto last =
      std::find_if(cells.rbegin(), cells.rend(), [](std::string_view cell) { return !trimmed(cell).empty(); });
  return static_cast<std::size_t>(cells.rend() - last);
}

std::string separatorName(char separator) {
  if (separator == ';') return "semicolons between the cells";
  if (separator == '\t') return "tabs between the cells";
  if (separator == '|') return "vertical bars between the cells";
  if (separator == '^') return "carets between the cells";
  return base::quoted(std::string(1, separator)) + " between the cells";
}

}  // namespace

Result<void> CsvTable::takeHeader(const std::vector<std::string_view>& names, std::size_t line) {
  const std::string place = "line " + std::to_string(line);
  header_cells_ = names.size();
  const std::size_t named = std::max<std::size_t>(filledCells(names), 1);
  for (std::size_t i = 0; i < named; ++i) {
    const std::string column(trimmed(names[i]));
    if (column.empty()) return fail(ErrorCode::kSchema, place, "a column without a name", "a name for every column");
    if (std::find(columns_.begin(), columns_.end(), column) != columns_.end()) {
      return fail(ErrorCode::kSchema, place, "column " + base::quoted(column) + " twice", "each column once");
    }
    columns_.push_back(column);
  }
  return {};
}

Result<void> CsvTable::takeRow(const std::vector<std::string_view>& cells, std::size_t line) {
  const std::size_t filled = filledCells(cells);
  if (cells.size() < columns_.size() || filled > columns_.size()) {
    const bool beside = filled > columns_.size() && filled <= header_cells_;
    std::string wanted = std::to_string(columns_.size()) + " as in the first line";
    if (beside) wanted = "a name for every column that holds something";
    if (!beside && filled > columns_.size()) wanted += " (decimal commas? then semicolons between the cells)";
    return fail(ErrorCode::kSchema, "line " + std::to_string(line), std::to_string(cells.size()) + " cells",
                std::move(wanted));
  }
  const auto is_name = [](std::string_view cell, const std::string& column) { return trimmed(cell) == column; };
  const bool header = has_header_ && columns_.size() > 1 && is_name(cells[0], columns_[0]) &&
                      std::equal(columns_.begin(), columns_.end(), cells.begin(),
                                 [&is_name](const std::string& column, auto cell) { return is_name(cell, column); });
  if (header) {
    return fail(ErrorCode::kSchema, "line " + std::to_string(line), "the header again", "it once, in the first line");
  }
  for (std::size_t i = 0; i < columns_.size(); ++i)
    starts_.push_back(static_cast<std::uint32_t>(cells[i].data() - text_->data()));
  const bool consecutive = !jumps_.empty() && line - jumps_.back().line == rows_ - jumps_.back().row;
  if (!consecutive) jumps_.push_back({static_cast<std::uint32_t>(rows_), static_cast<std::uint32_t>(line)});
  ++rows_;
  return {};
}

/// Writes points where commas are decimal ones.
void CsvTable::readCommas(std::string& text) {
  DecimalCommas commas;
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_.size(); ++column) commas.add(cell(row, column));
  }
  if (!commas.decimal()) return;
  for (std::size_t i = 0; i + 1 < starts_.size(); ++i) {
    const std::string_view here(text.data() + starts_[i], starts_[i + 1] - 1 - starts_[i]);
    const auto kind = DecimalCommas::kindOf(here);
    if (kind != DecimalCommas::Cell::kDecimal && kind != DecimalCommas::Cell::kEither) continue;
    text[starts_[i] + here.find(',')] = '.';
  }
  read_as_ += (read_as_.empty() ? "" : ", ") + std::string("decimal commas");
}

Result<void> CsvTable::fill(std::string& text, Header header) {
  const CsvDialect dialect = csvDialect(text);
  if (dialect.separator != ',') read_as_ = separatorName(dialect.separator);
  const auto ends_cell = [&dialect](char c) { return c == dialect.separator || c == '\n'; };
  // Never too few, so that the vector does not grow by copies; what stays unused is never touched.
  starts_.reserve(static_cast<std::size_t>(std::count_if(text.begin(), text.end(), ends_cell)) + 2);
  CsvSplitter splitter(text, dialect);
  std::vector<std::string_view> record;
  bool first = true;
  while (true) {
    TACTUS_TRY(const auto more, splitter.next(record));
    if (!more) break;
    if (first) {
      const auto is_number = [](std::string_view cell) {
        const auto kind = DecimalCommas::kindOf(cell);
        return kind == DecimalCommas::Cell::kDecimal || kind == DecimalCommas::Cell::kEither ||
               parseNumber(trimmed(cell)).has_value();
      };
      has_header_ = header == Header::kRequired || !std::all_of(record.begin(), record.end(), is_number);
      for (std::size_t i = 0; !has_header_ && i < record.size(); ++i) columns_.push_back(std::to_string(i + 1));
    }
    const bool is_header = first && has_header_;
    first = false;
    if (is_header) {
      if (auto taken = takeHeader(record, splitter.recordLine()); !taken) return taken;
      continue;
    }
    // Spreadsheets write rows of empty cells; a single cell, or one in quotes, is meant.
    const bool is_empty = record.size() > 1 && filledCells(record) == 0 && !splitter.sawQuotes();
    if (!is_empty) {
      if (auto taken = takeRow(record, splitter.recordLine()); !taken) return taken;
    }
    const std::size_t kept = is_empty ? 0 : columns_.size();
    if (kept < record.size()) splitter.drop(record[kept]);
  }
  if (first) return fail(ErrorCode::kSchema, {}, "an empty table", "a header line with the names of the columns");
  starts_.push_back(static_cast<std::uint32_t>(splitter.end()));
  // Where commas separate cells, one in a cell is part of a text, or of a number that is uncertain.
  if (dialect.separator != ',') readCommas(text);
  return {};
}

Result<CsvTable> CsvTable::parse(std::string text, std::string file, Header header) {
  if (text.size() > kMostBytes) return inFile({ErrorCode::kLimit, {}, {}, "more than 2 GiB", "a smaller table"}, file);
  const bool has_mark = text.starts_with("\xEF\xBB\xBF");
  auto decoded = decodeText(std::move(text));
  if (!decoded) return inFile(decoded.error(), file);
  // Another encoding can take more room in UTF-8.
  if (decoded->text.size() > kMostBytes)
    return inFile({ErrorCode::kLimit, {}, {}, "more than 2 GiB of text", "a smaller table"}, file);
  const auto buffer = std::make_shared<std::string>(std::move(decoded->text));
  CsvTable table;
  table.text_ = buffer;
  table.has_mark_ = has_mark;
  if (auto filled = table.fill(*buffer, header); !filled) return inFile(filled.error(), file);
  table.file_ = std::move(file);
  if (!decoded->encoding.empty()) {
    table.read_as_ += (table.read_as_.empty() ? "text in " : ", text in ") + decoded->encoding;
  }
  return table;
}

Result<CsvTable> CsvTable::read(const std::string& path, Header header) {
  TACTUS_TRY(auto text, readFile(path, kMostBytes));
  return parse(std::move(text), path, header);
}

std::optional<std::size_t> CsvTable::find(std::string_view name) const {
  const auto place = [this](auto it) { return static_cast<std::size_t>(it - columns_.begin()); };
  const auto it = std::find(columns_.begin(), columns_.end(), name);
  if (it != columns_.end()) return place(it);
  const auto is_same = [name](const std::string& column) { return columnKey(column) == name; };
  const auto like = std::find_if(columns_.begin(), columns_.end(), is_same);
  if (like == columns_.end() || std::find_if(std::next(like), columns_.end(), is_same) != columns_.end())
    return std::nullopt;
  return place(like);
}

std::optional<std::string> CsvTable::note() const {
  if (read_as_.empty()) return std::nullopt;
  return file_ + ": read with " + read_as_;
}

Result<std::size_t> CsvTable::require(std::string_view name) const {
  if (const auto column = find(name)) return *column;
  return tl::unexpected(Error{ErrorCode::kSchema, file_, "header", "the columns " + listed(columns_),
                              "a column " + base::quoted(name) + suggestion(name, columns_)});
}

Result<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const auto value = parseNumber(trimmed(cell(row, column)));
  if (value && std::isfinite(*value)) return *value;
  return refuse(row, column, ErrorCode::kValue, numberWanted(cell(row, column)));
}

Result<long long> CsvTable::integer(std::size_t row, std::size_t column) const {
  const auto value = parseInteger(trimmed(cell(row, column)));
  if (!value) return refuse(row, column, ErrorCode::kValue, "an integer");
  return *value;
}

std::size_t CsvTable::line(std::size_t row) const {
  const auto after = std::upper_bound(jumps_.begin(), jumps_.end(), row,
                                      [](std::size_t wanted, const LineJump& jump) { return wanted < jump.row; });
  const LineJump& jump = *std::prev(after);
  return jump.line + (row - jump.row);
}

std::string CsvTable::place(std::size_t row, std::size_t column) const {
  return "line " + std::to_string(line(row)) + ", column " + base::quoted(columns_[column]);
}

tl::unexpected<Error> CsvTable::refuse(std::size_t row, std::size_t column, ErrorCode code, std::string wanted) const {
  const auto text = cell(row, column);
  return tl::unexpected(
      Error{code, file_, place(row, column), text.empty() ? "an empty cell" : base::quoted(text), std::move(wanted)});
}

bool looksLikeFormula(std::string_view cell) noexcept {
  return !cell.empty() && std::string_view("=+-@\t\r").find(cell.front()) != std::string_view::npos;
}

std::string guarded(std::string_view cell) {
  const auto behind = cell.substr(std::min(cell.find_first_not_of('\''), cell.size()));
  return looksLikeFormula(behind) ? '\'' + std::string(cell) : std::string(cell);
}

std::string_view withoutGuard(std::string_view cell) noexcept {
  const auto behind = cell.substr(std::min(cell.find_first_not_of('\''), cell.size()));
  return cell.starts_with('\'') && looksLikeFormula(behind) ? cell.substr(1) : cell;
}

std::string columnKey(std::string_view name) {
  std::string key;
  for (const char c : lowered(name)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      key += c;
    } else if (!key.empty() && key.back() != '_') {
      key += '_';
    }
  }
  if (key.ends_with('_')) key.pop_back();
  return key;
}

CsvWriter::CsvWriter(std::span<const std::string> columns) : columns_(columns.size()) {
  for (const auto& column : columns) cell(column);
  endRow();
}

CsvWriter::CsvWriter(std::initializer_list<std::string_view> columns) : columns_(columns.size()) {
  for (const auto column : columns) cell(column);
  endRow();
}

CsvWriter& CsvWriter::cell(std::string_view text) {
  if (filled_++ > 0) text_ += ',';
  // A line that is empty or starts with # would be skipped on reading.
  const bool skipped = (text.empty() && columns_ == 1) || text.starts_with('#');
  if (text.find_first_of(",\"\r\n") == std::string_view::npos && !skipped) {
    text_ += text;
    return *this;
  }
  text_ += '"';
  for (const char c : text) {
    if (c == '"') text_ += '"';
    text_ += c;
  }
  text_ += '"';
  return *this;
}

CsvWriter& CsvWriter::cell(double value) { return cell(std::string_view(formatNumber(value))); }

CsvWriter& CsvWriter::cell(long long value) { return cell(std::string_view(std::to_string(value))); }

void CsvWriter::endRow() {
  TACTUS_CHECK(filled_ == columns_);
  text_ += '\n';
  filled_ = 0;
}

}  // namespace tactus::base
