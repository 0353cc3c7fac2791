// Reads the members of one JSON object by name and range, and refuses unknown members.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/json/json_document.h"

namespace tactus::base {

/// A closed range.
struct NumberRange {
  double low;
  double high;
};

/// Reads one object of a JsonDocument. The first error is kept, and later errors are ignored. So a caller can read all
/// members in sequence and check once at the end. An absent member leaves its target unchanged.
class JsonMembers {
 public:
  /// `error`: shared by all objects of a text. Sets an error if `value` is not an object.
  JsonMembers(JsonValue value, std::optional<Error>& error);

  void number(std::string_view key, double& target, NumberRange range);
  void number(std::string_view key, std::optional<double>& target, NumberRange range);
  /// Integers only.
  void integer(std::string_view key, int& target, NumberRange range);
  /// An integer from 0 to 2^64 - 1.
  void integer(std::string_view key, std::uint64_t& target);
  void flag(std::string_view key, bool& target);
  void flag(std::string_view key, std::optional<bool>& target);
  /// A text that is not empty.
  void text(std::string_view key, std::string& target);
  /// The index of the member's text in `words`. Nothing if the member is absent or has another text.
  std::optional<std::size_t> word(std::string_view key, std::span<const std::string_view> words);
  /// An object of numbers by name.
  void numbers(std::string_view key, std::map<std::string, double>& target, NumberRange range);
  /// The member's value, for a separate reader.
  std::optional<JsonValue> child(std::string_view key);
  /// The elements of an array; none if it is absent.
  std::vector<JsonValue> elements(std::string_view key);

  /// Sets an error if the member is absent.
  void require(std::string_view key);
  /// Whether the member exists.
  bool has(std::string_view key) const;
  /// Sets an error about the member, or about the object if the member is absent.
  void refuse(std::string_view key, std::string wanted);
  /// Refuses members that were never read.
  void finish();

 private:
  std::optional<JsonValue> find(std::string_view key);
  std::optional<double> numberIn(const JsonValue& value, NumberRange range);
  void refuse(const JsonValue& value, ErrorCode code, std::string wanted);

  std::optional<JsonValue> object_;
  std::optional<Error>& error_;
  std::set<std::string, std::less<>> asked_;
};

}  // namespace tactus::base
