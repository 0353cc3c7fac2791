#include "core/exchange/import/fis_lines.h"

#include <algorithm>

namespace tactus::exchange {

void LineCursor::skipBlanks() { next_ = std::min(line_.text.size(), line_.text.find_first_not_of(" \t", next_)); }

bool LineCursor::atEnd() {
  skipBlanks();
  return next_ == line_.text.size();
}

std::size_t LineCursor::at() {
  skipBlanks();
  return line_.at + next_;
}

bool LineCursor::takeIf(char sign) {
  if (atEnd() || line_.text[next_] != sign) return false;
  ++next_;
  return true;
}

std::optional<Word> LineCursor::takeQuoted() {
  if (atEnd()) return std::nullopt;
  const char quote = line_.text[next_];
  if (quote != '\'' && quote != '"') return std::nullopt;
  const std::size_t end = line_.text.find(quote, next_ + 1);
  if (end == std::string_view::npos) return std::nullopt;
  const Word out{line_.text.substr(next_ + 1, end - next_ - 1), line_.at + next_ + 1};
  next_ = end + 1;
  return out;
}

Word LineCursor::takeWord() {
  skipBlanks();
  const std::size_t end = std::min(line_.text.size(), line_.text.find_first_of(" \t,;:()[]", next_));
  const Word out{line_.text.substr(next_, end - next_), line_.at + next_};
  next_ = end;
  return out;
}

std::string_view LineCursor::rest() {
  skipBlanks();
  return line_.text.substr(next_);
}

}  // namespace tactus::exchange
