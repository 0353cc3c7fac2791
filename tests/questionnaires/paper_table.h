// The rows of a table of the paper's appendix, from its printed text.
#pragma once

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tactus::questionnaires {

/// Number and sentence of each row of tests/golden/paper/`name`, a row broken by the page joined.
inline std::vector<std::pair<int, std::string>> paperTable(const std::string& name) {
  std::ifstream file(std::string(TACTUS_GOLDEN_DIR) + "/paper/" + name);
  std::vector<std::pair<int, std::string>> rows;
  const std::regex start("^([0-9]+)\\.?\\t(IF .*)$");
  for (std::string line; std::getline(file, line);) {
    line = std::regex_replace(line, std::regex("(\\t(\\[ \\])?)+$"), "");
    std::smatch match;
    if (std::regex_match(line, match, start)) {
      rows.emplace_back(std::stoi(match[1]), match[2]);
    } else if (!line.empty() && !rows.empty()) {
      rows.back().second += " " + line;
    }
  }
  return rows;
}

}  // namespace tactus::questionnaires
