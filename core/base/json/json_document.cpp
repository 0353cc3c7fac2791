#include "core/base/json/json_document.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::base {
namespace {

struct Token {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool string = false;
};

bool isOfWord(char c) {
  return isDigit(c) || isLetter(c) || isBeyondAscii(c) || c == '-' || c == '+' || c == '.' || c == '_';
}

/// Index after the string that begins at `begin`, or the end of the text.
std::size_t endOfString(std::string_view text, std::size_t begin) {
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

/// The last string, word, number or sign that begins at or before `last`.
Token tokenAt(std::string_view text, std::size_t last) {
  Token token;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r\n", at)) <= last) {
    token = {at, at + 1, text[at] == '"'};
    if (token.string) token.end = endOfString(text, at);
    while (isOfWord(text[at]) && token.end < text.size() && isOfWord(text[token.end])) ++token.end;
    at = token.end;
    if (at >= text.size()) break;
  }
  return token;
}

/// Whether the bytes up to `last`, with the whole character that begins or continues there, are not UTF-8.
bool isBrokenUtf8(std::string_view text, std::size_t last) {
  std::size_t end = last + 1;
  for (int more = 0; more < 3 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U; ++more)
    ++end;
  return !isUtf8(text.substr(0, end));
}

}  // namespace

std::string linePlace(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::string_view line = before.substr(before.rfind('\n') + 1);
  const auto characters =
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(characters + 1);
}

Error syntaxError(std::string_view text, std::size_t position) {
  const auto error = [&](std::size_t at, std::string found, std::string wanted) {
    return Error{ErrorCode::kSyntax, {}, linePlace(text, at), std::move(found), std::move(wanted)};
  };
  if (position > text.size()) return error(text.size(), "the end of the text", "the rest of the JSON");
  const std::size_t last = position > 0 ? position - 1 : 0;
  if (isBrokenUtf8(text, last)) {
    std::size_t first = last;
    while (!isUtf8(text.substr(0, first))) --first;
    return error(first, "bytes that are not UTF-8", "JSON in UTF-8");
  }

  const Token token = tokenAt(text, last);
  if (token.string && last > token.begin && last + 1 < token.end) {
    if (static_cast<unsigned char>(text[last]) < 0x20) {
      return error(last, "the control character " + base::quoted(text.substr(last, 1)) + " in a string",
                   "an escape such as \\n, or the end of the string");
    }
    return error(last, "an unknown escape in a string", "one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX");
  }

  const std::string_view word = text.substr(token.begin, token.end - token.begin);
  const std::string plain = lowered(word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0));
  if (plain.starts_with("nan") || plain.starts_with("inf")) {
    return error(token.begin, base::quoted(word), "a number: JSON has no NaN and no infinity");
  }
  const std::size_t before = text.substr(0, token.begin).find_last_not_of(" \t\r\n");
  if (before != std::string_view::npos && text[before] == ',' && (word == "]" || word == "}")) {
    return error(before, "a comma before " + base::quoted(word), "no comma after the last value");
  }
  return error(token.begin, token.string ? "the string " + base::quoted(word) : base::quoted(word), "correct JSON");
}

