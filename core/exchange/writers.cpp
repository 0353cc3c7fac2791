// A model as text in each dialect (dialect.h).
#include "core/exchange/writers.h"

#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::exchange {

// FCL of IEC 61131-7: terms as points, `(* *)` comments, ACCU in the rule block.

namespace {

using base::formatNumber;

struct Point {
  double x;
  double y;
};

/// The points of a term. Beyond its first and last point it continues flat, so a shoulder at the end of the universe
/// begins at that end.
std::vector<Point> pointsOf(const fuzzy::Term& term, const fuzzy::Variable& variable) {
  const Corners f = cornersOf(term);
  std::vector<Point> points;
  const auto add = [&points](double x, double y) {
    if (points.empty() || points.back().x != x || points.back().y != y) points.push_back({x, y});
  };
  if (f.b <= variable.min && f.c > variable.min) {
    add(variable.min, 1);
  } else {
    add(f.a, 0);
    add(f.b, 1);
  }
  if (f.c >= variable.max && f.b < variable.max) {
    add(variable.max, 1);
  } else {
    add(f.c, 1);
    add(f.d, 0);
  }
  return points;
}

std::string termsText(const NamedVariable& variable) {
  std::string out;
  for (const NamedTerm& term : variable.terms) {
    out += "  TERM " + term.name + " :=";
    for (const Point& point : pointsOf(*term.term, *variable.variable)) {
      out += " (" + formatNumber(point.x) + ", " + formatNumber(point.y) + ")";
    }
    out += ";\n";
  }
  return out;
}

/// A comment cannot hold its own end.
std::string commented(std::string text) {
  for (std::size_t at = text.find("*)"); at != std::string::npos; at = text.find("*)")) text.replace(at, 2, "* )");
  return "(* " + text + " *)\n";
}

base::Result<void> wantTrapezoids(const NamedVariable& variable) {
  for (const NamedTerm& term : variable.terms) {
    if (term.term->shape != fuzzy::Shape::kGaussian) continue;
    return base::fail(base::ErrorCode::kValue, "term " + base::quoted(term.term->id) + " of " + variable.name,
                      "a Gaussian", "trapezoids and triangles, all that FCL of IEC 61131-7 can carry");
  }
  return {};
}

}  // namespace

base::Result<std::string> fclIecText(const ExpertView& view) {
  for (const NamedVariable& input : view.inputs) {
    if (const auto ok = wantTrapezoids(input); !ok) return tl::unexpected(ok.error());
  }
  if (const auto ok = wantTrapezoids(view.output); !ok) return tl::unexpected(ok.error());

  std::string out;
  std::string text = remarks(view, "");
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
    out += commented(text.substr(1, end - 1));
    text.erase(0, end + 1);
  }
  out += "FUNCTION_BLOCK " + view.name + "\n\nVAR_INPUT\n";
  for (const NamedVariable& input : view.inputs) out += "  " + input.name + " : REAL;\n";
  out += "END_VAR\n\nVAR_OUTPUT\n  " + view.output.name + " : REAL;\nEND_VAR\n";
  for (const NamedVariable& input : view.inputs) {
    out += "\nFUZZIFY " + input.name + "\n" + termsText(input) + "END_FUZZIFY\n";
  }
  const fuzzy::Variable& force = *view.output.variable;
  out += "\nDEFUZZIFY " + view.output.name + "\n" + termsText(view.output) +
         "  METHOD : COG;\n  DEFAULT := " + formatNumber(view.model->default_force_n) + ";\n  RANGE := (" +
         formatNumber(force.min) + " .. " + formatNumber(force.max) +
         ");\nEND_DEFUZZIFY\n\nRULEBLOCK rules\n  AND : MIN;\n  ACT : ";
  out += view.model->implication == fuzzy::Implication::kScale ? "PROD" : "MIN";
  out += ";\n  ACCU : MAX;\n";
  for (std::size_t i = 0; i < view.rules.size(); ++i) {
    const IndexedRule& rule = view.rules[i];
    out += "  RULE " + std::to_string(i + 1) + " : IF " + conditionsText(view, rule, {" IS ", " AND "}) + " THEN " +
           view.output.name + " IS " + view.output.terms[rule.then].name;
    if (rule.weight != 1) out += " WITH " + formatNumber(rule.weight);
    out += ";\n";
  }
  return out + "END_RULEBLOCK\n\nEND_FUNCTION_BLOCK\n";
}

// FIS of MATLAB and Octave, version 2.0.

namespace {

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

// FML of IEEE 1855-2016. Every name is an xs:ID and unique in the whole document, so terms carry their variable's.

namespace {

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

// FLL and the FCL that fuzzylite reads. fuzzylite is line based; words and order: docs/exchange.md.

namespace {

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
