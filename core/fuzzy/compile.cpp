// From what people edit to what evaluates: names become indices, disabled rules disappear.
#include <algorithm>

#include "core/base/check.h"
#include "core/fuzzy/model_tables.h"
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

RuleTable compileExpert(const ForceModel& model, const Expert& expert,
                        std::vector<std::vector<MembershipFunction>>& banks) {
  // Bank of the variable at `index` (the output comes after the inputs): shared, or the expert's own.
  const auto bank_of = [&](const Variable& variable, std::size_t index) {
    const auto& terms = termsFor(expert, variable);
    if (&terms == &variable.terms) return static_cast<std::uint32_t>(index);
    banks.push_back(compileTerms(terms));
    return static_cast<std::uint32_t>(banks.size() - 1);
  };

  RuleTable table;
  table.weight = expert.weight;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) table.input_bank.push_back(bank_of(model.inputs[i], i));
  table.output_bank = bank_of(model.output, model.inputs.size());
  const auto& output_terms = termsFor(expert, model.output);
  for (const auto& rule : expert.rules) {
    if (!rule.enabled || rule.weight == 0) continue;
    table.rules.push_back({static_cast<std::uint32_t>(table.conditions.size()),
                           static_cast<std::uint16_t>(rule.conditions.size()),
                           static_cast<std::uint16_t>(indexOf(output_terms, rule.then)), rule.weight});
    for (const auto& condition : rule.conditions) {
      const std::size_t input = indexOf(model.inputs, condition.input);
      const auto& terms = termsFor(expert, model.inputs[input]);
      table.conditions.push_back(
          {static_cast<std::uint8_t>(input), static_cast<std::uint8_t>(indexOf(terms, condition.term))});
    }
  }
  return table;
}

}  // namespace

base::Result<CompiledModel> compile(const ForceModel& model) {
  if (auto ok = validate(model); !ok) return tl::unexpected(ok.error());

  auto tables = std::make_shared<ModelTables>();
  tables->output_min = model.output.min;
  tables->output_max = model.output.max;
  tables->default_force_n = model.default_force_n;
  tables->implication = model.implication;
  for (const auto& input : model.inputs) {
    tables->input_min.push_back(input.min);
    tables->input_max.push_back(input.max);
    tables->banks.push_back(compileTerms(input.terms));
  }
  tables->banks.push_back(compileTerms(model.output.terms));
  for (const auto& expert : model.experts) tables->experts.push_back(compileExpert(model, expert, tables->banks));
  const std::vector<std::optional<double>> nothing_fixed(model.inputs.size());
  tables->program = makeProgram(*tables, nothing_fixed);

  CompiledModel compiled;
  compiled.tables_ = std::move(tables);
  return compiled;
}

}  // namespace tactus::fuzzy
