// The program for one point: rows of rests and weights, and the segments of the pivot input.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/fuzzy/section_plan.h"

namespace tactus::fuzzy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A block of eight slots for each eight terms of an input that rules mention.
void addBlocks(const SectionPlan& plan, PointProgram& program) {
  std::uint16_t first = 0;  // slot of the current block
  for (const PlannedTerm& term : plan.terms) {
    const std::uint16_t lane = term.slot % kLanes;
    if (term.slot - lane != first) {
      first = static_cast<std::uint16_t>(term.slot - lane);
      TermBlock& block = program.blocks.emplace_back();
      block.input = term.input;
      block.slot = first;
      std::fill_n(block.a.value, kLanes, kInfinity);
      std::fill_n(block.d.value, kLanes, kInfinity);
      std::fill_n(block.rise.value, kLanes, 1);
      std::fill_n(block.fall.value, kLanes, 1);
    }
    TermBlock& block = program.blocks.back();
    block.count = static_cast<std::uint16_t>(lane + 1);
    block.a.value[lane] = term.ramps.has_rise ? term.ramps.a : -kInfinity;
    block.rise.value[lane] = term.ramps.has_rise ? term.ramps.rise : 1;
    block.d.value[lane] = term.ramps.has_fall ? term.ramps.d : kInfinity;
    block.fall.value[lane] = term.ramps.has_fall ? term.ramps.fall : 1;
  }
}

/// Puts the experts of a section into teams and lays out their rows.
class Teams {
 public:
  Teams(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms, PointProgram& program)
      : plan_(plan), tables_(tables), forms_(forms), program_(program), next_in_row_(plan.pivots.size()) {}

  void add() {
    std::vector<PlannedExpert> experts = plan_.experts;
    std::stable_sort(experts.begin(), experts.end(),
                     [](const PlannedExpert& e, const PlannedExpert& f) { return e.form < f.form; });
    for (std::size_t first = 0; first < experts.size();) {
      std::size_t end = first + 1;
      while (end < experts.size() && end - first < kTeam && experts[end].form == experts[first].form) ++end;
      addTeam(std::span(experts).subspan(first, end - first));
      first = end;
    }
  }

 private:
  struct RuleOfTeam {
    const PlannedRule* rule = nullptr;
    std::uint32_t member = 0;
  };

  void addTeam(std::span<const PlannedExpert> members) {
    const ClosedForm& form = forms_[members.front().form];
    Team team;
    if (members.size() == 1 && form.fits_side_by_side) {
      team.layout = Team::Layout::kAlone;
    } else if (form.terms.size() <= kLanes) {
      team.layout = Team::Layout::kDense;
    }
    team.experts = static_cast<std::uint16_t>(members.size());
    team.lanes = static_cast<std::uint16_t>(form.terms.size());
    team.form = members.front().form;
    team.first_row = sizeOf(program_.rows);
    team.first_rest = sizeOf(program_.rests);
    team.first_weight = sizeOf(program_.weights);
    for (std::size_t m = 0; m < members.size(); ++m) {
      program_.expert_at.push_back(members[m].expert);
      team.shares.value[m] = tables_.experts[members[m].expert].share;
    }
    program_.teams.push_back(team);
    sortByRow(members);
    const std::size_t lanes = team.layout == Team::Layout::kSparse ? form.terms.size() : 1;
    if (place_of_.size() < plan_.slot_count * lanes) place_of_.resize(plan_.slot_count * lanes);
    std::size_t at = 0;
    for (std::size_t row = 0; row < next_in_row_.size(); ++row) {
      const std::uint32_t first = sizeOf(program_.rests);
      for (; at < next_in_row_[row]; ++at) addRule(team, sorted_[at], lanes, first);
      program_.rows.push_back({first, sizeOf(program_.rests) - first});
    }
  }

  /// How many Weights each rest has.
  static std::size_t partsOf(const Team& team) {
    switch (team.layout) {
      case Team::Layout::kAlone:
        return kLanes / kTeam;
      case Team::Layout::kDense:
        return team.lanes;
      case Team::Layout::kSparse:
        return 1;
    }
    return 1;
  }

  /// Afterwards next_in_row_ holds the end of each row.
  void sortByRow(std::span<const PlannedExpert> members) {
    std::fill(next_in_row_.begin(), next_in_row_.end(), 0);
    std::uint32_t count = 0;
    for (const PlannedExpert& member : members) {
      for (const PlannedRule& rule : in(plan_.rules, member.rules)) ++next_in_row_[rule.row];
      count += member.rules.count;
    }
    std::exclusive_scan(next_in_row_.begin(), next_in_row_.end(), next_in_row_.begin(), 0U);
    sorted_.resize(count);
    for (std::uint32_t m = 0; m < members.size(); ++m) {
      for (const PlannedRule& rule : in(plan_.rules, members[m].rules)) sorted_[next_in_row_[rule.row]++] = {&rule, m};
    }
  }

