#include "core/store/pair_list.h"

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/json/json_writer.h"

namespace tactus::store {

std::string pairListText(const PairList& pairs) {
  base::JsonWriter json;
  json.beginArray(base::JsonWriter::Layout::kInline);
  for (const auto& [first, second] : pairs) json.values(std::array{first, second});
  std::string text = json.endArray().text();
  text.pop_back();  // the newline of a whole file
  return text;
}

std::optional<PairList> pairListIn(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_array()) return std::nullopt;
  PairList pairs;
  for (const auto& pair : json) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) return std::nullopt;
    pairs.emplace_back(pair[0].get<std::string>(), pair[1].get<std::string>());
  }
  return pairs;
}

}  // namespace tactus::store
