#include "app/cli/wrapped_text.h"

#include <algorithm>

#include "core/base/error.h"

namespace tactus::cli {
namespace {

std::string spacesBeside(std::string_view cell, std::size_t width, std::size_t gap) {
  const std::size_t taken = characters(cell);
  return std::string(std::max(width, taken + gap) - taken, ' ');
}

}  // namespace

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string wrapped(std::string_view sentence, std::string_view first, std::size_t indent) {
  const std::string harmless = base::oneLine(sentence);
  std::string_view text = harmless;
  std::string out(first);
  std::size_t column = characters(first);
  bool line_start = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t needed = characters(word) + (line_start ? 0 : 1);
    if (!line_start && column + needed > kTextColumns) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
      line_start = true;
    }
    if (!line_start) out += ' ';
    out += word;
    column += characters(word) + (line_start ? 0 : 1);
    line_start = false;
  }
  return out + '\n';
}

std::string padded(std::string_view text, std::size_t width, std::size_t gap) {
  const std::string cell = base::oneLine(text);
  return cell + spacesBeside(cell, width, gap);
}

std::string rightAligned(std::string_view text, std::size_t width, std::size_t gap) {
  const std::string cell = base::oneLine(text);
  return spacesBeside(cell, width, gap) + cell;
}

}  // namespace tactus::cli
