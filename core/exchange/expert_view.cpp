#include "core/exchange/expert_view.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>

#include "core/base/text.h"

namespace tactus::exchange {
namespace {

// Words of FCL, the hedges of FLL, and functions that its readers know.
constexpr std::string_view kTaken[] = {"and",
                                       "or",
                                       "not",
                                       "if",
                                       "then",
                                       "is",
                                       "with",
                                       "rule",
                                       "term",
                                       "range",
                                       "default",
                                       "method",
                                       "accu",
                                       "act",
                                       "real",
                                       "nc",
                                       "ruleblock",
                                       "end_ruleblock",
                                       "fuzzify",
                                       "end_fuzzify",
                                       "defuzzify",
                                       "end_defuzzify",
                                       "var_input",
                                       "var_output",
                                       "end_var",
                                       "function_block",
                                       "end_function_block",
                                       "any",
                                       "extremely",
                                       "seldom",
                                       "somewhat",
                                       "very",
                                       "min",
                                       "max",
                                       "abs",
                                       "sin",
                                       "cos",
                                       "exp",
                                       "log",
                                       "pow",
                                       "nan",
                                       "inf",
                                       "none",
                                       "enabled"};

bool isTaken(std::string_view lowered) {
  return std::find(std::begin(kTaken), std::end(kTaken), lowered) != std::end(kTaken);
}

/// Gives each id a name of its own.
class GivenNames {
 public:
  std::string of(std::string_view id) {
    std::string name;
    for (const char c : id) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    if (std::isalpha(static_cast<unsigned char>(name.front())) == 0) name.insert(0, "x_");
    if (isTaken(base::lowered(name))) name += "_";
    const std::string first = name;
    for (int copy = 2; !used_.insert(base::lowered(name)).second; ++copy) name = first + "_" + std::to_string(copy);
    return name;
  }

 private:
  std::set<std::string> used_;
};

NamedVariable named(const fuzzy::Variable& variable, const fuzzy::Expert& expert, GivenNames& names) {
  NamedVariable out{names.of(variable.id), &variable, {}};
  GivenNames own;
  for (const fuzzy::Term& term : fuzzy::termsFor(expert, variable)) out.terms.push_back({own.of(term.id), &term});
  return out;
}

std::size_t termIndex(const NamedVariable& variable, std::string_view id) {
  return static_cast<std::size_t>(std::find_if(variable.terms.begin(), variable.terms.end(),
                                               [&](const NamedTerm& term) { return term.term->id == id; }) -
                                  variable.terms.begin());
}

}  // namespace

ExpertView viewOf(const fuzzy::ForceModel& model, std::size_t expert) {
  const fuzzy::Expert& from = model.experts[expert];
  ExpertView view{&model, &from, {}, {}, {}, {}, 0};
  GivenNames names;
  for (const fuzzy::Variable& input : model.inputs) view.inputs.push_back(named(input, from, names));
  view.output = named(model.output, from, names);
  view.name = names.of("force_model_" + from.id);
  for (const fuzzy::Rule& rule : from.rules) {
    if (!rule.enabled) {
      ++view.disabled_rules;
      continue;
    }
    IndexedRule out;
    for (std::size_t i = 0; i < view.inputs.size(); ++i) {
      for (const fuzzy::Condition& condition : rule.conditions) {
        if (condition.input != model.inputs[i].id) continue;
        out.conditions.emplace_back(i, termIndex(view.inputs[i], condition.term));
      }
    }
    out.then = termIndex(view.output, rule.then);
    out.weight = rule.weight;
    view.rules.push_back(std::move(out));
  }
  return view;
}

Corners cornersOf(const fuzzy::Term& term) {
  const auto& p = term.points;
  return term.shape == fuzzy::Shape::kTriangle ? Corners{p[0], p[1], p[1], p[2]} : Corners{p[0], p[1], p[2], p[3]};
}

}  // namespace tactus::exchange
