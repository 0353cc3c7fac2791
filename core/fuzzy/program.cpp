// The fast form of a model: sections of experts, closed forms of output banks.
#include "core/fuzzy/program.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "core/fuzzy/kernels.h"
#include "core/fuzzy/section_plan.h"

namespace tactus::fuzzy {
namespace {

constexpr std::uint32_t kNoForm = std::numeric_limits<std::uint32_t>::max();

// Memory on the stack for the plan of a section; more is asked for where it is not enough.
constexpr std::size_t kBytesOfPlan = 16384;

/// Lists of experts that share their input terms: those without terms of their own, and each other one alone.
std::vector<std::vector<std::uint32_t>> sectionsOf(const ModelTables& tables) {
  const std::size_t inputs = tables.input_min.size();
  std::vector<std::vector<std::uint32_t>> sections(1);
  sections.front().reserve(tables.experts.size());
  for (std::uint32_t e = 0; e < tables.experts.size(); ++e) {
    const auto& banks = tables.experts[e].input_bank;
    if (std::all_of(banks.begin(), banks.end(), [inputs](std::uint32_t bank) { return bank < inputs; })) {
      sections.front().push_back(e);
    } else {
      sections.push_back({e});
    }
  }
  if (sections.front().empty()) sections.erase(sections.begin());
  return sections;
}

/// The closed forms of all output banks that experts have; false where one needs the general path.
bool addForms(const ModelTables& tables, std::vector<std::uint32_t>& form_of, Program& program) {
  form_of.assign(tables.banks.size(), kNoForm);
  for (const ExpertTable& table : tables.experts) {
    if (form_of[table.output_bank] != kNoForm) continue;
    form_of[table.output_bank] = sizeOf(program.forms);
    ClosedForm& form = program.forms.emplace_back(ClosedForm{program.memory});
    const auto bank = tables.bank(table.output_bank);
    if (!makeClosedForm(bank, tables.output_min, tables.output_max, tables.implication, form)) return false;
  }
  return true;
}

bool addSections(const ModelTables& tables, Program& program) {
  std::vector<std::uint32_t> form_of;
  if (!addForms(tables, form_of, program)) return false;
  program.point.expert_at.reserve(tables.experts.size());
  program.batch.experts.reserve(tables.experts.size());
  program.batch.rules.reserve(tables.rules.size());
  program.batch.groups.reserve(tables.rules.size());
  std::vector<std::uint32_t> scratch(tables.premises.size(), kUnplanned);
  for (const auto& experts : sectionsOf(tables)) {
    std::array<std::byte, kBytesOfPlan> buffer;
    std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
    const auto plan = planSection(tables, experts, program.forms, form_of, scratch, &memory);
    if (!plan) return false;
    program.zero_is_certain = program.zero_is_certain && plan->zero_is_certain;
    addSection(*plan, tables, program.forms, program.point);
    addSection(*plan, tables, program.forms, program.batch);
  }
  setChunks(program.batch);
  return true;
}

}  // namespace

void makeProgram(const ModelTables& tables, Program& program) {
  program.kernels = &activeKernels();
  program.clip = tables.implication == Implication::kClip;
  program.negligible = 1e-180 * (tables.output_max - tables.output_min);
  program.output_min = tables.output_min;
  program.inputs = tables.input_min.size();
  std::copy(tables.input_min.begin(), tables.input_min.end(), program.input_min.begin());
  std::copy(tables.input_max.begin(), tables.input_max.end(), program.input_max.begin());
  program.usable = addSections(tables, program);
}

}  // namespace tactus::fuzzy
