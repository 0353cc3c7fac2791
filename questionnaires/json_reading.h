// Reading the data files of this folder: typed members of JSON objects, errors with the place as a JSON pointer.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::questionnaires {

// Keeps the keys in the order of the file.
using Json = nlohmann::ordered_json;

/// A value and where it stands in its file.
struct JsonPlace {
  const Json* json = nullptr;
  std::string pointer;  ///< RFC 6901; empty for the whole text

  /// The member `key`, which must be there.
  base::Result<JsonPlace> member(std::string_view key) const;
  /// Element `index` of an array that is long enough.
  JsonPlace element(std::size_t index) const;

  base::Result<std::string> string() const;  ///< not empty
  base::Result<int> integer() const;         ///< from 1
  base::Result<std::vector<JsonPlace>> array() const;
  base::Result<std::vector<std::pair<std::string, JsonPlace>>> object() const;
  base::Result<std::vector<std::string>> strings() const;

  /// `member(key)` and its string.
  base::Result<std::string> string(std::string_view key) const;
};

/// Parses `text` and checks that its member `format` is `format`.
base::Result<Json> parseJson(std::string_view text, std::string_view format);

}  // namespace tactus::questionnaires
