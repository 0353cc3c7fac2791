#include "core/base/csv.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

#include "core/base/check.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace tactus::base {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 31U;
// No real row is longer; garbage without line ends is refused before it is split into cells.
constexpr std::size_t kLongestLine = std::size_t{1} << 20U;

/// Splits a buffer into records. The cells move together in place, unquoted, with one byte between neighbours: that
/// never needs more room than the text had, and one offset says where a cell starts and where the one before ends.
class Splitter {
 public:
  explicit Splitter(std::string& text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  /// Reads the next record into `cells`; false at the end of the text.
  Result<bool> next(std::vector<std::string_view>& cells) {
    skipToRecord();
    if (at_ >= text_.size()) return false;
    begun_ = true;
    record_line_ = line_;
    cells.clear();
    const std::size_t start = at_;
    while (true) {
      auto cell = at_ < text_.size() && text_[at_] == '"' ? quotedCell() : plainCell();
      if (!cell) return tl::unexpected(cell.error());
      cells.push_back(*cell);
      if (at_ - start > kLongestLine) {
        return fail(ErrorCode::kLimit, linePlace(), "a line of more than 1 MiB", "rows of comma-separated cells");
      }
      if (at_ < text_.size() && text_[at_] == ',') {
        ++at_;
        continue;
      }
      endLine();
      return true;
    }
  }

  std::size_t recordLine() const { return record_line_; }
  /// Where the next cell would start.
  std::size_t end() const { return out_; }

 private:
  std::string linePlace() const { return "line " + std::to_string(record_line_); }

  void endLine() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
  }

  /// Past empty lines and, before the first record, comments. Later a # begins a cell: no row may vanish.
  void skipToRecord() {
    while (at_ < text_.size()) {
      if (text_[at_] == '#' && !begun_) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_[at_] != '\n' && text_[at_] != '\r') {
        return;
      }
      endLine();
    }
  }

  Result<std::string_view> plainCell() {
    const std::size_t start = at_;
    const std::size_t limit = std::min(text_.size(), start + kLongestLine + 1);
    while (at_ < limit && text_[at_] != ',' && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    const std::size_t size = at_ - start;
    if (out_ != start) std::memmove(text_.data() + out_, text_.data() + start, size);
    return taken(size);
  }

  Result<std::string_view> quotedCell() {
    const std::size_t start = ++at_;
    std::size_t size = 0;
    const std::size_t limit = std::min(text_.size(), start + kLongestLine);
    while (at_ < limit) {
      if (text_[at_] == '"') {
        ++at_;
        const bool doubled = at_ < text_.size() && text_[at_] == '"';
        if (!doubled) {
          const bool ends = at_ == text_.size() || text_[at_] == ',' || text_[at_] == '\n' || text_[at_] == '\r';
          if (!ends)
            return fail(ErrorCode::kSyntax, linePlace(), "text after a closing quote",
                        "a comma or the end of the line");
          return taken(size);
        }
      }
      if (text_[at_] == '\n') ++line_;
      text_[out_ + size++] = text_[at_++];
    }
    return fail(ErrorCode::kSyntax, linePlace(), "an opening quote without its end", "a closing quote");
  }

  /// The cell of `size` bytes at out_.
  std::string_view taken(std::size_t size) {
    const auto cell = std::string_view(text_).substr(out_, size);
    out_ += size + 1;
    return cell;
  }

  std::string& text_;
  std::size_t at_ = 0;
  std::size_t out_ = 0;  // never beyond at_
  std::size_t line_ = 1;
  std::size_t record_line_ = 1;
  bool begun_ = false;
};

}  // namespace

Result<void> CsvTable::takeHeader(const std::vector<std::string_view>& names, std::size_t line) {
  const std::string place = "line " + std::to_string(line);
  for (const std::string_view name : names) {
    const std::string column(trimmed(name));
    if (column.empty()) return fail(ErrorCode::kSchema, place, "a column without a name", "a name for every column");
    if (find(column)) {
      return fail(ErrorCode::kSchema, place, "column " + quoted(column) + " twice", "each column once");
    }
    columns_.push_back(column);
  }
  return {};
}

