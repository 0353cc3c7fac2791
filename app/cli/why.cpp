#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/opened_model.h"
#include "app/cli/why_text.h"
#include "core/base/text.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::cli {
base::Result<Output> why(const WhyOptions& options) {
  const auto opened = openedModel(options.model);
  if (!opened) return tl::unexpected(opened.error());
  const auto expert = expertOption(opened->model, options.model, options.expert);
  if (!expert) return tl::unexpected(expert.error());
  const auto point = pointOption(opened->model, "--at", options.at);
  if (!point) return tl::unexpected(point.error());
  const auto explanation = analysis::explain(opened->model, opened->compiled, *point);
  if (!explanation) return tl::unexpected(explanation.error());
  auto moves = analysis::counterfactuals(opened->model, opened->compiled, *point, elicitation::justNoticeableDifference,
                                         *expert);
  if (!moves) return tl::unexpected(moves.error());

  std::vector<std::string> warnings = opened->warnings;
  for (const analysis::ExplainedInput& input : explanation->inputs) {
    if (input.given == input.value) continue;
    warnings.push_back(input.id + " " + base::formatNumber(input.given) + " lies outside its universe; taken as " +
                       base::formatNumber(input.value));
  }
  const Reasons reasons{opened->model, *expert ? !explanation->experts[**expert].abstains : explanation->fired,
                        analysis::forceBalance(opened->model, *explanation, *expert), std::move(*moves)};
  return Output{options.json ? asJson(reasons) : asText(reasons), std::move(warnings)};
}

}  // namespace tactus::cli
