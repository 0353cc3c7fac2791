#include "core/analysis/reasons.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/analysis/explain.h"
#include "core/analysis/force_balance.h"
#include "core/analysis/smallest_move.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::analysis {
namespace {

using fuzzy::MembershipFunction;

constexpr double kSameShare = 1e-9;  // of the area: a tie
constexpr double kFullMembership = 1 - 1e-12;

/// The words with the largest share: one, or several that tie.
using LargestWords = std::vector<std::size_t>;

LargestWords largestOf(std::span<const double> values) {
  LargestWords out;
  if (values.empty()) return out;
  const std::span<const double> shares = values.subspan(1);
  const double most = *std::max_element(shares.begin(), shares.end());
  for (std::size_t word = 0; word < shares.size(); ++word) {
    if (shares[word] >= most - kSameShare) out.push_back(word);
  }
  return out;
}

/// The model at the point, with one input moved.
class Explorer {
 public:
  Explorer(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::vector<double> point,
           std::optional<std::size_t> expert)
      : model_(model), compiled_(compiled), point_(std::move(point)), expert_(expert) {
    for (std::size_t e = 0; e < model_.experts.size(); ++e) {
      if (expert_ ? e == *expert_ : compiled_.weight(e) > 0) experts_.push_back(e);
    }
  }

  /// The force with `input` at `value`; nothing in a hole.
  std::optional<double> force(std::size_t input, double value) const {
    std::vector<double> there = point_;
    there[input] = value;
    const auto found = expert_ ? compiled_.evaluateExpert(*expert_, there) : compiled_.evaluate(there);
    return found.fired ? std::optional(found.force_n) : std::nullopt;
  }

  MeanLine line(std::size_t input) const { return {model_, compiled_, input, point_, experts_}; }

  /// The terms of `input` that count, each once.
  std::vector<fuzzy::Term> terms(std::size_t input) const {
    std::vector<fuzzy::Term> out;
    for (const std::size_t e : experts_) {
      for (const fuzzy::Term& term : termsFor(model_.experts[e], model_.inputs[input])) {
        if (std::find(out.begin(), out.end(), term) == out.end()) out.push_back(term);
      }
    }
    return out;
  }

 private:
  const fuzzy::ForceModel& model_;
  const fuzzy::CompiledModel& compiled_;
  std::vector<double> point_;
  std::optional<std::size_t> expert_;
  std::vector<std::size_t> experts_;  ///< whose forces count
};

/// The force differs from now by what is felt.
class FeltChange : public Change {
 public:
  FeltChange(const Explorer& explorer, const fuzzy::Variable& output, std::size_t input, double now_n, double felt_n)
      : explorer_(explorer),
        input_(input),
        now_n_(now_n),
        felt_n_(felt_n),
        lowest_n_(output.min),
        range_n_(output.max - output.min) {}

  bool forceOnly() const override { return true; }
  std::size_t excessCount() const override { return 2; }
  void excesses(std::span<const double> values, std::span<double> out) const override {
    const double change_n = values[0] - (now_n_ - lowest_n_);
    out[0] = (change_n - felt_n_) / range_n_;
    out[1] = (-change_n - felt_n_) / range_n_;
  }
  void excessSlopes(std::span<const double> slopes, std::span<double> out) const override {
    out[0] = out[1] = slopes[0] / range_n_;
  }
  bool happened(double x) const override {
    const auto there_n = explorer_.force(input_, x);
    return there_n && std::abs(*there_n - now_n_) >= felt_n_;
  }

 private:
  const Explorer& explorer_;
  std::size_t input_;
  double now_n_, felt_n_, lowest_n_, range_n_;
};

/// Another word than `now` has the largest share, alone or with it.
class WordChange : public Change {
 public:
  WordChange(const MeanLine& line, std::size_t now) : line_(line), now_(now) {}

  bool forceOnly() const override { return false; }
  std::size_t excessCount() const override { return line_.words().size() - 1; }
  void excesses(std::span<const double> values, std::span<double> out) const override {
    std::size_t next = 0;
    for (std::size_t word = 0; word < line_.words().size(); ++word) {
      if (word != now_) out[next++] = values[1 + word] - values[1 + now_] + kSameShare;
    }
  }
  void excessSlopes(std::span<const double> slopes, std::span<double> out) const override {
    std::size_t next = 0;
    for (std::size_t word = 0; word < line_.words().size(); ++word) {
      if (word != now_) out[next++] = slopes[1 + word] + slopes[1 + now_];
    }
  }
  bool happened(double x) const override { return another(x).has_value(); }
  /// The first other word that is largest at `x`.
  std::optional<std::size_t> another(double x) const {
    for (const std::size_t word : largestOf(line_.at(x))) {
      if (word != now_) return word;
    }
    return std::nullopt;
  }

 private:
  const MeanLine& line_;
  std::size_t now_;
};

/// The middle of the core of `term` within `variable`.
double middleOfCore(const fuzzy::Term& term, const fuzzy::Variable& variable) {
  const auto f = MembershipFunction::of(term);
  if (f.gaussian) return std::clamp(f.mean, variable.min, variable.max);
  return (std::clamp(f.b, variable.min, variable.max) + std::clamp(f.c, variable.min, variable.max)) / 2;
}

}  // namespace

base::Result<std::vector<Counterfactual>> counterfactuals(const fuzzy::ForceModel& model,
                                                          const fuzzy::CompiledModel& compiled,
                                                          std::span<const double> inputs,
                                                          const NoticeableDifference& noticeable,
                                                          std::optional<std::size_t> expert) {
  TACTUS_TRY(const auto explanation, explain(model, compiled, inputs));
  std::vector<double> point;
  for (const ExplainedInput& input : explanation.inputs) point.push_back(input.value);
  const Explorer explorer(model, compiled, point, expert);
  std::vector<Counterfactual> out;
  const auto now_n = explorer.force(0, point[0]);
  if (!now_n) return out;
  const double felt_n = noticeable(std::abs(*now_n));

  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const double now = point[i];
    for (const fuzzy::Term& term : explorer.terms(i)) {
      if (MembershipFunction::of(term)(now) >= kFullMembership) continue;
      const double value = middleOfCore(term, model.inputs[i]);
      if (const auto there_n = explorer.force(i, value)) {
        out.push_back({Counterfactual::Kind::kTerm, i, value, value - now, *there_n, term.id, {}});
      }
    }
    MeanLine line = explorer.line(i);
    const FeltChange felt_change(explorer, model.output, i, *now_n, felt_n);
    if (const auto felt = MoveSearch(line, felt_change).nearest(now)) {
      out.push_back({Counterfactual::Kind::kNoticeable, i, *felt, *felt - now, *explorer.force(i, *felt), {}, {}});
    }
    const LargestWords largest = largestOf(line.at(now));
    if (largest.size() > 1) {
      if (i == 0) {
        out.push_back({Counterfactual::Kind::kLargestWord, i, now, 0, *now_n, line.words()[largest[0]],
                       line.words()[largest[1]]});
      }
      continue;
    }
    const WordChange word_change(line, largest[0]);
    if (const auto word = MoveSearch(line, word_change).nearest(now)) {
      out.push_back({Counterfactual::Kind::kLargestWord, i, *word, *word - now, *explorer.force(i, *word),
                     line.words()[largest[0]], line.words()[*word_change.another(*word)]});
    }
  }
  return out;
}

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
