#include "app/workbench/feel/force_cost.h"

#include <algorithm>
#include <utility>

#include "core/fuzzy/takes_part.h"
#include "core/haptics/sources/servo_scene.h"

namespace tactus::workbench {

double ForceCost::of(const OpenModel& open) {
  Shape shape = shapeOf(open.model);
  // A cost above the budget is measured again: the machine may have been busy.
  const bool known = measurements_ > 0 && shape == shape_;
  if (known && cost_s_ <= haptics::SceneSettings().largest_cost_s) return cost_s_;
  shape_ = std::move(shape);
  cost_s_ = haptics::measuredCostS(open.compiled);
  ++measurements_;
  return cost_s_;
}

ForceCost::Shape ForceCost::shapeOf(const fuzzy::ForceModel& model) {
  Shape out;
  const auto add = [&out](const std::vector<fuzzy::Term>& terms, bool of_output) {
    out.numbers.push_back(terms.size());
    for (const fuzzy::Term& term : terms) {
      out.numbers.push_back(static_cast<std::size_t>(term.shape));
      if (of_output) out.output_points.insert(out.output_points.end(), term.points.begin(), term.points.end());
    }
  };
  out.numbers.push_back(static_cast<std::size_t>(model.implication));
  for (const fuzzy::Variable& input : model.inputs) add(input.terms, false);
  add(model.output.terms, true);
  for (const fuzzy::Expert& expert : model.experts) {
    out.numbers.push_back(
        static_cast<std::size_t>(std::count_if(expert.rules.begin(), expert.rules.end(), fuzzy::takesPart)));
    for (const fuzzy::TermOverride& own : expert.overrides) add(own.terms, own.variable == model.output.id);
  }
  return out;
}

}  // namespace tactus::workbench
