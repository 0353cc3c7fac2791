#include "elicitation/rules/rule_finding.h"

#include <algorithm>
#include <utility>

#include "core/analysis/rule_table.h"
#include "core/analysis/sample_points.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::elicitation {
namespace {

/// For each input the term that `conditions` ask for, or null; nothing where an input or a term is unknown.
std::optional<std::vector<const fuzzy::Term*>> resolve(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                                       const std::vector<fuzzy::Condition>& conditions) {
  std::vector<const fuzzy::Term*> terms(model.inputs.size(), nullptr);
  for (const auto& condition : conditions) {
    const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&condition](const fuzzy::Variable& v) { return v.id == condition.input; });
    if (input == model.inputs.end()) return std::nullopt;
    const fuzzy::Term* const term = findTerm(termsFor(expert, *input), condition.term);
    if (term == nullptr) return std::nullopt;
    terms[static_cast<std::size_t>(input - model.inputs.begin())] = term;
  }
  return terms;
}

/// The model with one expert for each answer: expert number `expert` with that answer as one more rule.
fuzzy::ForceModel withEachAnswer(const fuzzy::ForceModel& model, std::size_t expert,
                                 const std::vector<fuzzy::Condition>& conditions) {
  fuzzy::ForceModel out;
  out.inputs = model.inputs;
  out.output = model.output;
  out.implication = model.implication;
  for (const auto& term : termsFor(model.experts[expert], model.output)) {
    out.experts.push_back(model.experts[expert]);
    out.experts.back().id = term.id;
    out.experts.back().weight = 1;
    out.experts.back().rules.push_back({conditions, term.id, 1, true});
  }
  return out;
}

}  // namespace

std::optional<AnswerStake> answerStake(const analysis::ForceProbe& probe, std::size_t expert,
                                       const std::vector<fuzzy::Condition>& conditions, std::size_t samples) {
  const auto& model = probe.model();
  const auto terms = resolve(model, model.experts[expert], conditions);
  if (!terms) return std::nullopt;
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const fuzzy::Term* const term = (*terms)[i];
    if (term == nullptr) {
      values.push_back(probe.values(i));
      continue;
    }
    values.push_back({analysis::peakPosition(*term, model.inputs[i].min, model.inputs[i].max)});
    if (fuzzy::MembershipFunction::of(*term)(values.back().front()) < 1) return std::nullopt;
  }
  // An answer that is there already makes a rule twice, which is not a model.
  const auto compiled = fuzzy::compile(withEachAnswer(model, expert, conditions));
  if (!compiled) return std::nullopt;

  AnswerStake largest;
  const analysis::SamplePoints points(std::move(values), samples);
  for (std::size_t p = 0; p < points.size(); ++p) {
    auto point = points[p];
    double low = model.output.max;
    double high = model.output.min;
    for (std::size_t answer = 0; answer < compiled->expertCount(); ++answer) {
      const double force_n = compiled->evaluateExpert(answer, point).force_n;
      low = std::min(low, force_n);
      high = std::max(high, force_n);
    }
    if (largest.point.empty() || high - low > largest.newtons) largest = {high - low, std::move(point)};
  }
  return largest;
}

bool wouldFireIn(const analysis::Hole& hole, const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                 const std::vector<fuzzy::Condition>& conditions) {
  const auto terms = resolve(model, expert, conditions);
  if (!terms) return false;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const fuzzy::Term* const term = (*terms)[i];
    if (term == nullptr) continue;
    const double best = analysis::peakPosition(*term, hole.ranges[i].low, hole.ranges[i].high);
    if (fuzzy::MembershipFunction::of(*term)(best) == 0) return false;
  }
  return true;
}

namespace {

using Source = RuleFinding::Source;

// More than the items of one region; the complete list is in the finding.
constexpr std::size_t kMostListed = 12;

/// `item 3`, `items 3, 8`, `items 3, 8, … and 20 more`.
std::string counted(const std::string& word, const std::vector<std::string>& numbers) {
  const std::size_t listed = std::min(numbers.size(), kMostListed);
  std::string text = word + (numbers.size() > 1 ? "s " : " ");
  text += base::joined(std::vector<std::string>(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(listed)),
                       ", ");
  if (numbers.size() > listed) text += " and " + std::to_string(numbers.size() - listed) + " more";
  return text;
}

}  // namespace

std::string describe(const std::vector<Source>& sources) {
  if (sources.empty()) return {};
  const bool items = sources.front().origin.item > 0;
  std::vector<std::string> numbers;
  std::vector<std::string> lines;
  for (const auto& source : sources) {
    numbers.push_back(std::to_string(items ? source.origin.item : static_cast<int>(source.rule.value_or(0)) + 1));
    if (source.origin.line.number > 0) lines.push_back(std::to_string(source.origin.line.number));
  }
  std::string text = counted(items ? "item" : "rule", numbers);
  if (lines.empty()) return text;
  return text + " (" + std::string(items ? study::kAnswersTable : study::kRulesTable) + ", " + counted("line", lines) +
         ")";
}

}  // namespace tactus::elicitation
