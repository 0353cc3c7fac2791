// Reads the members of one JSON object by name, kind and range: the one reader for every JSON text of the project.
//
// A reader states what becomes of unknown keys:
//   refuseOthers()  refused: texts that people write, where a typing error must not pass in silence
//   others()        returned, so that the caller warns about them or keeps them (the model file does both)
//   neither         ignored: texts that a newer version of the program may have written (rows of a study file)
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/json/json_document.h"

namespace tactus::base {

/// A closed range.
struct NumberRange {
  double low;
  double high;
};
inline constexpr NumberRange kAnyNumber{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

/// The name of a member: a literal, or another text that outlives the reader. Plain names are optional members.
struct JsonKey {
  JsonKey(const char* key) : name(key) {}
  JsonKey(std::string_view key) : name(key) {}

  std::string_view name;
  bool required = false;
};

/// The name of a member whose absence is an error.
inline JsonKey required(std::string_view name) {
  JsonKey key(name);
  key.required = true;
  return key;
}

/// Reads one object of a JsonDocument. The first error is kept, and later errors are ignored. So a caller can read all
/// members in sequence and check once at the end. An absent member leaves its target unchanged.
class JsonMembers {
 public:
  using NamedText = std::pair<std::string, std::string>;

  /// `error`: shared by all objects of a text. Sets an error if `value` is not an object.
  JsonMembers(JsonValue value, std::optional<Error>& error);

  /// The member `format`, which must be `name`.
  void format(std::string_view name);
  /// The version of the text: 1, the only one there is. Another one is an error, kVersion if it is newer.
  void version(JsonKey key);

  void number(JsonKey key, double& target, NumberRange range = kAnyNumber);
  void number(JsonKey key, std::optional<double>& target, NumberRange range = kAnyNumber);
  /// The same; `null` empties the target.
  void numberOrNull(JsonKey key, std::optional<double>& target);
  /// Integers only, also in a range.
  void integer(JsonKey key, int& target, NumberRange range = kAnyInt);
  void integer(JsonKey key, std::int64_t& target);
  void integer(JsonKey key, std::uint64_t& target);
  void flag(JsonKey key, bool& target);
  void flag(JsonKey key, std::optional<bool>& target);
  /// A text that is not empty.
  void text(JsonKey key, std::string& target);
  void textOrEmpty(JsonKey key, std::string& target);
  /// The index of the member's text in `words`. Nothing if the member is absent or has another text.
  std::optional<std::size_t> word(JsonKey key, std::span<const std::string_view> words);

  /// An object of numbers by name.
  void numbers(JsonKey key, std::map<std::string, double>& target, NumberRange range);
  /// An array of numbers.
  void numbers(JsonKey key, std::vector<double>& target);
  /// An array of texts, some of which may be empty.
  void texts(JsonKey key, std::vector<std::string>& target);
  /// An object of texts by name, none of them empty, in the order of the file.
  void texts(JsonKey key, std::vector<NamedText>& target);

  /// The member's value, for a separate reader.
  std::optional<JsonValue> child(JsonKey key);
  /// The member's value, which must be an object.
  std::optional<JsonValue> object(JsonKey key);
  /// The elements of an array; none if it is absent.
  std::vector<JsonValue> elements(JsonKey key);

  /// Whether the member exists.
  bool has(std::string_view key) const;
  /// Sets an error about the member: what was wanted in its place, and what was found if not its value.
  void refuse(std::string_view key, std::string wanted);
  void refuse(std::string_view key, std::string found, std::string wanted, ErrorCode code = ErrorCode::kValue);
  /// Sets an error of the member's text, which has a grammar of its own: its place follows that of the member.
  void refuse(std::string_view key, Error inside);

  /// Sets an error about the first member that was never asked for.
  void refuseOthers();
  /// The members that were never asked for.
  std::vector<JsonValue> others() const;

 private:
  static constexpr NumberRange kAnyInt{std::numeric_limits<int>::min(), std::numeric_limits<int>::max()};

  /// The member; one that is required and absent is an error. `wanted()`: its value, in words.
  template <class Wanted>
  std::optional<JsonValue> find(JsonKey key, Wanted wanted);
  /// The member, which must be of this kind.
  std::optional<JsonValue> findOf(JsonKind kind, JsonKey key);
  bool isOf(JsonKind kind, JsonValue value);
  bool isNotEmpty(JsonValue value);
  std::optional<double> numberIn(JsonValue value, NumberRange range);
  template <class Integer>
  void wholeNumber(JsonKey key, Integer& target);
  void refuse(JsonValue value, ErrorCode code, std::string wanted);

  std::optional<JsonValue> object_;
  std::optional<Error>& error_;
  std::vector<std::string_view> asked_;
};

/// Parses `text` and reads its outermost object: what `read(JsonMembers&, std::optional<Error>&)` returns, or the first
/// error, about `file`. Values and keys live as long as this call.
template <class Read>
auto readJson(std::string_view text, std::string_view file, Read read)
    -> Result<decltype(read(std::declval<JsonMembers&>(), std::declval<std::optional<Error>&>()))> {
  const auto document = JsonDocument::parse(text);
  if (!document) return inFile(document.error(), file);
  std::optional<Error> error;
  JsonMembers members(document->root(), error);
  auto out = read(members, error);
  if (error) return inFile(*std::move(error), file);
  return out;
}

}  // namespace tactus::base
