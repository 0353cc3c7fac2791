#include "core/analysis/reasons.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::analysis {

using base::formatFixed;

std::string signedNewtons(double newtons) { return (newtons < 0 ? "" : "+") + base::formatFixed(newtons, 3) + " N"; }

std::string withUnit(double number, const fuzzy::Variable& variable) {
  const bool plain = variable.unit.empty() || variable.unit == "1";
  return base::formatFixed(number, 3) + (plain ? "" : " " + base::oneLine(variable.unit));
}

std::string labelOf(const fuzzy::Term* term, const std::string& id) {
  return base::oneLine(term != nullptr && !term->label.empty() ? term->label : id);
}

std::string wordLabel(const fuzzy::ForceModel& model, const std::string& id) {
  return labelOf(findTerm(model.output.terms, id), id);
}

std::string variableLabel(const fuzzy::Variable& variable) {
  return base::oneLine(variable.label.empty() ? variable.id : variable.label);
}

std::string conditionsOf(const fuzzy::ForceModel& model, std::size_t expert, std::size_t rule) {
  std::vector<std::string> parts;
  for (const auto& condition : model.experts[expert].rules[rule].conditions) {
    for (const auto& input : model.inputs) {
      if (input.id != condition.input) continue;
      parts.push_back(variableLabel(input) + " " +
                      labelOf(findTerm(termsFor(model.experts[expert], input), condition.term), condition.term));
    }
  }
  return base::joined(parts, ", ");
}

namespace {

constexpr double kWorthAWord = 0.1;  // of the strongest pull

/// `one`, `one and two`, `one, two and three`.
std::string listed(const std::vector<std::string>& parts) {
  if (parts.size() < 2) return base::joined(parts, "");
  return base::joined(std::span(parts).first(parts.size() - 1), ", ") + " and " + parts.back();
}

/// The words that pull down (`sign` -1) or up (1), the strongest first, each with its pull.
std::vector<std::string> side(const fuzzy::ForceModel& model, const Reasons& reasons, int sign) {
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
    std::string text = wordLabel(model, word->term) + " (" + signedNewtons(word->pull_n);
    if (out.empty() && reasons.balance.experts.size() == 1) {
      const auto& rules = reasons.balance.rules;
      const auto rule = std::find_if(rules.begin(), rules.end(), [&](const RulePull& pull) {
        return model.experts[pull.expert].rules[pull.rule].then == word->term;
      });
      if (rule != rules.end()) text += ": " + conditionsOf(model, rule->expert, rule->rule);
    }
    out.push_back(text + ")");
  }
  return out;
}

/// The smallest noticeable move, as a share of its universe; null if there is none.
const Counterfactual* nearest(const fuzzy::ForceModel& model, const Reasons& reasons) {
  const Counterfactual* found = nullptr;
  double smallest = 0;
  for (const Counterfactual& one : reasons.counterfactuals) {
    if (one.kind != Counterfactual::Kind::kNoticeable) continue;
    const auto& input = model.inputs[one.input];
    const double share = std::abs(one.delta) / (input.max - input.min);
    if (found != nullptr && share >= smallest) continue;
    found = &one;
    smallest = share;
  }
  return found;
}

std::string moreOrLess(double change) { return change < 0 ? "less" : "more"; }

}  // namespace

std::string whatOf(const Counterfactual& one) {
  switch (one.kind) {
    case Counterfactual::Kind::kTerm: return "term " + one.term;
    case Counterfactual::Kind::kNoticeable: return "one just-noticeable difference";
    case Counterfactual::Kind::kLargestWord: break;
  }
  if (one.delta == 0) return "largest share: " + one.term + " and " + one.instead + " tie";
  return "largest share: " + one.instead + " instead of " + one.term;
}

std::string sentenceOf(const fuzzy::ForceModel& model, const Reasons& reasons) {
  const analysis::ForceBalance& balance = reasons.balance;
  if (!reasons.fired) {
    return "No rule fires here: " + formatFixed(balance.force_n, 3) + " N is the default force of the model.";
  }
  const auto down = side(model, reasons, -1);
  const auto up = side(model, reasons, 1);
  std::string text = formatFixed(balance.force_n, 3) + " N";
  if (down.empty() && up.empty()) {
    text += balance.words.empty() ? "" : ", the centroid of " + wordLabel(model, balance.words[0].term) + " alone";
  } else {
    text += " because " + listed(down) + (down.size() == 1 ? " holds it down" : " hold it down") + " and " +
            listed(up) + (up.size() == 1 ? " pulls it up" : " pull it up");
  }
  const Counterfactual* const move = nearest(model, reasons);
  if (move == nullptr) return text + ". No input alone makes a difference that is felt.";
  const auto& input = model.inputs[move->input];
  const double change_n = move->force_n - balance.force_n;
  return text + ". It would be " + formatFixed(std::abs(change_n), 3) + " N " + moreOrLess(change_n) + " with " +
         variableLabel(input) + " at " + withUnit(move->value, input) + ", which is " +
         formatFixed(std::abs(move->delta), 3) + " " + moreOrLess(move->delta) + ".";
}

base::Result<Reasons> reasonsOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                const Explanation& explanation, const NoticeableDifference& noticeable,
                                std::optional<std::size_t> expert) {
  std::vector<double> point;
  for (const ExplainedInput& input : explanation.inputs) point.push_back(input.value);
  TACTUS_TRY(auto moves, counterfactuals(model, compiled, point, noticeable, expert));
  return Reasons{expert ? !explanation.experts[*expert].abstains : explanation.fired,
                 forceBalance(model, explanation, expert), std::move(moves)};
}

}  // namespace tactus::analysis
