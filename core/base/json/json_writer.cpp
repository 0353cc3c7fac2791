#include "core/base/json/json_writer.h"

#include <cmath>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::base {

std::string jsonString(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    // U+FFFD stands for what is no text.
    const char32_t code = character.valid ? character.code : 0xFFFD;
    if (code == '"' || code == '\\') {
      out += '\\';
      out += static_cast<char>(code);
    } else if (code == '\n') {
      out += "\\n";
    } else if (code == '\r') {
      out += "\\r";
    } else if (code == '\t') {
      out += "\\t";
    } else if (!character.valid || isControl(code)) {
      out += "\\u";
      for (const unsigned shift : {12U, 8U, 4U, 0U}) out += kHex[(code >> shift) & 15U];
    } else {
      out += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return out + '"';
}

std::string jsonNumber(double value) { return std::isfinite(value) ? formatNumber(value) : "null"; }

JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  text_ += jsonString(name) + ": ";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::values(std::span<const double> numbers) {
  beginArray(Layout::kInline);
  for (const double number : numbers) value(number);
  return endArray();
}

JsonWriter& JsonWriter::values(std::span<const std::string> texts) {
  beginArray(Layout::kInline);
  for (const auto& text : texts) value(text);
  return endArray();
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  separate();
  text_ += json;
  return *this;
}

std::string JsonWriter::text() const {
  TACTUS_CHECK(levels_.empty());
  return text_ + '\n';
}

JsonWriter& JsonWriter::begin(char bracket, Layout layout) {
  separate();
  // Inside a line everything is on that line.
  if (!levels_.empty() && levels_.back().layout == Layout::kInline) layout = Layout::kInline;
  text_ += bracket;
  levels_.push_back({layout});
  return *this;
}

JsonWriter& JsonWriter::end(char bracket) {
  TACTUS_CHECK(!levels_.empty() && !after_key_);
  const Level level = levels_.back();
  levels_.pop_back();
  if (!level.empty) {
    if (level.layout == Layout::kBlock) {
      newline();
    } else if (bracket == '}') {
      text_ += ' ';
    }
  }
  text_ += bracket;
  return *this;
}

void JsonWriter::separate() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (levels_.empty()) return;
  Level& level = levels_.back();
  if (!level.empty) text_ += ',';
  if (level.layout == Layout::kBlock) {
    newline();
  } else if (!level.empty || text_.back() == '{') {
    text_ += ' ';
  }
  level.empty = false;
}

void JsonWriter::newline() {
  text_ += '\n';
  text_.append(2 * levels_.size(), ' ');
}

}  // namespace tactus::base
