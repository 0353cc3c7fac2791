// The strokes of tests/golden/fcm with their levels, and the reference values of tests/golden/speeds.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/study/records.h"

namespace tactus::elicitation {

inline const std::vector<std::string>& goldenLevels() {
  static const std::vector<std::string> kLevels = {"slow", "medium", "fast"};
  return kLevels;
}

/// `file`: speed, level from 0, stroke from 0. Simulated.
inline std::vector<study::SpeedSample> goldenStrokes(const std::string& file) {
  std::ifstream in(std::string(TACTUS_GOLDEN_DIR) + "/fcm/" + file);
  std::vector<study::SpeedSample> samples;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    const auto first = line.find(',');
    const auto second = line.find(',', first + 1);
    const auto level = base::parseInteger(line.substr(first + 1, second - first - 1)).value();
    study::SpeedSample sample;
    sample.participant = file.substr(0, file.find('_'));
    sample.level = goldenLevels().at(static_cast<std::size_t>(level));
    sample.stroke = static_cast<int>(base::parseInteger(base::trimmed(line.substr(second + 1))).value()) + 1;
    sample.speed_mm_s = base::parseNumber(line.substr(0, first)).value();
    samples.push_back(sample);
  }
  return samples;
}

/// `part` of reference.json: `trends` or `subjects`.
inline nlohmann::json goldenSpeeds(const std::string& part) {
  std::ifstream in(std::string(TACTUS_GOLDEN_DIR) + "/speeds/reference.json");
  return nlohmann::json::parse(in).at(part);
}

/// The reference of one file of strokes.
inline nlohmann::json goldenSubject(const std::string& file) {
  for (const auto& subject : goldenSpeeds("subjects")) {
    if (subject.at("file") == file) return subject;
  }
  return {};
}

}  // namespace tactus::elicitation
