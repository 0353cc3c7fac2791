#include "app/cli/model_words.h"

#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::cli {

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

}  // namespace tactus::cli
