// What differs between two models: variables, terms, experts, rules, settings. (The newtons: force_difference.h.)
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct ModelChange {
  enum class Kind { kAdded, kRemoved, kChanged };

  Kind kind = Kind::kChanged;
  std::string place;   ///< e.g. `term 'slow' of 'speed'`, `rule of S4: lubrication poor, depth stomach`
  std::string before;  ///< empty for what was added
  std::string after;   ///< empty for what was removed

  bool operator==(const ModelChange&) const = default;
};

/// `added`, `removed`, `changed`.
std::string_view name(ModelChange::Kind kind) noexcept;

/// All differences that can change the force or how it is felt, in the order of the first model; labels, dates, checks
/// and origin are left out. Terms, experts and variables are known by their ids, rules by their conditions.
std::vector<ModelChange> modelChanges(const fuzzy::ForceModel& first, const fuzzy::ForceModel& second);

}  // namespace tactus::analysis
