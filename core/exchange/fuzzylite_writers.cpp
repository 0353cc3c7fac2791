// FLL and the FCL that fuzzylite reads. fuzzylite is line based; words and order: docs/exchange.md.
#include "core/base/text.h"
#include "core/exchange/writers.h"

namespace tactus::exchange {
namespace {

using base::formatNumber;

std::string weightText(const IndexedRule& rule) {
  return rule.weight == 1 ? std::string() : " with " + formatNumber(rule.weight);
}

std::string ruleText(const ExpertView& view, const IndexedRule& rule) {
  return "if " + conditionsText(view, rule, {" is ", " and "}) + " then " + view.output.name + " is " +
         view.output.terms[rule.then].name + weightText(rule);
}

std::string fllVariable(const NamedVariable& variable, std::string_view kind) {
  std::string out = std::string(kind) + ": " + variable.name +
                    "\n  enabled: true\n  range: " + formatNumber(variable.variable->min) + " " +
                    formatNumber(variable.variable->max) +
                    "\n  lock-range: " + (kind == "InputVariable" ? "true" : "false") + "\n";
  if (kind == "OutputVariable")
    out += "  aggregation: Maximum\n  defuzzifier: Centroid 1000\n  default: nan\n  lock-previous: false\n";
  for (const NamedTerm& term : variable.terms) out += "  term: " + term.name + " " + fuzzyliteShape(*term.term) + "\n";
  return out;
}

bool scales(const ExpertView& view) { return view.model->implication == fuzzy::Implication::kScale; }

std::string fclTerms(const NamedVariable& variable) {
  std::string out =
      "  RANGE := (" + formatNumber(variable.variable->min) + " .. " + formatNumber(variable.variable->max) + ");\n";
  for (const NamedTerm& term : variable.terms) {
    out += "  TERM " + term.name + " := " + fuzzyliteShape(*term.term) + ";\n";
  }
  return out;
}

}  // namespace

std::string fuzzyliteShape(const fuzzy::Term& term) {
  constexpr std::string_view kNames[] = {"Trapezoid", "Triangle", "Gaussian"};
  std::string out(kNames[static_cast<int>(term.shape)]);
  for (const double point : term.points) out += " " + formatNumber(point);
  return out;
}

std::string conditionsText(const ExpertView& view, const IndexedRule& rule, const RuleWords& words) {
  std::string out;
  for (const auto& [input, term] : rule.conditions) {
    if (!out.empty()) out += words.join;
    out += view.inputs[input].name;
    out += words.condition_is;
    out += view.inputs[input].terms[term].name;
  }
  return out;
}

std::vector<std::string> missingEvents(const fuzzy::ForceModel& model) {
  std::vector<std::string> out;
  for (const std::string& event : fuzzy::eventTexts(model))
    out.push_back("not in this file: puncture, " + base::oneLine(event));
  return out;
}

std::string remarks(const ExpertView& view, std::string_view mark) {
  const std::string start = std::string(mark) + " ";
  std::string out = start + base::oneLine(view.model->name) + ", expert " + base::oneLine(view.expert->id) + "\n";
  if (!view.origin.empty()) out += start + base::oneLine(view.origin) + "\n";
  const auto names = [&](const NamedVariable& variable) {
    out += start + variable.name + ": " + base::oneLine(variable.variable->label) + ", in " +
           base::oneLine(variable.variable->unit) + "; values outside its range are clamped\n";
  };
  for (const NamedVariable& input : view.inputs) names(input);
  if (view.disabled_rules > 0) out += start + std::to_string(view.disabled_rules) + " disabled rules are left out\n";
  for (const std::string& event : missingEvents(*view.model)) out += start + event + "\n";
  return out;
}

std::string fllText(const ExpertView& view) {
  std::string out = remarks(view, "#") + "Engine: " + view.name + "\n";
  for (const NamedVariable& input : view.inputs) out += fllVariable(input, "InputVariable");
  out += fllVariable(view.output, "OutputVariable");
  out += "RuleBlock: rules\n  enabled: true\n  conjunction: Minimum\n  disjunction: none\n  implication: ";
  out += scales(view) ? "AlgebraicProduct" : "Minimum";
  out += "\n  activation: General\n";
  for (const IndexedRule& rule : view.rules) out += "  rule: " + ruleText(view, rule) + "\n";
  return out;
}

std::string fclFuzzyliteText(const ExpertView& view) {
  std::string out = remarks(view, "//") + "FUNCTION_BLOCK " + view.name + "\n\nVAR_INPUT\n";
  for (const NamedVariable& input : view.inputs) out += "  " + input.name + ": REAL;\n";
  out += "END_VAR\n\nVAR_OUTPUT\n  " + view.output.name + ": REAL;\nEND_VAR\n";
  for (const NamedVariable& input : view.inputs) {
    out += "\nFUZZIFY " + input.name + "\n" + fclTerms(input) + "END_FUZZIFY\n";
  }
  out += "\nDEFUZZIFY " + view.output.name + "\n" + fclTerms(view.output);
  out += "  METHOD : COG;\n  ACCU : MAX;\n  DEFAULT := nan;\nEND_DEFUZZIFY\n\nRULEBLOCK rules\n  AND : MIN;\n  ACT : ";
  out += scales(view) ? "PROD;\n" : "MIN;\n";
  for (std::size_t i = 0; i < view.rules.size(); ++i) {
    out += "  RULE " + std::to_string(i + 1) + " : " + ruleText(view, view.rules[i]) + "\n";
  }
  return out + "END_RULEBLOCK\n\nEND_FUNCTION_BLOCK\n";
}

}  // namespace tactus::exchange
