// FCL of IEC 61131-7: terms as points, `(* *)` comments, ACCU in the rule block.
#include <vector>

#include "core/base/text.h"
#include "core/exchange/writers.h"

namespace tactus::exchange {
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

}  // namespace tactus::exchange