  /// Equal rests of a row share an entry; `lanes` > 1: those with equal lanes.
  void addRule(const Team& team, const RuleOfTeam& of, std::size_t lanes, std::uint32_t first_in_row) {
    const PlannedRule& rule = *of.rule;
    std::uint32_t& place = place_of_[rule.rest * lanes + (lanes == 1 ? 0 : rule.lane)];
    const std::size_t parts = partsOf(team);
    if (place <= first_in_row) {  // an entry of an earlier row or none; a place is one more than an index
      program_.rests.push_back({rule.rest, rule.lane});
      program_.weights.resize(program_.weights.size() + parts);
      place = sizeOf(program_.rests);
    }
    Weights* const weights = &program_.weights[team.first_weight + (place - 1 - team.first_rest) * parts];
    if (team.layout == Team::Layout::kAlone) {
      weights[rule.lane / kTeam].value[rule.lane % kTeam] = rule.weight;
      return;
    }
    auto& of_experts = weights[team.layout == Team::Layout::kDense ? rule.lane : 0].value;
    of_experts[of.member] = rule.weight;
    if (of.member > 0) return;
    for (std::size_t empty = team.experts; empty < kTeam; ++empty) of_experts[empty] = rule.weight;
  }

  const SectionPlan& plan_;
  const ModelTables& tables_;
  std::span<const ClosedForm> forms_;
  PointProgram& program_;
  std::vector<std::uint32_t> next_in_row_;  ///< in sorted_
  std::vector<RuleOfTeam> sorted_;          ///< the rules of a team, row by row
  std::vector<std::uint32_t> place_of_;     ///< of each rest and lane in the current row
};

/// For each stretch of the pivot input between ends of supports: the rows whose pivot is positive somewhere in it.
void addSegments(const SectionPlan& plan, const ModelTables& tables, PointSection& section, PointProgram& program) {
  struct Reach {
    std::uint16_t row;
    const MembershipFunction* pivot;
  };
  const auto& bank = tables.banks[tables.experts[plan.experts.front().expert].input_bank[plan.pivot_input]];
  std::vector<bool> has_rules(plan.pivots.size());
  for (const PlannedRule& rule : plan.rules) has_rules[rule.row] = true;
  std::vector<Reach> rows;
  std::vector<double> ends;
  rows.reserve(bank.size());
  ends.reserve(2 * bank.size() + 1);
  for (std::uint16_t row = 1; row <= bank.size(); ++row) {
    if (!has_rules[row]) continue;
    const MembershipFunction& f = bank[row - 1U];
    rows.push_back({row, &f});
    ends.push_back(f.a);
    ends.push_back(f.d);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  ends.push_back(kInfinity);

  // Two passes: how many rows a segment has at most, then the rows.
  const auto null_row = static_cast<std::uint16_t>(plan.pivots.size() - 1);
  const auto rows_between = [&](double left, double right, auto&& take) {
    if (has_rules[0]) take(std::uint16_t{0});
    for (const auto& [row, f] : rows) {
      if (f->a < right && (f->d > left || (f->d == left && f->c == f->d))) take(row);
    }
  };
  std::uint32_t most = 1;
  for (std::size_t s = 0; s < ends.size(); ++s) {
    std::uint32_t count = 0;
    rows_between(s == 0 ? -kInfinity : ends[s - 1], ends[s], [&count](std::uint16_t) { ++count; });
    most = std::max(most, count);
  }
  section.rows_per_segment = most;
  section.first_segment_row = sizeOf(program.segment_rows);
  for (std::size_t s = 0; s < ends.size(); ++s) {
    rows_between(s == 0 ? -kInfinity : ends[s - 1], ends[s],
                 [&program](std::uint16_t row) { program.segment_rows.push_back(row); });
    program.segment_rows.resize(section.first_segment_row + (s + 1) * most, null_row);
  }
  section.first_breakpoint = sizeOf(program.breakpoints);
  program.breakpoints.insert(program.breakpoints.end(), ends.begin(), ends.end());
}

/// The grid over the pivot input: for each cell the number of breakpoints in earlier ones. Those are passed for sure,
/// because the cell of a point never falls as the point rises.
void addGrid(double lo, double hi, PointSection& section, PointProgram& program) {
  section.grid_start = lo;
  section.cells_per_unit = static_cast<double>(kGridCells) / (hi - lo);
  section.first_cell = sizeOf(program.first_segment);
  program.first_segment.resize(section.first_cell + kGridCells + 1);
  const auto cells = program.first_segment.begin() + section.first_cell;
  std::size_t filled = 0;
  std::uint16_t passed = 0;
  for (std::size_t b = section.first_breakpoint; b < program.breakpoints.size(); ++b, ++passed) {
    const double cell = (program.breakpoints[b] - lo) * section.cells_per_unit;
    const auto end = static_cast<std::size_t>(std::clamp(std::floor(cell) + 1, 0.0, kGridCells + 1.0));
    for (; filled < end; ++filled) cells[static_cast<std::ptrdiff_t>(filled)] = passed;
  }
}

}  // namespace

void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                PointProgram& program) {
  PointSection section;
  section.pivot_input = plan.pivot_input;
  section.blocks.first = sizeOf(program.blocks);
  addBlocks(plan, program);
  section.blocks.count = sizeOf(program.blocks) - section.blocks.first;

  section.antecedents = addAntecedents(plan, program.antecedents, program.antecedent_slots);
  section.first_pivot = sizeOf(program.pivots);
  program.pivots.insert(program.pivots.end(), plan.pivots.begin(), plan.pivots.end());

  section.teams.first = sizeOf(program.teams);
  Teams(plan, tables, forms, program).add();
  section.teams.count = sizeOf(program.teams) - section.teams.first;

  addSegments(plan, tables, section, program);
  addGrid(tables.input_min[plan.pivot_input], tables.input_max[plan.pivot_input], section, program);
  program.sections.push_back(section);
}

}  // namespace tactus::fuzzy
