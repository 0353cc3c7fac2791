// A study of three participants, small enough to count by hand.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/study/records.h"

namespace tactus::dataset {

/// `nora-7` (real) has two strokes, two judgements, two answers; `Dr. Ode` (simulated) one rule; `quiet` nothing.
inline study::Study smallStudy() {
  study::Study study;
  study.name = "Ward 3";
  study.participants = {{"nora-7", 12.25, "expert", "both", 3.5, false},
                        {"Dr. Ode", 2.0, "head nurse of ward 3", "right", {}, true},
                        {"quiet", {}, "", "", {}, false}};
  for (int sample = 0; sample < 4; ++sample) {
    study.speeds.push_back({"nora-7", "slow", 1, 0.001 * sample, 0.25 * sample, 0.0 + 250 * sample});
    study.speeds.push_back({"nora-7", "very slow", 12, 5 + 0.01 * sample, 0.5 * sample, 50});
  }
  using Kind = study::ForceJudgement::Kind;
  study.judgements = {{"nora-7", "ascending", 1, 0.05, Kind::kNotFelt, ""},
                      {"nora-7", "ascending", 2, 0.4, Kind::kTerm, "medium"},
                      {"nora-7", "ascending", 3, 0.9, Kind::kNoAnswer, ""}};
  using Status = study::Answer::Status;
  study.answers = {{"nora-7", "ngt-force-v1", 1, "large", Status::kAnswered},
                   {"nora-7", "ngt-force-v1", 12, "", Status::kCantTell}};
  study.rules = {{"Dr. Ode", "ngt-a2-printed", {{"depth", "stomach"}, {"speed", "fast"}}, "large", 0.5}};
  return study;
}

/// Path below `folder` and bytes of each file.
inline std::map<std::string, std::string> filesBelow(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    files[entry.path().lexically_relative(folder).generic_string()] = bytes.str();
  }
  return files;
}

/// The cells of a table with tabs, row by row.
inline std::vector<std::vector<std::string>> cellsOf(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tactus::dataset