Result<void> CsvTable::takeRow(const std::vector<std::string_view>& cells, std::size_t line) {
  if (cells.size() != columns_.size()) {
    return fail(ErrorCode::kSchema, "line " + std::to_string(line), std::to_string(cells.size()) + " cells",
                std::to_string(columns_.size()) + " as in the first line");
  }
  for (const auto cell : cells) starts_.push_back(static_cast<std::uint32_t>(cell.data() - text_->data()));
  const bool consecutive = !jumps_.empty() && line - jumps_.back().line == rows_ - jumps_.back().row;
  if (!consecutive) jumps_.push_back({static_cast<std::uint32_t>(rows_), static_cast<std::uint32_t>(line)});
  ++rows_;
  return {};
}

Result<void> CsvTable::fill(std::string& text, Header header) {
  if (text.size() > kMostBytes) return fail(ErrorCode::kLimit, {}, "more than 2 GiB", "a smaller table");
  if (!isUtf8(text)) return fail(ErrorCode::kSyntax, {}, "bytes that are not UTF-8 text", "a CSV table in UTF-8");
  has_mark_ = text.starts_with("\xEF\xBB\xBF");
  const auto ends_cell = [](char c) { return c == ',' || c == '\n'; };
  // Never too few, so that the vector does not grow by copies; what stays unused is never touched.
  starts_.reserve(static_cast<std::size_t>(std::count_if(text.begin(), text.end(), ends_cell)) + 2);
  Splitter splitter(text);
  std::vector<std::string_view> record;
  bool first = true;
  while (true) {
    const auto more = splitter.next(record);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    if (first) {
      const auto is_number = [](std::string_view cell) { return parseNumber(trimmed(cell)).has_value(); };
      has_header_ = header == Header::kRequired || !std::all_of(record.begin(), record.end(), is_number);
      for (std::size_t i = 0; !has_header_ && i < record.size(); ++i) columns_.push_back(std::to_string(i + 1));
    }
    const bool is_header = first && has_header_;
    auto taken = is_header ? takeHeader(record, splitter.recordLine()) : takeRow(record, splitter.recordLine());
    if (!taken) return taken;
    first = false;
  }
  if (first) return fail(ErrorCode::kSchema, {}, "an empty table", "a header line with the names of the columns");
  starts_.push_back(static_cast<std::uint32_t>(splitter.end()));
  return {};
}

Result<CsvTable> CsvTable::parse(std::string text, std::string file, Header header) {
  const auto buffer = std::make_shared<std::string>(std::move(text));
  CsvTable table;
  table.text_ = buffer;
  if (auto filled = table.fill(*buffer, header); !filled) return inFile(filled.error(), file);
  table.file_ = std::move(file);
  return table;
}

Result<CsvTable> CsvTable::read(const std::string& path, Header header) {
  auto text = readFile(path, kMostBytes);
  if (!text) return tl::unexpected(text.error());
  return parse(std::move(*text), path, header);
}

std::optional<std::size_t> CsvTable::find(std::string_view name) const {
  const auto it = std::find(columns_.begin(), columns_.end(), name);
  if (it == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(it - columns_.begin());
}

Result<std::size_t> CsvTable::require(std::string_view name) const {
  if (const auto column = find(name)) return *column;
  std::string names;
  for (const auto& column : columns_) {
    names += (names.empty() ? "" : ", ") + quoted(column);
    if (names.size() > 200) {
      names += ", …";
      break;
    }
  }
  return tl::unexpected(Error{ErrorCode::kSchema, file_, "header", "the columns " + names, "a column " + quoted(name)});
}

Result<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const auto value = parseNumber(trimmed(cell(row, column)));
  if (!value || !std::isfinite(*value)) return refuse(row, column, ErrorCode::kValue, "a finite number");
  return *value;
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
  return "line " + std::to_string(line(row)) + ", column " + quoted(columns_[column]);
}

tl::unexpected<Error> CsvTable::refuse(std::size_t row, std::size_t column, ErrorCode code, std::string wanted) const {
  const auto text = cell(row, column);
  return tl::unexpected(
      Error{code, file_, place(row, column), text.empty() ? "an empty cell" : quoted(text), std::move(wanted)});
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
