// The variables of the nasogastric tube study with their default terms, and the sets of depth terms its forms use.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// The set of depth terms that the depth variable has by itself.
inline constexpr std::string_view kDefaultDepthTerms = "six_regions";

/// lubrication [0, 1], neck_flexion [0, 90] deg, depth [0, 600] mm, speed [0, 400] mm/s, in this order.
std::vector<fuzzy::Variable> ngtInputs();

/// The ids of `ngtInputs`: the input columns of rules.csv.
std::vector<std::string> ngtInputIds();

/// force [0, 1.1] N; its default terms are those of the paper's Table 2.
fuzzy::Variable ngtOutput();

/// A named list of terms of the depth variable. A form that does not ask about a region has no term for it.
struct DepthTermSet {
  std::string id;
  std::string label;
  std::vector<fuzzy::Term> terms;
};

/// `six_regions`, `form_a1` (Table A1: no stomach), `form_a2` (Table A2 read as five regions: no oropharynx).
std::vector<DepthTermSet> depthTermSets();

/// The set `id`, or nothing.
std::optional<DepthTermSet> findDepthTerms(std::string_view id);

}  // namespace tactus::elicitation
