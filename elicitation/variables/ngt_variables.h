// The variables of the nasogastric tube study with their default terms, and the sets of depth terms its forms use.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/directions.h"
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

/// In which direction the force is declared to move when an input grows.
struct DeclaredDirection {
  std::string input;
  analysis::Direction direction = analysis::Direction::kMixed;  ///< kMixed declares nothing

  bool operator==(const DeclaredDirection&) const = default;
};

/// What the study declares: better lubrication less force, a flexed neck less, more speed more. It is what the paper's
/// text says of the four experts (Fig. 10), not a law: S4's rules say the opposite of the neck.
std::vector<DeclaredDirection> ngtDirections();

/// The input whose terms are the regions by which experts are compared: depth.
std::string ngtRegionInput();

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
