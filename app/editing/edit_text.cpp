#include "app/editing/edit_text.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactus::editing {

std::string labelOf(const fuzzy::Variable& variable) { return variable.label.empty() ? variable.id : variable.label; }
std::string labelOf(const fuzzy::Term& term) { return term.label.empty() ? term.id : term.label; }
std::string labelOf(const fuzzy::Expert& expert) { return expert.label.empty() ? expert.id : expert.label; }

std::string pointName(fuzzy::Shape shape, std::size_t point) {
  constexpr const char* kTrapezoid[] = {"left foot", "left shoulder", "right shoulder", "right foot"};
  constexpr const char* kTriangle[] = {"left foot", "peak", "right foot"};
  constexpr const char* kGaussian[] = {"mean", "sigma"};
  switch (shape) {
    case fuzzy::Shape::kTrapezoid: return kTrapezoid[point];
    case fuzzy::Shape::kTriangle: return kTriangle[point];
    case fuzzy::Shape::kGaussian: return kGaussian[point];
  }
  return {};
}

std::string numberText(const fuzzy::Variable& variable, double value) {
  constexpr double kSteps = 10000;
  constexpr int kMostDecimals = 12;
  constexpr double kLargestInDigits = 1e12;
  if (std::abs(value) > kLargestInDigits) return base::formatNumber(value);
  const double step = (variable.max - variable.min) / kSteps;
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, kMostDecimals);
  std::string text = base::formatFixed(value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string quantityText(const fuzzy::Variable& variable, double value) {
  const std::string number = numberText(variable, value);
  return variable.unit.empty() || variable.unit == "1" ? number : number + ' ' + variable.unit;
}

std::string conditionsText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule) {
  std::string out;
  for (const auto& condition : rule.conditions) {
    out += out.empty() ? "IF " : " AND ";
    const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&](const fuzzy::Variable& v) { return v.id == condition.input; });
    if (input == model.inputs.end()) {
      out += condition.input + " is " + condition.term;
      continue;
    }
    const fuzzy::Term* const term = findTerm(termsFor(expert, *input), condition.term);
    out += labelOf(*input) + " is " + (term == nullptr ? condition.term : labelOf(*term));
  }
  return out;
}

std::string consequentText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const std::string& id) {
  const fuzzy::Term* const term = findTerm(termsFor(expert, model.output), id);
  return term == nullptr ? id : labelOf(*term);
}

}  // namespace tactus::editing
