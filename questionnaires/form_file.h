// Forms with statements, read from their data files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::questionnaires {

/// A form with statements that the participant rates on a scale of agreement (paper, Section 5.4).
struct ScaleItem {
  int number = 0;
  std::string text;  ///< verbatim

  bool operator==(const ScaleItem&) const = default;
};

struct ScaleForm {
  std::string id;
  int version = 1;
  std::string title;
  std::string source;  ///< origin of the wording
  int points = 7;      ///< the scale goes from 1 to this number
  std::string low;     ///< meaning of 1
  std::string high;    ///< meaning of the highest point
  std::vector<ScaleItem> items;

  bool operator==(const ScaleForm&) const = default;
};

/// Reads a scale form (JSON, see forms/usability_v1.json) from `text`; `file` is its name in errors. Returns an error
/// for: a missing key, fewer than two points, no items, a duplicate item number or statement.
base::Result<ScaleForm> parseScaleForm(std::string_view text, const std::string& file);

/// The six statements about the simulator on a 7-point Likert scale, id `usability-v1`.
ScaleForm usabilityForm();

// The data files of this folder, embedded in the programs (cmake/TactusEmbed.cmake).

std::string_view aliasesJson();                             ///< forms/aliases.json
std::string_view usabilityFormJson();                       ///< forms/usability_v1.json
std::string_view usabilityAnyJson();                        ///< forms/usability_any.json
std::string_view usabilityGermanWordingJson();              ///< forms/usability_v1.de.json
std::string_view usabilityTraditionalChineseWordingJson();  ///< forms/usability_v1.zh-Hant.json
std::string_view usabilitySimplifiedChineseWordingJson();   ///< forms/usability_v1.zh-Hans.json
std::string_view table3Csv();                               ///< published/table_3.csv
std::string_view tableA2Csv();                              ///< published/table_a2.csv
std::string_view tableA2ReadingsJson();                     ///< published/table_a2_readings.json

}  // namespace tactus::questionnaires
