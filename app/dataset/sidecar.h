// The JSON file beside a table of BIDS: what the table is, and what each column holds.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/json/json_writer.h"

namespace tactus::dataset {

/// The possible values of a column and what each means, in their order.
using Levels = std::vector<std::pair<std::string, std::string>>;

class Sidecar {
 public:
  Sidecar() { json_.beginObject(); }

  Sidecar& member(std::string_view name, std::string_view value);
  Sidecar& member(std::string_view name, const char* value) { return member(name, std::string_view(value)); }
  Sidecar& member(std::string_view name, double value);
  Sidecar& member(std::string_view name, bool value);
  /// An object with `Description` alone.
  Sidecar& object(std::string_view name, std::string_view description);

  Sidecar& column(std::string_view name, std::string_view description, const Levels& levels = {});
  Sidecar& column(std::string_view name, std::string_view description, std::string_view unit);
  Sidecar& column(std::string_view name, std::string_view description, const char* unit) {
    return column(name, description, std::string_view(unit));
  }

  /// The text; nothing is added afterwards.
  std::string text() { return json_.endObject().text(); }

 private:
  base::JsonWriter json_;
};

}  // namespace tactus::dataset
