// FML of IEEE 1855-2016. Every name is an xs:ID and unique in the whole document, so terms carry their variable's.
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/exchange/writers.h"

namespace tactus::exchange {
namespace {

using base::formatNumber;

std::string escaped(std::string_view text) { return base::xmlEscaped(base::oneLine(text)); }

std::string termName(const NamedVariable& variable, std::size_t term) {
  return variable.name + "__" + variable.terms[term].name;
}

std::string variableText(const NamedVariable& variable, bool output) {
  constexpr std::string_view kShapes[] = {"trapezoidShape", "triangularShape", "gaussianShape"};
  const fuzzy::Variable& from = *variable.variable;
  std::string out = "    <fuzzyVariable name=\"" + variable.name + "\" scale=\"" + escaped(from.unit) +
                    "\" domainleft=\"" + formatNumber(from.min) + "\" domainright=\"" + formatNumber(from.max) +
                    "\" type=\"";
  out += output ? "output\" accumulation=\"MAX\" defuzzifier=\"COG\" defaultValue=\"NaN\">\n" : "input\">\n";
  for (std::size_t t = 0; t < variable.terms.size(); ++t) {
    const fuzzy::Term& term = *variable.terms[t].term;
    out += "      <fuzzyTerm name=\"" + termName(variable, t) + "\"><" +
           std::string(kShapes[static_cast<int>(term.shape)]);
    for (std::size_t p = 0; p < term.points.size(); ++p) {
      out += " param" + std::to_string(p + 1) + "=\"" + formatNumber(term.points[p]) + "\"";
    }
    out += "/></fuzzyTerm>\n";
  }
  return out + "    </fuzzyVariable>\n";
}

std::string clause(const NamedVariable& variable, std::size_t term) {
  return "<clause><variable>" + variable.name + "</variable><term>" + termName(variable, term) + "</term></clause>";
}

/// A comment of XML cannot hold two hyphens, nor end with one.
std::string xmlComment(const std::string& text) {
  std::string out;
  for (const char c : escaped(text)) out += c == '-' && out.ends_with('-') ? " -" : std::string(1, c);
  return "<!-- " + out + " -->\n";
}

}  // namespace

std::string fmlText(const ExpertView& view) {
  const std::string activation = view.model->implication == fuzzy::Implication::kScale ? "PROD" : "MIN";
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + (view.origin.empty() ? "" : xmlComment(view.origin));
  for (const std::string& event : missingEvents(*view.model)) out += xmlComment(event);
  out += "<fuzzySystem xmlns=\"http://www.ieee1855.org\" name=\"" + view.name + "\">\n  <knowledgeBase>\n";
  for (const NamedVariable& input : view.inputs) out += variableText(input, false);
  out += variableText(view.output, true) + "  </knowledgeBase>\n  <mamdaniRuleBase name=\"" + view.name +
         "__rules\" activationMethod=\"" + activation + "\" andMethod=\"MIN\" orMethod=\"MAX\">\n";
  for (std::size_t i = 0; i < view.rules.size(); ++i) {
    const IndexedRule& rule = view.rules[i];
    out += "    <rule name=\"" + view.name + "__rule_" + std::to_string(i + 1) +
           "\" connector=\"and\" andMethod=\"MIN\" weight=\"" + formatNumber(rule.weight) + "\">\n      <antecedent>";
    for (const auto& [input, term] : rule.conditions) out += clause(view.inputs[input], term);
    out += "</antecedent>\n      <consequent><then>" + clause(view.output, rule.then) + "</then></consequent></rule>\n";
  }
  return out + "  </mamdaniRuleBase>\n</fuzzySystem>\n";
}

}  // namespace tactus::exchange
