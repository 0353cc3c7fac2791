// Builds the fast form: names and rules become slots, rows and polynomials.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Vertices nearer to 0 than this, but not 0, and ramps narrower than this are left to the general path.
constexpr double kTiny = 1e-280;
// With ramps no wider and weights no smaller than these the smallest strength of an ordinary input is still positive.
constexpr double kWidestRamp = 1e10;
constexpr double kSmallestWeight = 1e-10;

/// 1 / width, rounded so that width * the result is at least 1.
double steepness(double width) {
  double slope = 1 / width;
  while (width * slope < 1) slope = std::nextafter(slope, kInfinity);
  return slope;
}

class Builder {
 public:
  Builder(const ModelTables& source, std::span<const std::optional<double>> fixed) : source_(source), fixed_(fixed) {
    program_.clip = source.implication == Implication::kClip;
    program_.negligible = 1e-180 * (source.output_max - source.output_min);
    constants_ = {{0.0, kZeroSlot}, {1.0, kOneSlot}};
    program_.constants.resize(1);
    program_.constants[0].value[kOneSlot] = 1;
    program_.output_min = source.output_min;
    std::copy(source.input_min.begin(), source.input_min.end(), program_.input_min.begin());
    std::copy(source.input_max.begin(), source.input_max.end(), program_.input_max.begin());
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      if (!fixed[i]) program_.varying.push_back(static_cast<std::uint16_t>(i));
    }
    for (const auto& table : source.experts) all_weights_ += table.weight;
  }

  Program build() {
    for (const auto& table : source_.experts) {
      if (!addExpert(table)) return {};
    }
    program_.usable = true;
    program_.kernels = &activeKernels();
    program_.constant_count = constants_.size();
    return std::move(program_);
  }

 private:
  static constexpr std::uint16_t kZeroSlot = 0;
  static constexpr std::uint16_t kOneSlot = 1;

  std::optional<std::uint16_t> newSlots(std::size_t count) {
    if (next_slot_ + count > kMostSlots) return std::nullopt;
    return static_cast<std::uint16_t>(std::exchange(next_slot_, next_slot_ + count));
  }

  std::optional<std::uint16_t> constantSlot(double value) {
    const auto known = constants_.find(value);
    if (known != constants_.end()) return known->second;
    if (constants_.size() == kMostConstants) return std::nullopt;
    const auto slot = static_cast<std::uint16_t>(constants_.size());
    if (slot % kLanes == 0) program_.constants.emplace_back();
    program_.constants.back().value[slot % kLanes] = value;
    constants_.emplace(value, slot);
    return slot;
  }

  /// The slot of a term of a varying input; nothing where its shape needs the general path.
  std::optional<std::uint16_t> termSlot(std::size_t input, std::uint32_t bank, std::size_t term) {
    const auto key = std::pair(bank, term);
    const auto known = term_slots_.find(key);
    if (known != term_slots_.end()) return known->second;

    const auto& f = source_.banks[bank][term];
    const double lo = source_.input_min[input];
    const double hi = source_.input_max[input];
    FastTerm fast;
    fast.input = static_cast<std::uint16_t>(input);
    if (f.gaussian || !setRamp(f.a, f.b, f.b <= lo, -kInfinity, fast.has_rise, fast.a, fast.rise) ||
        !setRamp(f.d, f.c, f.c >= hi, kInfinity, fast.has_fall, fast.d, fast.fall)) {
      return std::nullopt;
    }
    const auto base = bankSlots(input, bank);
    if (!base) return std::nullopt;
    fast.slot = static_cast<std::uint16_t>(*base + term);
    program_.terms.push_back(fast);
    TermBlock& block = program_.blocks[block_of_bank_[bank] + term / kLanes];
    const std::size_t lane = term % kLanes;
    block.a.value[lane] = fast.has_rise ? fast.a : -kInfinity;
    block.rise.value[lane] = fast.has_rise ? fast.rise : 1;
    block.d.value[lane] = fast.has_fall ? fast.d : kInfinity;
    block.fall.value[lane] = fast.has_fall ? fast.fall : 1;
    term_slots_.emplace(key, fast.slot);
    return fast.slot;
  }

  /// The first slot of a bank: its terms stand in a row, in blocks of eight.
  std::optional<std::uint16_t> bankSlots(std::size_t input, std::uint32_t bank) {
    const auto known = block_of_bank_.find(bank);
    if (known != block_of_bank_.end()) return program_.blocks[known->second].slot;
    const std::size_t blocks = (source_.banks[bank].size() + kLanes - 1) / kLanes;
    const auto base = newSlots(blocks * kLanes);
    if (!base) return std::nullopt;
    block_of_bank_.emplace(bank, program_.blocks.size());
    for (std::size_t b = 0; b < blocks; ++b) {
      TermBlock block;
      block.input = static_cast<std::uint16_t>(input);
      block.slot = static_cast<std::uint16_t>(*base + b * kLanes);
      block.count = static_cast<std::uint16_t>(std::min(kLanes, source_.banks[bank].size() - b * kLanes));
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        block.a.value[lane] = kInfinity;
        block.rise.value[lane] = block.fall.value[lane] = 1;
        block.d.value[lane] = kInfinity;
      }
      program_.blocks.push_back(block);
    }
    return base;
  }

  /// One ramp from `foot` (membership 0) to `shoulder` (1); `outward` is the direction from shoulder to foot.
  bool setRamp(double foot, double shoulder, bool absent, double outward, bool& has, double& position, double& slope) {
    has = !absent;
    if (absent) return true;
    const double width = std::abs(shoulder - foot);
    const auto is_tiny = [](double x) { return x != 0 && std::abs(x) < kTiny; };
    if (width == 0) {
      // A vertical edge: a ramp one ulp wide that ends at the edge.
      if (std::abs(foot) < kTiny) return false;
      position = std::nextafter(foot, outward);
      slope = std::numeric_limits<double>::max();
      return true;
    }
    if (width < kTiny || is_tiny(foot) || is_tiny(shoulder)) return false;
    if (width > kWidestRamp) program_.zero_is_certain = false;
    position = foot;
    slope = steepness(width);
    return true;
  }

  /// The slot of min(slots, cap).
  std::optional<std::uint16_t> restSlot(std::vector<std::uint16_t> slots, double cap) {
    if (cap < 1 || slots.empty()) {
      const auto slot = constantSlot(cap);
      if (!slot) return std::nullopt;
      if (slots.empty()) return slot;
      slots.push_back(*slot);
    }
    if (slots.size() == 1) return slots[0];
    std::sort(slots.begin(), slots.end());
    const auto known = antecedents_.find(slots);
    if (known != antecedents_.end()) return known->second;
    const auto slot = newSlots(1);
    if (!slot) return std::nullopt;
    program_.antecedents.push_back({*slot, slots});
    antecedents_.emplace(std::move(slots), *slot);
    return slot;
  }

  /// A rule with the fixed inputs folded into `cap`.
  struct FoldedRule {
    const RuleTable::Rule* rule;
    double cap = 1;
    std::vector<RuleTable::Condition> conditions;
  };

  std::vector<FoldedRule> fold(const RuleTable& table) const {
    std::vector<FoldedRule> folded;
    for (const auto& rule : table.rules) {
      FoldedRule out{&rule, 1, {}};
      for (std::uint32_t c = rule.first_condition; c < rule.first_condition + rule.condition_count; ++c) {
        const auto& condition = table.conditions[c];
        if (!fixed_[condition.input]) {
          out.conditions.push_back(condition);
          continue;
        }
        const double x = std::clamp(*fixed_[condition.input], source_.input_min[condition.input],
                                    source_.input_max[condition.input]);
        out.cap = std::min(out.cap, source_.banks[table.input_bank[condition.input]][condition.term](x));
      }
      if (out.cap > 0) folded.push_back(std::move(out));
    }
    return folded;
  }

  /// The varying input that most rules mention.
  std::uint16_t pivotOf(const std::vector<FoldedRule>& rules) const {
    std::vector<std::size_t> mentions(source_.input_min.size());
    for (const auto& rule : rules) {
      for (const auto& condition : rule.conditions) ++mentions[condition.input];
    }
    return static_cast<std::uint16_t>(std::max_element(mentions.begin(), mentions.end()) - mentions.begin());
  }

  bool addExpert(const RuleTable& table) {
    std::vector<std::uint16_t> lane_of;
    auto form = closedForm(source_.banks[table.output_bank], source_.output_min, source_.output_max,
                           source_.implication, lane_of);
    if (!form) return false;
    FastExpert expert;
    expert.share = static_cast<double>(table.weight / all_weights_);
    expert.form = program_.forms.size();
    program_.forms.push_back(*form);

    const auto rules = fold(table);
    expert.pivot_input = pivotOf(rules);
    // Row by pivot slot, in it rest slot, in it weight by output lane; equal rules keep the largest weight.
    std::map<std::uint16_t, std::map<std::uint16_t, Lanes>> rows;
    std::map<std::uint16_t, MembershipFunction> pivots;
    for (const auto& folded : rules) {
      std::uint16_t pivot = kOneSlot;
      std::vector<std::uint16_t> others;
      for (const auto& condition : folded.conditions) {
        const std::uint32_t bank = table.input_bank[condition.input];
        const auto slot = termSlot(condition.input, bank, condition.term);
        if (!slot) return false;
        if (condition.input == expert.pivot_input) {
          pivot = *slot;
          pivots.emplace(pivot, source_.banks[bank][condition.term]);
        } else {
          others.push_back(*slot);
        }
      }
      const auto rest = restSlot(std::move(others), folded.cap);
      if (!rest) return false;
      if (folded.rule->weight < kSmallestWeight || folded.cap < kSmallestWeight) program_.zero_is_certain = false;
      double& weight = rows[pivot][*rest].value[lane_of[folded.rule->then]];
      weight = std::max(weight, folded.rule->weight);
    }
    fillRows(rows, expert);
    fillSegments(pivots, expert);
    fillGrid(expert);
    fillGroups(rows, expert);
    program_.experts.push_back(std::move(expert));
    return true;
  }

  static void fillRows(const std::map<std::uint16_t, std::map<std::uint16_t, Lanes>>& rows, FastExpert& expert) {
    for (const auto& [pivot, rests] : rows) {
      expert.rows.push_back(
          {pivot, static_cast<std::uint32_t>(expert.rests.size()), static_cast<std::uint32_t>(rests.size())});
      for (const auto& [rest, weights] : rests) {
        expert.rests.push_back(rest);
        expert.weights.push_back(weights);
      }
    }
    expert.rows.push_back({kZeroSlot, 0, 0});  // stands in where a segment has fewer rows than others
  }

  /// For each stretch of the pivot input between ends of supports: the rows whose pivot is positive somewhere in it.
  static void fillSegments(const std::map<std::uint16_t, MembershipFunction>& pivots, FastExpert& expert) {
    for (const auto& [slot, f] : pivots) {
      for (const double end : {f.a, f.d}) expert.breakpoints.push_back(end);
    }
    std::sort(expert.breakpoints.begin(), expert.breakpoints.end());
    expert.breakpoints.erase(std::unique(expert.breakpoints.begin(), expert.breakpoints.end()),
                             expert.breakpoints.end());

    const auto null_row = static_cast<std::uint32_t>(expert.rows.size() - 1);
    std::vector<std::vector<std::uint32_t>> active(expert.breakpoints.size() + 1);
    expert.rows_per_segment = 1;
    for (std::size_t s = 0; s < active.size(); ++s) {
      const double left = s == 0 ? -kInfinity : expert.breakpoints[s - 1];
      const double right = s + 1 == active.size() ? kInfinity : expert.breakpoints[s];
      for (std::uint32_t r = 0; r < null_row; ++r) {
        const auto pivot = pivots.find(expert.rows[r].pivot);
        const bool always = pivot == pivots.end();
        const auto reaches = [&](const MembershipFunction& f) {
          return f.a < right && (f.d > left || (f.d == left && f.c == f.d));
        };
        if (always || reaches(pivot->second)) active[s].push_back(r);
      }
      expert.rows_per_segment = std::max(expert.rows_per_segment, active[s].size());
    }
    for (auto& rows : active) {
      rows.resize(expert.rows_per_segment, null_row);
      expert.segment_rows.insert(expert.segment_rows.end(), rows.begin(), rows.end());
    }
  }

  void fillGrid(FastExpert& expert) const {
    const double lo = source_.input_min[expert.pivot_input];
    expert.grid_start = lo;
    expert.cells_per_unit = static_cast<double>(kGridCells) / (source_.input_max[expert.pivot_input] - lo);
    expert.first_segment.assign(kGridCells + 1, 0);
    // A breakpoint in an earlier cell is passed for sure, because the cell of a point never falls as the point rises.
    for (const double breakpoint : expert.breakpoints) {
      const double cell = (breakpoint - lo) * expert.cells_per_unit;
      for (std::size_t i = 0; i <= kGridCells; ++i) {
        if (cell < static_cast<double>(i)) ++expert.first_segment[i];
      }
    }
    expert.breakpoints.push_back(kInfinity);
  }

  static void fillGroups(const std::map<std::uint16_t, std::map<std::uint16_t, Lanes>>& rows, FastExpert& expert) {
    for (const auto& [pivot, rests] : rows) {
      for (std::uint16_t lane = 0; lane < kLanes; ++lane) {
        RuleGroup group{pivot, lane, static_cast<std::uint32_t>(expert.batch_rules.size()), 0, true};
        for (const auto& [rest, weights] : rests) {
          const double weight = weights.value[lane];
          if (weight == 0) continue;
          expert.batch_rules.push_back({rest, weight});
          group.unit_weights = group.unit_weights && weight == 1;
          ++group.count;
        }
        if (group.count > 0) expert.groups.push_back(group);
      }
    }
  }

  const ModelTables& source_;
  std::span<const std::optional<double>> fixed_;
  Program program_;
  std::size_t next_slot_ = kMostConstants;
  long double all_weights_ = 0;
  std::map<std::uint32_t, std::size_t> block_of_bank_;
  std::map<double, std::uint16_t> constants_;
  std::map<std::pair<std::uint32_t, std::size_t>, std::uint16_t> term_slots_;
  std::map<std::vector<std::uint16_t>, std::uint16_t> antecedents_;
};

}  // namespace

Program makeProgram(const ModelTables& source, std::span<const std::optional<double>> fixed) {
  return Builder(source, fixed).build();
}

}  // namespace tactus::fuzzy
