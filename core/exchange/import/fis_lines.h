// The lines of a FIS file: `[Section]`, `key=value`, and values such as `'low':'trimf',[0 1 2]`.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/exchange/import/source_text.h"

namespace tactus::exchange {

/// Reads a line from left to right. Blanks between the parts do not matter.
class LineCursor {
 public:
  explicit LineCursor(Word line) : line_(line) {}

  bool atEnd();
  /// The place of the next part.
  std::size_t at();
  /// Takes `sign` if it comes next.
  bool takeIf(char sign);
  /// The text between quotes, `'` or `"`; nothing if no quoted text comes next.
  std::optional<Word> takeQuoted();
  /// The characters up to a blank or one of `, ; : ( ) [ ]`; empty where there are none.
  Word takeWord();
  /// What remains, for a message.
  std::string_view rest();

 private:
  void skipBlanks();

  Word line_;
  std::size_t next_ = 0;
};

/// `[0 1 2]` or `[0, 1, 2]`: calls `add(Word)` for each word in it. False where the brackets are missing.
template <class Add>
bool takeList(LineCursor& line, Add add) {
  if (!line.takeIf('[')) return false;
  while (!line.takeIf(']')) {
    if (line.takeIf(',') || line.takeIf(';')) continue;
    const Word word = line.takeWord();
    if (word.text.empty()) return false;
    add(word);
  }
  return true;
}

}  // namespace tactus::exchange
