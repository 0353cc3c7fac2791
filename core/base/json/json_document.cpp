#include "core/base/json/json_document.h"

#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/json/json_pointer.h"
#include "core/base/json/json_syntax_error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::base {

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
    case JsonKind::kNull:
      return "null";
    case JsonKind::kTrue:
      return "true";
    case JsonKind::kFalse:
      return "false";
    case JsonKind::kNumber:
      return "the number " + std::string(text().substr(0, 40));
    case JsonKind::kString:
      return "the string " + base::quoted(text());
    case JsonKind::kArray:
      return "an array";
    case JsonKind::kObject:
      return "an object";
  }
  return {};
}

namespace {

void append(JsonWriter& json, const JsonValue& value) {
  using Layout = JsonWriter::Layout;
  switch (value.kind()) {
    case JsonKind::kNull:
      json.null();
      break;
    case JsonKind::kTrue:
    case JsonKind::kFalse:
      json.value(value.kind() == JsonKind::kTrue);
      break;
    case JsonKind::kNumber:
      json.raw(value.text());
      break;
    case JsonKind::kString:
      json.value(value.text());
      break;
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
