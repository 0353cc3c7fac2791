// From what people edit to what evaluates: names become indices, disabled rules disappear.
#include "core/fuzzy/model_tables.h"
#include "core/fuzzy/resolve.h"

namespace tactus::fuzzy {
namespace {

std::vector<MembershipFunction> compileTerms(const std::vector<Term>& terms) {
  std::vector<MembershipFunction> functions;
  functions.reserve(terms.size());
  for (const auto& term : terms) functions.push_back(MembershipFunction::of(term));
  return functions;
}

/// Chooses the banks of an expert: those of the variables, or new ones for its own lists of terms.
void setBanks(const ForceModel& model, const Expert& expert, std::vector<std::vector<MembershipFunction>>& banks,
              RuleTable& table) {
  // Bank of the variable at `index`; the output comes after the inputs.
  const auto bank_of = [&](const Variable& variable, std::size_t index) {
    const auto& terms = termsFor(expert, variable);
    if (&terms == &variable.terms) return static_cast<std::uint32_t>(index);
    banks.push_back(compileTerms(terms));
    return static_cast<std::uint32_t>(banks.size() - 1);
  };
  table.input_bank.reserve(model.inputs.size());
  for (std::size_t i = 0; i < model.inputs.size(); ++i) table.input_bank.push_back(bank_of(model.inputs[i], i));
  table.output_bank = bank_of(model.output, model.inputs.size());
}

}  // namespace

base::Result<CompiledModel> compile(const ForceModel& model) {
  auto tables = std::make_shared<ModelTables>();
  if (auto ok = resolve(model, tables->experts); !ok) return tl::unexpected(ok.error());
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
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    setBanks(model, model.experts[e], tables->banks, tables->experts[e]);
  }
  long double all_weights = 0;
  for (const RuleTable& table : tables->experts) all_weights += table.weight;
  for (RuleTable& table : tables->experts) table.share = static_cast<double>(table.weight / all_weights);
  tables->program = makeProgram(*tables);

  CompiledModel compiled;
  compiled.tables_ = std::move(tables);
  return compiled;
}

}  // namespace tactus::fuzzy
