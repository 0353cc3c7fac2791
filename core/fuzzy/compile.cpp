// From what people edit to what evaluates: names become indices, disabled rules disappear.
#include <algorithm>

#include "core/base/check.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/validate.h"

namespace tactus::fuzzy {
namespace {

std::vector<MembershipFunction> compileTerms(const std::vector<Term>& terms) {
  std::vector<MembershipFunction> functions;
  functions.reserve(terms.size());
  for (const auto& term : terms) functions.push_back(MembershipFunction::of(term));
  return functions;
}

std::size_t indexOf(const std::vector<Term>& terms, const std::string& id) {
  const Term* const term = findTerm(terms, id);
  TACTUS_CHECK(term != nullptr);
  return static_cast<std::size_t>(term - terms.data());
}

std::size_t indexOf(const std::vector<Variable>& variables, const std::string& id) {
  const auto it = std::find_if(variables.begin(), variables.end(), [&id](const Variable& v) { return v.id == id; });
  TACTUS_CHECK(it != variables.end());
  return static_cast<std::size_t>(it - variables.begin());
}

}  // namespace

base::Result<CompiledModel> compile(const ForceModel& model) {
  if (auto ok = validate(model); !ok) return tl::unexpected(ok.error());

  CompiledModel out;
  out.output_min_ = model.output.min;
  out.output_max_ = model.output.max;
  out.default_force_n_ = model.default_force_n;
  out.implication_ = model.implication;
  for (const auto& input : model.inputs) {
    out.input_min_.push_back(input.min);
    out.input_max_.push_back(input.max);
    out.banks_.push_back(compileTerms(input.terms));
  }
  out.banks_.push_back(compileTerms(model.output.terms));

  // Bank of the variable at `index` (the output comes after the inputs) for one expert: shared, or the expert's own.
  const auto bank_of = [&](const Expert& expert, const Variable& variable, std::size_t index) {
    const auto& terms = termsFor(expert, variable);
    if (&terms == &variable.terms) return static_cast<std::uint32_t>(index);
    out.banks_.push_back(compileTerms(terms));
    return static_cast<std::uint32_t>(out.banks_.size() - 1);
  };

  double largest_weight = 0;
  for (const auto& expert : model.experts) largest_weight = std::max(largest_weight, expert.weight);
  for (const auto& expert : model.experts) {
    CompiledModel::CompiledExpert compiled;
    compiled.weight = expert.weight / largest_weight;
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      compiled.input_bank.push_back(bank_of(expert, model.inputs[i], i));
    }
    compiled.output_bank = bank_of(expert, model.output, model.inputs.size());
    const auto& output_terms = termsFor(expert, model.output);
    for (const auto& rule : expert.rules) {
      if (!rule.enabled || rule.weight == 0) continue;
      compiled.rules.push_back({static_cast<std::uint32_t>(compiled.conditions.size()),
                                static_cast<std::uint16_t>(rule.conditions.size()),
                                static_cast<std::uint16_t>(indexOf(output_terms, rule.then)), rule.weight});
      for (const auto& condition : rule.conditions) {
        const std::size_t input = indexOf(model.inputs, condition.input);
        const auto& terms = termsFor(expert, model.inputs[input]);
        compiled.conditions.push_back(
            {static_cast<std::uint8_t>(input), static_cast<std::uint8_t>(indexOf(terms, condition.term))});
      }
    }
    out.experts_.push_back(std::move(compiled));
  }
  return out;
}

}  // namespace tactus::fuzzy
