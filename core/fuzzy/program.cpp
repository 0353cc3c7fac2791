// The fast form of a model: sections of experts, closed forms of output banks.
#include "core/fuzzy/program.h"

#include <algorithm>
#include <limits>

#include "core/fuzzy/kernels.h"
#include "core/fuzzy/section_plan.h"

namespace tactus::fuzzy {
namespace {

constexpr std::uint32_t kNoForm = std::numeric_limits<std::uint32_t>::max();

/// Lists of experts that share their input terms: those without terms of their own, and each other one alone.
std::vector<std::vector<std::uint32_t>> sectionsOf(const ModelTables& tables) {
  std::vector<std::vector<std::uint32_t>> sections(1);
  for (std::uint32_t e = 0; e < tables.experts.size(); ++e) {
    const auto& banks = tables.experts[e].input_bank;
    const bool shares = std::all_of(banks.begin(), banks.end(), [&](std::uint32_t b) { return b < banks.size(); });
    if (shares) {
      sections.front().push_back(e);
    } else {
      sections.push_back({e});
    }
  }
  if (sections.front().empty()) sections.erase(sections.begin());
  return sections;
}

}  // namespace

Program makeProgram(const ModelTables& tables) {
  Program program;
  program.kernels = &activeKernels();
  const Program unusable = program;
  program.clip = tables.implication == Implication::kClip;
  program.negligible = 1e-180 * (tables.output_max - tables.output_min);
  program.output_min = tables.output_min;
  std::copy(tables.input_min.begin(), tables.input_min.end(), program.input_min.begin());
  std::copy(tables.input_max.begin(), tables.input_max.end(), program.input_max.begin());

  std::vector<std::uint32_t> form_of(tables.banks.size(), kNoForm);
  for (const RuleTable& table : tables.experts) {
    if (form_of[table.output_bank] != kNoForm) continue;
    auto form = closedForm(tables.banks[table.output_bank], tables.output_min, tables.output_max, tables.implication);
    if (!form) return unusable;
    form_of[table.output_bank] = static_cast<std::uint32_t>(program.forms.size());
    program.forms.push_back(std::move(*form));
  }
  BatchProgram batch;
  for (const auto& experts : sectionsOf(tables)) {
    const auto plan = planSection(tables, experts, program.forms, form_of);
    if (!plan) return unusable;
    program.zero_is_certain = program.zero_is_certain && plan->zero_is_certain;
    addSection(*plan, tables, program.forms, program.point);
    addSection(*plan, tables, program.forms, batch);
  }
  program.batch = specialised(batch, std::vector<std::optional<double>>(tables.input_min.size()));
  program.usable = true;
  return program;
}

}  // namespace tactus::fuzzy
