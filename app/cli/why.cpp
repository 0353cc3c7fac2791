#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/terminal.h"
#include "core/analysis/reasons.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::cli {
namespace {

using analysis::Counterfactual;
using analysis::Reasons;
using analysis::RulePull;
using analysis::WordPull;
using base::formatFixed;

constexpr std::size_t kRulesInText = 8;  // the JSON has all

/// The sentence, and tables of words, experts, rules and counterfactuals.
std::string asText(const fuzzy::ForceModel& model, const Reasons& reasons) {
  std::string text = wrapped(sentenceOf(model, reasons), "", 0);
  if (!reasons.balance.words.empty()) text += "\nword                strength   share  centroid        pull\n";
  for (const WordPull& word : reasons.balance.words) {
    text += padded(word.term, 20) + formatFixed(word.strength, 3) + "     " + formatFixed(word.share, 3) + "   " +
            formatFixed(word.centroid_n, 3) + " N   " + signedNewtons(word.pull_n) + '\n';
  }
  if (reasons.balance.experts.size() > 1) {
    text += "\nexpert               force        pull   the mean without this expert\n";
    for (const auto& expert : reasons.balance.experts) {
      text += padded(model.experts[expert.expert].id, 20) + formatFixed(expert.force_n, 3) + " N   " +
              signedNewtons(expert.pull_n) + "   " +
              formatFixed(reasons.balance.force_n - expert.leave_one_out_n.value_or(0), 3) + " N\n";
    }
  }
  const auto& rules = reasons.balance.rules;
  if (!rules.empty()) text += "\nrules, strongest pull first\n";
  for (std::size_t r = 0; r < std::min(rules.size(), kRulesInText); ++r) {
    const fuzzy::Expert& expert = model.experts[rules[r].expert];
    text += padded(expert.id + " " + std::to_string(rules[r].rule + 1), 20) + signedNewtons(rules[r].pull_n) + "   " +
            conditionsOf(model, rules[r].expert, rules[r].rule) + " -> " +
            wordLabel(model, expert.rules[rules[r].rule].then) + '\n';
  }
  if (rules.size() > kRulesInText) text += std::to_string(rules.size() - kRulesInText) + " more with --json\n";
  if (!reasons.counterfactuals.empty()) text += "\nwhat would change it\n";
  for (const Counterfactual& one : reasons.counterfactuals) {
    const auto& input = model.inputs[one.input];
    text += padded(input.id, 20) + padded(withUnit(one.value, input), 14) + " " + formatFixed(one.force_n, 3) +
            " N   " + base::oneLine(whatOf(one)) + '\n';
  }
  return text;
}

std::string asJson(const fuzzy::ForceModel& model, const Reasons& reasons) {
  base::JsonWriter json;
  json.beginObject().key("force_n").value(reasons.balance.force_n).key("fired").value(reasons.fired);
  json.key("words").beginArray();
  for (const WordPull& word : reasons.balance.words) {
    json.beginObject().key("term").value(word.term).key("strength").value(word.strength).key("share").value(word.share);
    json.key("centroid_n").value(word.centroid_n).key("pull_n").value(word.pull_n).endObject();
  }
  json.endArray().key("rules").beginArray();
  for (const RulePull& rule : reasons.balance.rules) {
    json.beginObject().key("expert").value(model.experts[rule.expert].id).key("rule").value(rule.rule + 1);
    json.key("pull_n").value(rule.pull_n).endObject();
  }
  json.endArray().key("experts").beginArray();
  for (const auto& expert : reasons.balance.experts) {
    json.beginObject().key("id").value(model.experts[expert.expert].id).key("force_n").value(expert.force_n);
    json.key("pull_n").value(expert.pull_n).key("leave_one_out_n");
    if (expert.leave_one_out_n) {
      json.value(*expert.leave_one_out_n);
    } else {
      json.null();
    }
    json.endObject();
  }
  json.endArray().key("counterfactuals").beginArray();
  for (const Counterfactual& one : reasons.counterfactuals) {
    json.beginObject().key("input").value(model.inputs[one.input].id).key("value").value(one.value);
    json.key("delta").value(one.delta).key("force_n").value(one.force_n).key("what").value(whatOf(one)).endObject();
  }
  json.endArray().key("sentence").value(sentenceOf(model, reasons)).endObject();
  return json.text();
}

}  // namespace

base::Result<Output> why(const WhyOptions& options) {
  TACTUS_TRY(const auto opened, openedModel(options.model));
  TACTUS_TRY(const auto expert, expertOption(opened.model, options.model, options.expert));
  TACTUS_TRY(const auto point, pointOption(opened.model, "--at", options.at));
  TACTUS_TRY(const auto explanation, analysis::explain(opened.model, opened.compiled, point));
  TACTUS_TRY(const auto reasons, analysis::reasonsOf(opened.model, opened.compiled, explanation,
                                                     elicitation::justNoticeableDifference, expert));

  std::vector<std::string> warnings = opened.warnings;
  for (const analysis::ExplainedInput& input : explanation.inputs) {
    if (input.given == input.value) continue;
    warnings.push_back(input.id + " " + base::formatNumber(input.given) + " lies outside its universe; taken as " +
                       base::formatNumber(input.value));
  }
  return Output{options.json ? asJson(opened.model, reasons) : asText(opened.model, reasons), std::move(warnings)};
}

}  // namespace tactus::cli
