// Reads a form from its data file, and the study's form embedded in the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "questionnaires/aliases.h"

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

/// Reads a form (JSON, see forms/ngt_force_v1.json) from `text`; `file` is its name in errors. `aliases` gives the
/// condition of each item from its wording. Returns an error for: an unknown word, a duplicate item number, an item
/// that does not ask for the output, two items with the same condition, no items.
base::Result<study::Form> parseForm(std::string_view text, const std::string& file, const AliasTable& aliases);

/// The 45 items of Table A1 in the paper's order and wording, id `ngt-force-v1`.
study::Form ngtForceForm();

}  // namespace tactus::questionnaires
