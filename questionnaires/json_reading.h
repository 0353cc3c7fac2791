// Reads the data files of this folder: typed members of JSON objects; errors have the place as a JSON pointer.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::questionnaires {

// Keeps the keys in file order.
using Json = nlohmann::ordered_json;

/// A value and its place in the file.
struct JsonPlace {
  const Json* json = nullptr;
  std::string pointer;  ///< RFC 6901; empty for the whole text

  /// The member `key`. Returns an error if it is missing.
  base::Result<JsonPlace> member(std::string_view key) const;
  /// Element `index` of an array, which must be long enough.
  JsonPlace element(std::size_t index) const;

  base::Result<std::string> string() const;  ///< not empty
  base::Result<int> integer() const;         ///< at least 1
  base::Result<std::vector<JsonPlace>> array() const;
  base::Result<std::vector<std::pair<std::string, JsonPlace>>> object() const;
  base::Result<std::vector<std::string>> strings() const;

  /// `member(key)` and its string.
  base::Result<std::string> string(std::string_view key) const;
};

/// Parses `text`. Returns an error if its member `format` is not `format`.
base::Result<Json> parseJson(std::string_view text, std::string_view format);

}  // namespace tactus::questionnaires
