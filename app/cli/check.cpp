#include "app/cli/commands.h"
#include "app/cli/contracts_text.h"
#include "app/cli/findings_text.h"
#include "app/cli/model_arguments.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::cli {
namespace {

using base::formatFixed;
using base::formatNumber;

std::size_t ruleCount(const fuzzy::ForceModel& model) {
  std::size_t rules = 0;
  for (const auto& expert : model.experts) rules += expert.rules.size();
  return rules;
}

std::string asText(const std::string& file, const fuzzy::ForceModel& model, const elicitation::RuleLint& found,
                   const std::vector<CheckedContract>& contracts) {
  const auto& lint = found.model;
  const auto& range = lint.reachable;
  std::string text = base::oneLine(file) + ": valid; inputs " + std::to_string(model.inputs.size()) + ", experts " +
                     std::to_string(model.experts.size()) + ", rules " + std::to_string(ruleCount(model)) +
                     ", findings " + std::to_string(found.findings.size()) + '\n';
  text += findingsAsText(found.findings, model.output.unit);
  text += contractsAsText(model, contracts);
  if (!found.newtons_complete) text += "  the model is very large, so only some forces at stake were computed\n";
  if (!lint.coverage_complete) text += "  the search for holes was cut off: the model is too finely divided\n";
  if (!lint.bounds) return text + "reachable force: none, no rule fires anywhere\n";
  const auto interval = [&](double min, double max) {
    return formatFixed(min, 3) + " to " + formatFixed(max, 3) + ' ' + model.output.unit;
  };
  text += "reachable force: ";
  text += range.fired > 0 ? interval(range.min_n, range.max_n) : "none";
  text += ", seen at " + std::to_string(range.points) + " points\n  proved bounds " +
          interval(lint.bounds->min_n, lint.bounds->max_n);
  return text + "; the universe is " + formatNumber(model.output.min) + " to " + formatNumber(model.output.max) + ' ' +
         model.output.unit + '\n';
}

std::string asJson(const std::string& file, const fuzzy::ForceModel& model, const elicitation::RuleLint& found,
                   const std::vector<CheckedContract>& contracts, const std::vector<std::string>& warnings) {
  using Layout = base::JsonWriter::Layout;
  const auto& lint = found.model;
  base::JsonWriter json;
  json.beginObject().key("file").value(file).key("name").value(model.name).key("valid").value(true);
  json.key("experts").value(model.experts.size()).key("rules").value(ruleCount(model));
  json.key("warnings").values(warnings);
  writeFindings(found.findings, json);
  writeContracts(contracts, json);
  json.key("coverage_complete").value(lint.coverage_complete);
  json.key("newtons_complete").value(found.newtons_complete);
  json.key("reachable").beginObject(Layout::kInline);
  const bool any = lint.reachable.fired > 0;
  json.key("min_n");
  any ? json.value(lint.reachable.min_n) : json.null();
  json.key("max_n");
  any ? json.value(lint.reachable.max_n) : json.null();
  json.key("points").value(lint.reachable.points).endObject();
  json.key("bounds").beginObject(Layout::kInline).key("min_n");
  lint.bounds ? json.value(lint.bounds->min_n) : json.null();
  json.key("max_n");
  lint.bounds ? json.value(lint.bounds->max_n) : json.null();
  json.endObject().endObject();
  return json.text();
}

}  // namespace

base::Result<Output> check(const CheckOptions& options) {
  TACTUS_TRY(const auto opened, openedModel(options.model));
  TACTUS_TRY(const auto contracts, checkedContracts(opened.model, opened.compiled, options.contracts));
  const auto found = elicitation::ruleLint(opened.model, opened.compiled);
  Output output{options.json ? asJson(options.model, opened.model, found, contracts, opened.warnings)
                             : asText(options.model, opened.model, found, contracts),
                options.json ? std::vector<std::string>{} : opened.warnings};
  if (const std::string broken = brokenContract(contracts); !broken.empty())
    output.failure = base::oneLine(options.model) + ": " + broken;
  return output;
}

}  // namespace tactus::cli
