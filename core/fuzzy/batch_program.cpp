// The program for many points: groups of rules with one pivot term and one output term.
#include <numeric>

#include "core/fuzzy/section_plan.h"

namespace tactus::fuzzy {
namespace {

/// Adds the rules of one expert, sorted by lane and row. `ends` is scratch: the end of each group.
void addExpert(const SectionPlan& plan, const PlannedExpert& expert, std::size_t lanes,
               std::vector<std::uint32_t>& ends, BatchProgram& program) {
  const std::size_t rows = plan.pivots.size();
  const auto rules = in(plan.rules, expert.rules);
  ends.assign(lanes * rows, 0);
  for (const PlannedRule& rule : rules) ++ends[rule.lane * rows + rule.row];
  std::uint32_t first = sizeOf(program.rules);
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), first);
  program.rules.resize(program.rules.size() + rules.size());
  for (const PlannedRule& rule : rules) {
    program.rules[ends[rule.lane * rows + rule.row]++] = {rule.rest, rule.weight};
  }
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::uint32_t first_group = sizeOf(program.groups);
    for (std::size_t row = 0; row < rows; ++row) {
      const std::uint32_t end = ends[lane * rows + row];
      if (end == first) continue;
      RuleGroup group{plan.pivots[row], true, {first, end - first}, 0};
      for (const BatchRule& rule : in(program.rules, group.rules)) {
        group.unit_weights = group.unit_weights && rule.weight == 1;
      }
      program.groups.push_back(group);
      first = end;
    }
    if (sizeOf(program.groups) == first_group) continue;
    program.lanes.push_back({static_cast<std::uint16_t>(lane), {first_group, sizeOf(program.groups) - first_group}});
  }
}

}  // namespace

void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                BatchProgram& program) {
  BatchSection section;
  section.fixed = {sizeOf(program.fixed), 1};
  program.fixed.push_back({kOneSlot, 1});
  section.terms = {sizeOf(program.terms), sizeOf(plan.terms)};
  for (const PlannedTerm& term : plan.terms) program.terms.push_back({term.ramps, term.input, term.slot, true});

  section.antecedents = addAntecedents(plan, program.antecedents, program.antecedent_slots);

  section.experts.first = sizeOf(program.experts);
  std::vector<std::uint32_t> ends;
  program.rules.reserve(program.rules.size() + plan.rules.size());
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

}  // namespace tactus::fuzzy
