#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/terminal.h"
#include "core/analysis/force_balance.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::cli {
namespace {

/// Why a force is what it is, in words and as JSON.
struct Reasons {
  const fuzzy::ForceModel& model;
  bool fired = false;
  analysis::ForceBalance balance;
  std::vector<analysis::Counterfactual> counterfactuals;
};

using analysis::Counterfactual;
using analysis::RulePull;
using analysis::WordPull;
using base::formatFixed;

constexpr double kWorthAWord = 0.1;      // of the strongest pull
constexpr std::size_t kRulesInText = 8;  // the JSON has all

/// `one`, `one and two`, `one, two and three`.
std::string listed(const std::vector<std::string>& parts) {
  if (parts.size() < 2) return base::joined(parts, "");
  return base::joined(std::span(parts).first(parts.size() - 1), ", ") + " and " + parts.back();
}

/// The words that pull down (`sign` -1) or up (1), the strongest first, each with its pull.
std::vector<std::string> side(const Reasons& reasons, int sign) {
  std::vector<const WordPull*> words;
  double strongest = 0;
  for (const WordPull& word : reasons.balance.words) {
    strongest = std::max(strongest, std::abs(word.pull_n));
    if (word.pull_n * sign > 0) words.push_back(&word);
  }
  std::erase_if(words, [&](const WordPull* word) { return std::abs(word->pull_n) < kWorthAWord * strongest; });
  std::stable_sort(words.begin(), words.end(),
                   [](const auto* a, const auto* b) { return std::abs(a->pull_n) > std::abs(b->pull_n); });
  std::vector<std::string> out;
  for (const WordPull* word : words) {
    std::string text = wordLabel(reasons.model, word->term) + " (" + signedNewtons(word->pull_n);
    if (out.empty() && reasons.balance.experts.size() == 1) {
      const auto& rules = reasons.balance.rules;
      const auto rule = std::find_if(rules.begin(), rules.end(), [&](const RulePull& pull) {
        return reasons.model.experts[pull.expert].rules[pull.rule].then == word->term;
      });
      if (rule != rules.end()) text += ": " + conditionsOf(reasons.model, rule->expert, rule->rule);
    }
    out.push_back(text + ")");
  }
  return out;
}

/// The smallest noticeable move, as a share of its universe; null if there is none.
const Counterfactual* nearest(const Reasons& reasons) {
  const Counterfactual* found = nullptr;
  double smallest = 0;
  for (const Counterfactual& one : reasons.counterfactuals) {
    if (one.kind != Counterfactual::Kind::kNoticeable) continue;
    const auto& input = reasons.model.inputs[one.input];
    const double share = std::abs(one.delta) / (input.max - input.min);
    if (found != nullptr && share >= smallest) continue;
    found = &one;
    smallest = share;
  }
  return found;
}

std::string moreOrLess(double change) { return change < 0 ? "less" : "more"; }

std::string whatOf(const Counterfactual& one) {
  switch (one.kind) {
    case Counterfactual::Kind::kTerm: return "term " + one.term;
    case Counterfactual::Kind::kNoticeable: return "one just-noticeable difference";
    case Counterfactual::Kind::kLargestWord: break;
  }
  if (one.delta == 0) return "largest share: " + one.term + " and " + one.instead + " tie";
  return "largest share: " + one.instead + " instead of " + one.term;
}

/// `0.589 N because Small (-0.087 N) and Medium (-0.010 N) hold it down and Very large (+0.086 N) pulls it up. It would
/// be 0.081 N less with Neck flexion at 56.662 deg, which is 3.338 less.` Words that pull less than a tenth of the
/// strongest are left out. For one expert the strongest word on each side has the conditions of its strongest rule.
std::string sentenceOf(const Reasons& reasons) {
  const analysis::ForceBalance& balance = reasons.balance;
  if (!reasons.fired) {
    return "No rule fires here: " + formatFixed(balance.force_n, 3) + " N is the default force of the model.";
  }
  const auto down = side(reasons, -1);
  const auto up = side(reasons, 1);
  std::string text = formatFixed(balance.force_n, 3) + " N";
  if (down.empty() && up.empty()) {
    text +=
        balance.words.empty() ? "" : ", the centroid of " + wordLabel(reasons.model, balance.words[0].term) + " alone";
  } else {
    text += " because " + listed(down) + (down.size() == 1 ? " holds it down" : " hold it down") + " and " +
            listed(up) + (up.size() == 1 ? " pulls it up" : " pull it up");
  }
  const Counterfactual* const move = nearest(reasons);
  if (move == nullptr) return text + ". No input alone makes a difference that is felt.";
  const auto& input = reasons.model.inputs[move->input];
  const double change_n = move->force_n - balance.force_n;
  return text + ". It would be " + formatFixed(std::abs(change_n), 3) + " N " + moreOrLess(change_n) + " with " +
         variableLabel(input) + " at " + withUnit(move->value, input) + ", which is " +
         formatFixed(std::abs(move->delta), 3) + " " + moreOrLess(move->delta) + ".";
}

/// The sentence, and tables of words, experts, rules and counterfactuals.
std::string asText(const Reasons& reasons) {
  const fuzzy::ForceModel& model = reasons.model;
  std::string text = wrapped(sentenceOf(reasons), "", 0);
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

std::string asJson(const Reasons& reasons) {
  const fuzzy::ForceModel& model = reasons.model;
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
  json.endArray().key("sentence").value(sentenceOf(reasons)).endObject();
  return json.text();
}

}  // namespace

base::Result<Output> why(const WhyOptions& options) {
  TACTUS_TRY(const auto opened, openedModel(options.model));
  TACTUS_TRY(const auto expert, expertOption(opened.model, options.model, options.expert));
  TACTUS_TRY(const auto point, pointOption(opened.model, "--at", options.at));
  TACTUS_TRY(const auto explanation, analysis::explain(opened.model, opened.compiled, point));
  TACTUS_TRY(auto moves, analysis::counterfactuals(opened.model, opened.compiled, point,
                                                   elicitation::justNoticeableDifference, expert));

  std::vector<std::string> warnings = opened.warnings;
  for (const analysis::ExplainedInput& input : explanation.inputs) {
    if (input.given == input.value) continue;
    warnings.push_back(input.id + " " + base::formatNumber(input.given) + " lies outside its universe; taken as " +
                       base::formatNumber(input.value));
  }
  const Reasons reasons{opened.model, expert ? !explanation.experts[*expert].abstains : explanation.fired,
                        analysis::forceBalance(opened.model, explanation, expert), std::move(moves)};
  return Output{options.json ? asJson(reasons) : asText(reasons), std::move(warnings)};
}

}  // namespace tactus::cli
