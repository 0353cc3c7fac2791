// The variables of the nasogastric tube study with their default terms, and the sets of depth terms of its forms.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/directions.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// The default set of depth terms of the depth variable.
inline constexpr std::string_view kDefaultDepthTerms = "six_regions";

/// lubrication [0, 1], neck_flexion [0, 90] deg, depth [0, 600] mm, speed [0, 400] mm/s, in this order.
std::vector<fuzzy::Variable> ngtInputs();

/// The ids of `ngtInputs`, which are the input columns of rules.csv.
std::vector<std::string> ngtInputIds();

/// force [0, 1.1] N; its default terms are those of the paper's Table 2.
fuzzy::Variable ngtOutput();

/// The declared direction of the force for a growing input.
struct DeclaredDirection {
  std::string input;
  analysis::Direction direction = analysis::Direction::kMixed;  ///< kMixed declares nothing

  bool operator==(const DeclaredDirection&) const = default;
};

/// The directions that the study declares: more lubrication gives less force, more neck flexion less, more speed more.
/// They follow the paper's text about the four experts (Fig. 10) and are not a law: S4's rules say the opposite for the
/// neck.
std::vector<DeclaredDirection> ngtDirections();

/// The input whose terms are the regions for comparing experts: depth.
std::string ngtRegionInput();

/// A named list of terms of the depth variable. It has no term for a region that its form does not ask about.
struct DepthTermSet {
  std::string id;
  std::string label;
  std::vector<fuzzy::Term> terms;
};

/// `six_regions`, `form_a1` (Table A1: no stomach), `form_a2` (Table A2 read as five regions: no oropharynx).
std::vector<DepthTermSet> depthTermSets();

/// The set with the id `id`, or nothing.
std::optional<DepthTermSet> findDepthTerms(std::string_view id);

}  // namespace tactus::elicitation
