// FIS of MATLAB and Octave, version 2.0.
#include "core/base/text.h"
#include "core/exchange/writers.h"

namespace tactus::exchange {
namespace {

using base::formatNumber;

/// Octave wants a < b and c < d. A shoulder at the end of the universe is moved out by the universe's width, where
/// nothing is evaluated; a vertical edge inside stays, for the readers that take it.
Corners withSlopes(Corners f, const fuzzy::Variable& variable) {
  const double width = variable.max - variable.min;
  if (f.a == f.b && f.b <= variable.min) f.a = f.b - width;
  if (f.c == f.d && f.c >= variable.max) f.d = f.c + width;
  return f;
}

std::string shapeText(const fuzzy::Term& term, const fuzzy::Variable& variable) {
  if (term.shape == fuzzy::Shape::kGaussian)
    return "'gaussmf',[" + formatNumber(term.points[1]) + " " + formatNumber(term.points[0]) + "]";
  const Corners f = withSlopes(cornersOf(term), variable);
  std::string points = formatNumber(f.a) + " " + formatNumber(f.b) + " ";
  if (term.shape == fuzzy::Shape::kTriangle) return "'trimf',[" + points + formatNumber(f.d) + "]";
  return "'trapmf',[" + points + formatNumber(f.c) + " " + formatNumber(f.d) + "]";
}

std::string section(const std::string& title, const NamedVariable& variable) {
  std::string out = "\n[" + title + "]\nName='" + variable.name + "'\nRange=[" + formatNumber(variable.variable->min) +
                    " " + formatNumber(variable.variable->max) + "]\nNumMFs=" + std::to_string(variable.terms.size()) +
                    "\n";
  for (std::size_t i = 0; i < variable.terms.size(); ++i) {
    const NamedTerm& term = variable.terms[i];
    out += "MF" + std::to_string(i + 1) + "='" + term.name + "':" + shapeText(*term.term, *variable.variable) + "\n";
  }
  return out;
}

/// `3 0 0 1, 1 (1) : 1`: the terms by number, 0 where the rule does not ask.
std::string fisRuleText(const ExpertView& view, const IndexedRule& rule) {
  std::string out;
  for (std::size_t i = 0; i < view.inputs.size(); ++i) {
    std::size_t term = 0;
    for (const auto& [input, index] : rule.conditions) {
      if (input == i) term = index + 1;
    }
    out += (i > 0 ? " " : "") + std::to_string(term);
  }
  return out + ", " + std::to_string(rule.then + 1) + " (" + formatNumber(rule.weight) + ") : 1\n";
}

}  // namespace

std::string fisText(const ExpertView& view) {
  // Octave's toolkit (0.4.6) takes the maximum over one rule along the universe. Twice it has the same meaning.
  std::vector<IndexedRule> rules = view.rules;
  if (rules.size() == 1) rules.push_back(rules.front());
  std::string out = remarks(view, "%") + "[System]\nName='" + view.name +
                    "'\nType='mamdani'\nVersion=2.0\nNumInputs=" + std::to_string(view.inputs.size()) +
                    "\nNumOutputs=1\nNumRules=" + std::to_string(rules.size()) +
                    "\nAndMethod='min'\nOrMethod='max'\nImpMethod='";
  out += view.model->implication == fuzzy::Implication::kScale ? "prod" : "min";
  out += "'\nAggMethod='max'\nDefuzzMethod='centroid'\n";
  for (std::size_t i = 0; i < view.inputs.size(); ++i) out += section("Input" + std::to_string(i + 1), view.inputs[i]);
  out += section("Output1", view.output) + "\n[Rules]\n";
  for (const IndexedRule& rule : rules) out += fisRuleText(view, rule);
  return out;
}

}  // namespace tactus::exchange
