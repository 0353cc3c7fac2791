// A form whose items are statements that a person agrees with on a scale (paper, Section 5.4).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::questionnaires {

struct ScaleItem {
  int number = 0;
  std::string text;  ///< verbatim

  bool operator==(const ScaleItem&) const = default;
};

struct ScaleForm {
  std::string id;
  int version = 1;
  std::string title;
  std::string source;  ///< where the wording comes from
  int points = 7;      ///< the scale goes from 1 to this
  std::string low;     ///< what 1 means
  std::string high;    ///< what the highest point means
  std::vector<ScaleItem> items;

  bool operator==(const ScaleForm&) const = default;
};

/// Reads a scale form (JSON, see forms/usability_v1.json) from `text`, said to be of `file` in errors. Refused: a
/// missing key, fewer than two points, no items, an item number or a statement twice.
base::Result<ScaleForm> parseScaleForm(std::string_view text, const std::string& file);

/// The six statements about the simulator on a 7-point Likert scale, id `usability-v1`.
ScaleForm usabilityForm();

}  // namespace tactus::questionnaires
