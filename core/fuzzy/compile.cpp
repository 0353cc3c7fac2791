// From what people edit to what evaluates: names become indices, disabled rules disappear.
#include <numeric>
#include <utility>

#include "core/fuzzy/model_tables.h"
#include "core/fuzzy/resolve.h"

namespace tactus::fuzzy {
namespace {

// What the tables of a model need, roughly.
constexpr std::size_t kBytesOfModel = 8192;
constexpr std::size_t kBytesOfRule = 128;

std::size_t likelyBytes(const ForceModel& model) {
  std::size_t rules = 0;
  for (const Expert& expert : model.experts) rules += expert.rules.size();
  return kBytesOfModel + kBytesOfRule * rules;
}

std::uint32_t addBank(const std::vector<Term>& terms, ModelTables& tables) {
  const std::uint32_t first = sizeOf(tables.terms);
  for (const Term& term : terms) tables.terms.push_back(MembershipFunction::of(term));
  tables.banks.push_back({first, sizeOf(terms)});
  return sizeOf(tables.banks) - 1;
}

/// Chooses the banks of an expert: those of the variables, or new ones for its own lists of terms.
void setBanks(const ForceModel& model, const Expert& expert, ModelTables& tables, ExpertTable& table) {
  // Bank of the variable at `index`; the output comes after the inputs.
  const auto bank_of = [&](const Variable& variable, std::size_t index) {
    const auto& terms = termsFor(expert, variable);
    return &terms == &variable.terms ? static_cast<std::uint32_t>(index) : addBank(terms, tables);
  };
  for (std::size_t i = 0; i < model.inputs.size(); ++i) table.input_bank[i] = bank_of(model.inputs[i], i);
  table.output_bank = bank_of(model.output, model.inputs.size());
}

void addBanks(const ForceModel& model, ModelTables& tables) {
  std::size_t terms = model.output.terms.size();
  std::size_t banks = model.inputs.size() + 1;
  for (const Variable& input : model.inputs) terms += input.terms.size();
  for (const Expert& expert : model.experts) {
    for (const TermOverride& own : expert.overrides) terms += own.terms.size();
    banks += expert.overrides.size();
  }
  tables.terms.reserve(terms);
  tables.banks.reserve(banks);
  tables.input_min.reserve(model.inputs.size());
  tables.input_max.reserve(model.inputs.size());
  for (const Variable& input : model.inputs) {
    tables.input_min.push_back(input.min);
    tables.input_max.push_back(input.max);
    addBank(input.terms, tables);
  }
  addBank(model.output.terms, tables);
  for (std::size_t e = 0; e < model.experts.size(); ++e) setBanks(model, model.experts[e], tables, tables.experts[e]);
}

}  // namespace

base::Result<CompiledModel> compile(const ForceModel& model) {
  auto tables = std::make_shared<ModelTables>(likelyBytes(model));
  if (auto wrong = resolve(model, *tables)) return tl::unexpected(std::move(*wrong));
  tables->output_min = model.output.min;
  tables->output_max = model.output.max;
  tables->default_force_n = model.default_force_n;
  tables->implication = model.implication;
  addBanks(model, *tables);
  const std::vector<double> weights = normalizedWeights(model);
  const double all_weights = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t e = 0; e < weights.size(); ++e) {
    ExpertTable& table = tables->experts[e];
    table.weight = weights[e];
    table.share = weights[e] / all_weights;
  }
  makeProgram(*tables, tables->program);

  CompiledModel compiled;
  compiled.tables_ = std::move(tables);
  return compiled;
}

}  // namespace tactus::fuzzy
