#include "core/base/tables/csv_splitter.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::base {
namespace {

// No real row is longer; garbage without line ends is refused before it is split into cells.
constexpr std::size_t kLongestLine = std::size_t{1} << 20U;

/// The first line that is neither empty nor a comment, at most kLongestLine of it.
std::string_view firstLine(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, std::min(text.find_first_of("\r\n"), kLongestLine));
    if (!line.empty() && line.front() != '#') return line;
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return text;
}

}  // namespace

CsvDialect csvDialect(std::string_view text) {
  CsvDialect dialect;
  const std::string_view line = firstLine(text);
  if (line.size() == 5 && line.starts_with("sep=")) {
    dialect.separator = line.back();
    dialect.begin = static_cast<std::size_t>(line.data() - text.data()) + line.size();
    return dialect;
  }
  bool in_quotes = false;
  bool commas = false;
  bool semicolons = false;
  bool tabs = false;
  bool bars = false;
  bool carets = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') in_quotes = !in_quotes;
    if (in_quotes) continue;
    const bool between_digits = i > 0 && i + 1 < line.size() && isDigit(line[i - 1]) && isDigit(line[i + 1]);
    commas = commas || (line[i] == ',' && !between_digits);
    semicolons = semicolons || line[i] == ';';
    tabs = tabs || line[i] == '\t';
    bars = bars || line[i] == '|';
    carets = carets || line[i] == '^';
  }
  if (!commas && semicolons) dialect.separator = ';';
  if (!commas && !semicolons && tabs) dialect.separator = '\t';
  const bool usual = commas || semicolons || tabs;
  if (!usual && bars) dialect.separator = '|';
  if (!usual && !bars && carets) dialect.separator = '^';
  return dialect;
}

CsvSplitter::CsvSplitter(std::string& text, const CsvDialect& dialect)
    : text_(text), separator_(dialect.separator), at_(dialect.begin) {
  line_ += static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
}

Result<bool> CsvSplitter::next(std::vector<std::string_view>& cells) {
  skipToRecord();
  if (at_ >= text_.size()) return false;
  begun_ = true;
  record_line_ = line_;
  saw_quotes_ = false;
  cells.clear();
  const std::size_t start = at_;
  while (true) {
    TACTUS_TRY(auto cell, at_ < text_.size() && text_[at_] == '"' ? quotedCell() : plainCell());
    cells.push_back(cell);
    if (at_ - start > kLongestLine) {
      return fail(ErrorCode::kLimit, linePlace(), "a line of more than 1 MiB", "rows of comma-separated cells");
    }
    if (at_ < text_.size() && text_[at_] == separator_) {
      ++at_;
      continue;
    }
    endLine();
    return true;
  }
}

void CsvSplitter::endLine() {
  if (at_ < text_.size() && text_[at_] == '\r') ++at_;
  if (at_ < text_.size() && text_[at_] == '\n') ++at_;
  ++line_;
}

/// Past empty lines and, before the first record, comments. Later a # begins a cell: no row may vanish.
void CsvSplitter::skipToRecord() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#' && !begun_) {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (text_[at_] != '\n' && text_[at_] != '\r') {
      return;
    }
    endLine();
  }
}

bool CsvSplitter::endsCell() const { return text_[at_] == separator_ || text_[at_] == '\n' || text_[at_] == '\r'; }

Result<std::string_view> CsvSplitter::plainCell() {
  const std::size_t start = at_;
  const std::size_t limit = std::min(text_.size(), start + kLongestLine + 1);
  while (at_ < limit && !endsCell()) ++at_;
  const std::size_t size = at_ - start;
  if (out_ != start) std::memmove(text_.data() + out_, text_.data() + start, size);
  return taken(size);
}

Result<std::string_view> CsvSplitter::quotedCell() {
  saw_quotes_ = true;
  const std::size_t start = ++at_;
  std::size_t size = 0;
  const std::size_t limit = std::min(text_.size(), start + kLongestLine);
  while (at_ < limit) {
    if (text_[at_] == '"') {
      ++at_;
      const bool doubled = at_ < text_.size() && text_[at_] == '"';
      if (!doubled) {
        if (at_ != text_.size() && !endsCell())
          return fail(ErrorCode::kSyntax, linePlace(), "text after a closing quote", "a comma or the end of the line");
        return taken(size);
      }
    }
    if (text_[at_] == '\n') ++line_;
    text_[out_ + size++] = text_[at_++];
  }
  return fail(ErrorCode::kSyntax, linePlace(), "an opening quote without its end", "a closing quote");
}

/// The cell of `size` bytes at out_.
std::string_view CsvSplitter::taken(std::size_t size) {
  const auto cell = std::string_view(text_).substr(out_, size);
  out_ += size + 1;
  return cell;
}

}  // namespace tactus::base
