// The members of one JSON object, read by name and range; what nobody asked for is refused.
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

/// Both ends belong to it.
struct NumberRange {
  double low;
  double high;
};

/// Reads one object of a JsonDocument. The first error stays and silences everything after it, so that a reader asks
/// for all members in a row and looks once. A member that is absent leaves its target as it was.
class JsonMembers {
 public:
  /// `error`: shared by all objects of a text. A value that is no object is an error.
  JsonMembers(JsonValue value, std::optional<Error>& error);

  void number(std::string_view key, double& target, NumberRange range);
  void number(std::string_view key, std::optional<double>& target, NumberRange range);
  /// Whole numbers only.
  void integer(std::string_view key, int& target, NumberRange range);
  /// From 0, at most 2^64 - 1.
  void integer(std::string_view key, std::uint64_t& target);
  void flag(std::string_view key, bool& target);
  void flag(std::string_view key, std::optional<bool>& target);
  /// Not empty.
  void text(std::string_view key, std::string& target);
  /// Index of the one of `words` that stands there; nothing where the member is absent or another text.
  std::optional<std::size_t> word(std::string_view key, std::span<const std::string_view> words);
  /// An object of numbers by name.
  void numbers(std::string_view key, std::map<std::string, double>& target, NumberRange range);
  /// Whatever stands there, for a reader of its own.
  std::optional<JsonValue> child(std::string_view key);
  /// Elements of an array; none where it is absent.
  std::vector<JsonValue> elements(std::string_view key);

  /// The member must be there.
  void require(std::string_view key);
  /// Whether the member is there.
  bool has(std::string_view key) const;
  /// An error about the member, or about the object where it is absent.
  void refuse(std::string_view key, std::string wanted);
  /// Refuses members that nobody asked for.
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
