// The program for one point: rows of rests and weights, and the segments of the pivot input.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/fuzzy/section_plan.h"

namespace tactus::fuzzy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A block of eight slots for each eight terms of an input that rules mention.
void addBlocks(const SectionPlan& plan, PointProgram& program) {
  makeRoom(program.blocks, plan.block_count);
  std::uint16_t first = 0;  // slot of the current block
  for (const PlannedTerm& term : plan.terms) {
    const std::uint16_t lane = term.slot % kLanes;
    if (term.slot - lane != first) {
      first = static_cast<std::uint16_t>(term.slot - lane);
      TermBlock& block = program.blocks.emplace_back();
      block.input = term.input;
      block.slot = first;
    }
    TermBlock& block = program.blocks.back();
    block.count = static_cast<std::uint16_t>(lane + 1);
    block.a.value[lane] = term.ramps.has_rise ? term.ramps.a : -kInfinity;
    block.rise.value[lane] = term.ramps.has_rise ? term.ramps.rise : 1;
    block.d.value[lane] = term.ramps.has_fall ? term.ramps.d : kInfinity;
    block.fall.value[lane] = term.ramps.has_fall ? term.ramps.fall : 1;
    block.height.value[lane] = 1;
  }
}

/// Puts the experts of a section into teams and lays out their rows.
class Teams {
 public:
  Teams(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms, PointProgram& program)
      : plan_(plan), tables_(tables), forms_(forms), program_(program) {}

  void add() {
    Table<PlannedExpert> experts(plan_.experts, plan_.memory);
    std::sort(experts.begin(), experts.end(), [](const PlannedExpert& e, const PlannedExpert& f) {
      return std::tie(e.form, e.expert) < std::tie(f.form, f.expert);
    });
    for (std::size_t first = 0; first < experts.size();) {
      std::size_t end = first + 1;
      while (end < experts.size() && end - first < kTeam && experts[end].form == experts[first].form) ++end;
      addTeam(std::span(experts).subspan(first, end - first));
      first = end;
    }
  }

 private:
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
    findLanes(members);
    addRows(team.layout == Team::Layout::kSparse);
    const std::size_t rests = program_.rests.size() - team.first_rest;
    program_.weights.resize(team.first_weight + rests * partsOf(team));
    for (std::size_t m = 0; m < members.size(); ++m) addWeights(team, m, in(plan_.rules, members[m].rules));
  }

  /// How many Weights each rest has.
  static std::size_t partsOf(const Team& team) {
    switch (team.layout) {
      case Team::Layout::kAlone: return kLanes / kTeam;
      case Team::Layout::kDense: return team.lanes;
      case Team::Layout::kSparse: return 1;
    }
    return 1;
  }

  void findLanes(std::span<const PlannedExpert> members) {
    std::fill(lanes_.begin(), lanes_.end(), 0);
    for (const PlannedExpert& member : members) {
      for (const PlannedRule& rule : in(plan_.rules, member.rules))
        lanes_[rule.premise] |= std::uint64_t{1} << rule.lane;
    }
  }

  /// The rests of the premises that have rules; `each_lane`: one for each output term that follows.
  void addRows(bool each_lane) {
    std::uint32_t premise = 0;
    makeRoom(program_.rows, plan_.row_end.size());
    makeRoom(program_.rests, plan_.premises.size());
    for (const std::uint32_t end : plan_.row_end) {
      const std::uint32_t first = sizeOf(program_.rests);
      for (; premise < end; ++premise) {
        first_rest_[premise] = sizeOf(program_.rests);
        for (std::uint64_t lanes = lanes_[premise]; lanes != 0; lanes = each_lane ? lanes & (lanes - 1) : 0) {
          program_.rests.push_back({plan_.premises[premise].rest, static_cast<std::uint16_t>(std::countr_zero(lanes))});
        }
      }
      program_.rows.push_back({first, sizeOf(program_.rests) - first});
    }
  }

  void addWeights(const Team& team, std::size_t member, std::span<const PlannedRule> rules) {
    const std::size_t parts = partsOf(team);
    Weights* const weights = program_.weights.data() + team.first_weight;
    // The first expert takes the places that are left, too.
    const std::size_t copies = member == 0 ? kTeam - team.experts : 0;
    for (const PlannedRule& rule : rules) {
      const std::size_t rest = first_rest_[rule.premise] - team.first_rest;
      if (team.layout == Team::Layout::kAlone) {
        weights[rest * parts + rule.lane / kTeam].value[rule.lane % kTeam] = rule.weight;
        continue;
      }
      auto& of_experts =
          weights[team.layout == Team::Layout::kDense ? rest * parts + rule.lane
                                                      : rest + lanesBelow(rule.lane, lanes_[rule.premise])]
              .value;
      of_experts[member] = rule.weight;
      for (std::size_t c = 0; c < copies; ++c) of_experts[team.experts + c] = rule.weight;
    }
  }

  static std::size_t lanesBelow(std::uint16_t lane, std::uint64_t lanes) {
    return static_cast<std::size_t>(std::popcount(lanes & ((std::uint64_t{1} << lane) - 1)));
  }

  const SectionPlan& plan_;
  const ModelTables& tables_;
  std::span<const ClosedForm> forms_;
  PointProgram& program_;
  /// Of each premise: bits of the output terms that follow for the team.
  Table<std::uint64_t> lanes_{plan_.premises.size(), plan_.memory};
  Table<std::uint32_t> first_rest_{plan_.premises.size(), plan_.memory};  ///< of each premise
};

/// For each stretch of the pivot input between ends of supports: the rows whose pivot is positive somewhere in it.
void addSegments(const SectionPlan& plan, const ModelTables& tables, PointSection& section, PointProgram& program) {
  struct Reach {
    std::uint16_t row;
    const MembershipFunction* pivot;
  };
  const auto bank = tables.bank(tables.experts[plan.experts.front().expert].input_bank[plan.pivot_input]);
  const auto has_rules = [&plan](std::size_t row) {
    return plan.row_end[row] > (row == 0 ? 0 : plan.row_end[row - 1]);
  };
  Table<Reach> rows(plan.memory);
  Table<double> ends(plan.memory);
  rows.reserve(bank.size());
  ends.reserve(2 * bank.size() + 1);
  for (std::uint16_t row = 1; row <= bank.size(); ++row) {
    if (!has_rules(row)) continue;
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
    if (has_rules(0)) take(std::uint16_t{0});
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
  makeRoom(program.segment_rows, ends.size() * most);
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
  section.first_cell = sizeOf(program.cells);
  program.cells.resize(section.first_cell + kGridCells + 1);
  const auto cells = program.cells.begin() + section.first_cell;
  std::size_t filled = 0;
  std::uint16_t passed = 0;
  for (std::size_t b = section.first_breakpoint; b < program.breakpoints.size(); ++b, ++passed) {
    const double cell = (program.breakpoints[b] - lo) * section.cells_per_unit;
    const auto end = static_cast<std::size_t>(std::clamp(std::floor(cell) + 1, 0.0, kGridCells + 1.0));
    if (end <= filled) continue;
    std::fill_n(cells + static_cast<std::ptrdiff_t>(filled), end - filled,
                GridCell{passed, static_cast<std::uint16_t>(passed * section.rows_per_segment)});
    filled = end;
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
