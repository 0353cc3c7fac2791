// A small force model whose experts are named by their codes, for tests of withdrawals.
#pragma once

#include <string>
#include <vector>

namespace tactus::store {

/// The weight of the one rule of the expert `code`, which is found again by a search of bytes.
inline std::string ruleWeightOf(const std::string& code) {
  unsigned sum = 0;
  for (const char c : code) sum = 31 * sum + static_cast<unsigned char>(c);
  return "0.7531" + std::to_string(10000 + sum % 90000);
}

/// The text of a model file with an expert for each code.
inline std::string namingModel(const std::vector<std::string>& codes) {
  std::string experts;
  std::string listed;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    experts += (i == 0 ? "" : ", ") + ("{\"id\": \"" + codes[i] + "\", \"label\": \"" + codes[i]) +
               " (simulated)\", \"weight\": 1, \"rules\": [{\"if\": {\"depth\": \"near\"}, \"then\": \"small\","
               " \"weight\": " +
               ruleWeightOf(codes[i]) + "}]}";
    listed += (i == 0 ? "\"" : ", \"") + codes[i] + "\"";
  }
  return R"({"format": "tactus-force-model", "version": 1, "name": "mean", "created_utc": "", "generator": "",
"provenance": {"study": "s", "settings": {}, "sources": {"simulated": [)" +
         listed + R"(]}, "notes": ""},
"inputs": [{"id": "depth", "label": "", "unit": "mm", "min": 0, "max": 200,
  "terms": [{"id": "near", "label": "", "shape": "trapezoid", "points": [0, 0, 50, 100]}]}],
"output": {"id": "force", "label": "", "unit": "N", "min": 0, "max": 1,
  "terms": [{"id": "small", "label": "", "shape": "triangle", "points": [0, 0.2, 0.4]}]},
"inference": {"conjunction": "min", "implication": "clip", "aggregation": "max", "defuzzification": "centroid"},
"experts": [)" +
         experts + "]}";
}

}  // namespace tactus::store
