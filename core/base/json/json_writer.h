// Writes JSON text with keys in the order of the calls. (JsonDocument reads it.)
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactus::base {

/// `text` as a JSON string with its quotes.
std::string jsonString(std::string_view text);

/// `value` as JSON: the shortest text that reads back equal, `null` if it is not finite.
std::string jsonNumber(double value);

/// Builds a JSON text, indented by two spaces. Containers opened with `kInline` stay on one line.
///   JsonWriter json;
///   json.beginObject().key("name").value("S4").endObject();
class JsonWriter {
 public:
  enum class Layout { kBlock, kInline };

  JsonWriter& beginObject(Layout layout = Layout::kBlock) { return begin('{', layout); }
  JsonWriter& endObject() { return end('}'); }
  JsonWriter& beginArray(Layout layout = Layout::kBlock) { return begin('[', layout); }
  JsonWriter& endArray() { return end(']'); }

  JsonWriter& key(std::string_view name);
  JsonWriter& value(std::string_view text) { return raw(jsonString(text)); }
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(const std::string& text) { return value(std::string_view(text)); }
  JsonWriter& value(double number) { return raw(jsonNumber(number)); }
  JsonWriter& value(long long number) { return raw(std::to_string(number)); }
  JsonWriter& value(int number) { return raw(std::to_string(number)); }
  JsonWriter& value(std::size_t number) { return raw(std::to_string(number)); }
  JsonWriter& value(bool flag) { return raw(flag ? "true" : "false"); }
  JsonWriter& null() { return raw("null"); }
  /// An optional or a result: `null` where there is no value.
  template <class Maybe>
  requires requires(const Maybe& maybe) { maybe.has_value(); }
  JsonWriter& value(const Maybe& maybe) { return maybe ? value(*maybe) : null(); }
  /// Numbers on one line.
  JsonWriter& values(std::span<const double> numbers);
  /// Strings on one line.
  JsonWriter& values(std::span<const std::string> texts);
  /// Inserts JSON text unchanged.
  JsonWriter& raw(std::string_view json);

  /// The text, with a final newline. All containers must be closed.
  std::string text() const;

 private:
  struct Level {
    Layout layout;
    bool empty = true;
  };

  JsonWriter& begin(char bracket, Layout layout);
  JsonWriter& end(char bracket);
  void separate();
  void newline();

  std::string text_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace tactus::base
