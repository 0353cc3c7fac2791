// The reference cases of tests/golden/fcm.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/text.h"

namespace tactus::elicitation {

/// First column of a CSV file of tests/golden/fcm.
inline std::vector<double> readFirstColumn(const std::string& file) {
  std::ifstream in(std::string(TACTUS_GOLDEN_DIR) + "/fcm/" + file);
  std::vector<double> values;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    values.push_back(base::parseNumber(base::trimmed(line.substr(0, line.find(',')))).value());
  }
  return values;
}

inline nlohmann::json readFcmCases() {
  std::ifstream in(std::string(TACTUS_GOLDEN_DIR) + "/fcm/index.json");
  return nlohmann::json::parse(in).at("cases");
}

inline double largestError(const std::vector<double>& found, const std::vector<double>& wanted) {
  if (found.size() != wanted.size()) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t k = 0; k < found.size(); ++k) most = std::max(most, std::abs(found[k] - wanted[k]));
  return most;
}

}  // namespace tactus::elicitation
