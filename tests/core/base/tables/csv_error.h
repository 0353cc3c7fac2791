// What CsvTable says of a text, for its tests.
#pragma once

#include <string>
#include <utility>

#include "core/base/tables/csv.h"

namespace tactus::base {

inline std::string errorOf(std::string text) {
  const auto table = CsvTable::parse(std::move(text), "t.csv");
  return table.has_value() ? "accepted" : table.error().message();
}

}  // namespace tactus::base