std::string childPointer(const std::string& place, std::string_view key) {
  std::string out = place + '/';
  for (const char c : key) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

std::string childPointer(const std::string& place, std::size_t index) { return place + '/' + std::to_string(index); }

/// Receives the parser's events and appends nodes; stops at the first error.
class JsonBuilder : public nlohmann::json::json_sax_t {
 public:
  explicit JsonBuilder(std::string_view text) : text_(text) {}

  Result<JsonDocument> take() {
    if (error_) return tl::unexpected(std::move(*error_));
    return std::move(document_);
  }

  bool null() override { return scalar(JsonKind::kNull, {}); }
  bool boolean(bool value) override { return scalar(value ? JsonKind::kTrue : JsonKind::kFalse, {}); }
  bool number_integer(number_integer_t value) override {
    // The parser calls this for negative numbers alone, so 0 stood there as -0, which is another double.
    return scalar(JsonKind::kNumber, value == 0 ? "-0" : std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override { return scalar(JsonKind::kNumber, std::to_string(value)); }
  bool number_float(number_float_t, const string_t& digits) override {
    // The parser puts the locale's decimal point into the digits.
    std::string plain = digits;
    const auto point = plain.find_first_not_of("+-0123456789eE");
    if (point != std::string::npos) plain[point] = '.';
    if (!parseNumber(plain)) return refuseRange(plain);
    return scalar(JsonKind::kNumber, plain);
  }
  bool string(string_t& value) override { return scalar(JsonKind::kString, value); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(JsonKind::kObject); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(JsonKind::kArray); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.key = name;
    if (level.keys.insert(name).second) return true;
    return refuse(ErrorCode::kSchema, pointer(), "the key " + base::quoted(name) + " twice", "each key once");
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& what) override {
    constexpr int kNumberOverflow = 406;
    if (what.id == kNumberOverflow) return refuseRange(token);
    error_ = syntaxError(text_, position);
    return false;
  }

 private:
  struct Level {
    std::uint32_t node;
    bool object;
    std::size_t count = 0;
    std::string key;
    std::set<std::string, std::less<>> keys;
  };

  bool refuse(ErrorCode code, std::string place, std::string found, std::string wanted) {
    error_ = Error{code, {}, std::move(place), std::move(found), std::move(wanted)};
    return false;
  }

  bool refuseRange(const std::string& digits) {
    return refuse(ErrorCode::kValue, pointer(), "the number " + base::quoted(digits),
                  "a number in the range of a double");
  }

  /// Pointer of the value that comes next.
  std::string pointer() const {
    std::string place;
    for (const Level& level : levels_) {
      place = level.object ? childPointer(place, level.key) : childPointer(place, level.count);
    }
    return place;
  }

  JsonDocument::Node& append(JsonKind kind) {
    JsonDocument::Node& node = document_.nodes_.emplace_back();
    node.kind = kind;
    node.next = static_cast<std::uint32_t>(document_.nodes_.size());
    if (!levels_.empty() && levels_.back().object) {
      node.key_begin = static_cast<std::uint32_t>(document_.pool_.size());
      node.key_size = static_cast<std::uint32_t>(levels_.back().key.size());
      document_.pool_ += levels_.back().key;
    }
    return node;
  }

  bool scalar(JsonKind kind, std::string_view text) {
    if (levels_.empty()) return refuseRoot();
    JsonDocument::Node& node = append(kind);
    node.text_begin = static_cast<std::uint32_t>(document_.pool_.size());
    node.text_size = static_cast<std::uint32_t>(text.size());
    document_.pool_ += text;
    ++levels_.back().count;
    return true;
  }

  bool open(JsonKind kind) {
    if (levels_.empty() && kind != JsonKind::kObject) return refuseRoot();
    if (levels_.size() == JsonDocument::kDeepest) {
      return refuse(ErrorCode::kLimit, childPointer({}, levels_.front().key), "values nested deeper than the limit",
                    "at most " + std::to_string(JsonDocument::kDeepest) + " levels");
    }
    const auto index = static_cast<std::uint32_t>(document_.nodes_.size());
    append(kind);
    levels_.push_back({index, kind == JsonKind::kObject, 0, {}, {}});
    return true;
  }

  bool close() {
    document_.nodes_[levels_.back().node].next = static_cast<std::uint32_t>(document_.nodes_.size());
    levels_.pop_back();
    if (!levels_.empty()) ++levels_.back().count;
    return true;
  }

  bool refuseRoot() { return refuse(ErrorCode::kSchema, {}, "JSON that is not an object", "an object"); }

  std::string_view text_;
  JsonDocument document_;
  std::vector<Level> levels_;
  std::optional<Error> error_;
};

Result<JsonDocument> JsonDocument::parse(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  TACTUS_CHECK(text.size() < 0xFFFFFFFFU);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return fail(ErrorCode::kSyntax, {}, "an empty text", "JSON");
  }
  // The parser would take a zero byte for the end of the text.
  if (const auto zero = text.find('\0'); zero != std::string_view::npos) {
    return fail(ErrorCode::kSyntax, linePlace(text, zero), "a zero byte", "JSON in UTF-8");
  }
  JsonBuilder builder(text);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

JsonValue JsonDocument::root() const { return {this, 0}; }

double JsonValue::number() const {
  const auto value = parseNumber(text());
  TACTUS_CHECK(kind() == JsonKind::kNumber && value);
  return *value;
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  for (const JsonValue child : *this) {
    if (child.key() == key) return child;
  }
  return std::nullopt;
}

std::string JsonValue::pointer() const {
  std::string place;
  JsonValue at(document_, 0);
  while (at.index_ != index_) {
    std::size_t position = 0;
    JsonValue next = *at.begin();
    while (next.node().next <= index_) {
      next = {document_, next.node().next};
      ++position;
    }
    place = at.kind() == JsonKind::kObject ? childPointer(place, next.key()) : childPointer(place, position);
    at = next;
  }
  return place;
}

std::string JsonValue::description() const {
  switch (kind()) {
    case JsonKind::kNull: return "null";
    case JsonKind::kTrue: return "true";
    case JsonKind::kFalse: return "false";
    case JsonKind::kNumber: return "the number " + std::string(text().substr(0, 40));
    case JsonKind::kString: return "the string " + base::quoted(text());
    case JsonKind::kArray: return "an array";
    case JsonKind::kObject: return "an object";
  }
  return {};
}

namespace {

void append(JsonWriter& json, const JsonValue& value) {
  using Layout = JsonWriter::Layout;
  switch (value.kind()) {
    case JsonKind::kNull: json.null(); break;
    case JsonKind::kTrue:
    case JsonKind::kFalse: json.value(value.kind() == JsonKind::kTrue); break;
    case JsonKind::kNumber: json.raw(value.text()); break;
    case JsonKind::kString: json.value(value.text()); break;
    case JsonKind::kArray:
      json.beginArray(Layout::kInline);
      for (const JsonValue child : value) append(json, child);
      json.endArray();
      break;
    case JsonKind::kObject:
      json.beginObject(Layout::kInline);
      for (const JsonValue child : value) append(json.key(child.key()), child);
      json.endObject();
      break;
  }
}

}  // namespace

std::string JsonValue::json() const {
  JsonWriter writer;
  append(writer, *this);
  std::string text = writer.text();
  text.pop_back();  // the final newline
  return text;
}

}  // namespace tactus::base
