// The fast form of a model: sections of experts, closed forms of output banks.
#include "core/fuzzy/program.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>

#include "core/fuzzy/kernels.h"
#include "core/fuzzy/section_plan.h"

namespace tactus::fuzzy {

// The program for many points: groups of rules with one pivot term and one output term.

namespace {

/// Adds the rules of one expert, sorted by lane and row. `ends` is scratch: the end of each group.
void addExpert(const SectionPlan& plan, const PlannedExpert& expert, std::size_t lanes, Table<std::uint32_t>& ends,
               BatchProgram& program) {
  const std::size_t rows = plan.pivots.size();
  const auto rules = in(plan.rules, expert.rules);
  const auto group_of = [&](const PlannedRule& rule) { return rule.lane * rows + plan.premises[rule.premise].row; };
  ends.assign(lanes * rows, 0);
  for (const PlannedRule& rule : rules) ++ends[group_of(rule)];
  std::uint32_t first = sizeOf(program.rules);
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), first);
  program.rules.resize(program.rules.size() + rules.size());
  for (const PlannedRule& rule : rules) {
    program.rules[ends[group_of(rule)]++] = {plan.premises[rule.premise].rest, rule.weight};
  }
  makeRoom(program.lanes, lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::uint32_t first_group = sizeOf(program.groups);
    for (std::size_t row = 0; row < rows; ++row) {
      const std::uint32_t end = ends[lane * rows + row];
      if (end == first) continue;
      RuleGroup group{plan.pivots[row], true, {first, end - first}, 0};
      const auto of_group = in(program.rules, group.rules);
      group.unit_weights =
          plan.unit_weights || std::ranges::all_of(of_group, [](const BatchRule& rule) { return rule.weight == 1; });
      // Where a rule asks for the pivot alone, no other of the group can be stronger.
      if (plan.bare_pivots && group.unit_weights &&
          std::ranges::find(of_group, kOneSlot, &BatchRule::rest) != of_group.end()) {
        group.cap = 1;
        group.rules.count = 0;
      }
      program.groups.push_back(group);
      first = end;
    }
    if (sizeOf(program.groups) == first_group) continue;
    program.lanes.push_back({static_cast<std::uint16_t>(lane), {first_group, sizeOf(program.groups) - first_group}});
  }
}

/// Beside the slots of a kernel's points this much stays in the second cache of common processors.
constexpr std::size_t kChunkBytes = std::size_t{192} << 10U;
/// Each chunk computes the slots of its section anew: a chunk is this many times as large as what that reads, and more.
constexpr std::size_t kTimesSlots = 16;

std::size_t bytesOf(const BatchProgram& program, const BatchExpert& expert) {
  std::size_t bytes = sizeof(BatchExpert) + expert.lanes.count * sizeof(BatchLane);
  for (const BatchLane& lane : in(program.lanes, expert.lanes)) {
    bytes += lane.groups.count * sizeof(RuleGroup);
    for (const RuleGroup& group : in(program.groups, lane.groups)) bytes += group.rules.count * sizeof(BatchRule);
  }
  return bytes;
}

std::size_t bytesOf(const BatchSection& section) {
  return section.terms.count * sizeof(BatchTerm) + section.antecedents.count * sizeof(Antecedent);
}

}  // namespace

void setChunks(BatchProgram& program) {
  program.chunks.clear();
  BatchChunk chunk;
  std::size_t bytes = 0;
  const auto close = [&] {
    program.chunks.push_back(chunk);
    bytes = 0;
  };
  for (std::uint32_t s = 0; s < sizeOf(program.sections); ++s) {
    const BatchSection& section = program.sections[s];
    bytes += bytesOf(section);
    for (std::uint32_t e = section.experts.first; e < section.experts.end(); ++e) {
      const std::size_t more = bytesOf(program, program.experts[e]);
      if (bytes + more > kChunkBytes + kTimesSlots * bytesOf(section) && e > chunk.experts.first) {
        close();
        chunk = {{s, 1}, {e, 0}};
      }
      bytes += more;
      chunk.sections.count = s + 1 - chunk.sections.first;
      chunk.experts.count = e + 1 - chunk.experts.first;
    }
  }
  close();
}

void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                BatchProgram& program) {
  BatchSection section;
  section.fixed = {sizeOf(program.fixed), 1};
  program.fixed.push_back({kOneSlot, 1});
  section.terms = {sizeOf(program.terms), sizeOf(plan.terms)};
  makeRoom(program.terms, plan.terms.size());
  for (const PlannedTerm& term : plan.terms) {
    program.terms.push_back({term.ramps, term.input, term.slot, term.input == plan.pivot_input});
  }

  section.antecedents = addAntecedents(plan, program.antecedents, program.antecedent_slots);

  section.experts.first = sizeOf(program.experts);
  Table<std::uint32_t> ends(plan.memory);
  for (const PlannedExpert& expert : plan.experts) {
    if (tables.experts[expert.expert].share == 0) continue;
    const std::uint32_t first_lane = sizeOf(program.lanes);
    addExpert(plan, expert, forms[expert.form].terms.size(), ends, program);
    program.experts.push_back(
        {tables.experts[expert.expert].share, expert.form, {first_lane, sizeOf(program.lanes) - first_lane}});
  }
  section.experts.count = sizeOf(program.experts) - section.experts.first;
  program.sections.push_back(section);
}

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
