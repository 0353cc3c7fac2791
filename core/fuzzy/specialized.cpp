// Folding of fixed inputs into a program for many points: one pass over its tables, from conditions to rules and back.
#include <algorithm>
#include <array>

#include "core/fuzzy/program.h"

namespace tactus::fuzzy {
namespace {

/// As the kernels compute it.
double membership(const Ramps& ramps, double x) {
  double result = 1;
  if (ramps.has_rise) result = std::min((x - ramps.a) * ramps.rise, result);
  if (ramps.has_fall) result = std::min((ramps.d - x) * ramps.fall, result);
  return std::max(result, 0.0);
}

class Folding {
 public:
  Folding(const BatchProgram& from, std::span<const std::optional<double>> fixed, std::pmr::memory_resource* memory)
      : from_(from), fixed_(fixed), out_{memory} {
    out_.sections.reserve(from.sections.size());
    out_.fixed.reserve(from.fixed.size() + from.terms.size());
    out_.terms.reserve(from.terms.size());
    out_.antecedents.reserve(from.antecedents.size());
    out_.antecedent_slots.reserve(from.antecedent_slots.size());
    out_.experts.reserve(from.experts.size());
    out_.lanes.reserve(from.lanes.size());
    out_.groups.reserve(from.groups.size());
    out_.rules.reserve(from.rules.size());
  }

  BatchProgram fold() {
    for (const BatchSection& section : from_.sections) addSection(section);
    setChunks(out_);
    return std::move(out_);
  }

 private:
  /// What is known of a slot.
  struct Slot {
    double value;  ///< at all points, where it is fixed
    bool is_fixed;
    bool is_rest, is_pivot;  ///< of a rule that is left
  };

  void addSection(const BatchSection& section) {
    const auto terms = in(from_.terms, section.terms);
    const auto antecedents = in(from_.antecedents, section.antecedents);
    for (const FixedSlot& slot : in(from_.fixed, section.fixed)) slots_[slot.slot] = {slot.value, true, false, false};
    for (const BatchTerm& term : terms) {
      const auto& x = fixed_[term.input];
      slots_[term.slot] = {x ? membership(term.ramps, *x) : 0, x.has_value(), false, false};
    }
    for (const Antecedent& antecedent : antecedents) slots_[antecedent.slot] = least(antecedent);

    BatchSection out;
    out.experts = {sizeOf(out_.experts), section.experts.count};
    for (const BatchExpert& expert : in(from_.experts, section.experts)) addExpert(expert);

    out.fixed.first = sizeOf(out_.fixed);
    out.antecedents.first = sizeOf(out_.antecedents);
    for (const Antecedent& antecedent : antecedents) addAntecedent(antecedent);
    out.antecedents.count = sizeOf(out_.antecedents) - out.antecedents.first;
    out.terms.first = sizeOf(out_.terms);
    for (BatchTerm term : terms) {
      const Slot& slot = slots_[term.slot];
      if (slot.is_fixed) {
        keepFixed(term.slot);
      } else if (slot.is_rest || slot.is_pivot) {
        term.cap = slot.is_pivot;
        out_.terms.push_back(term);
      }
    }
    for (const FixedSlot& slot : in(from_.fixed, section.fixed)) keepFixed(slot.slot);
    out.terms.count = sizeOf(out_.terms) - out.terms.first;
    out.fixed.count = sizeOf(out_.fixed) - out.fixed.first;
    out_.sections.push_back(out);
  }

  void keepFixed(std::uint16_t slot) {
    if (slots_[slot].is_rest || slots_[slot].is_pivot) out_.fixed.push_back({slot, slots_[slot].value});
  }

  /// The least of what is fixed; fixed altogether where nothing else can matter.
  Slot least(const Antecedent& antecedent) const {
    Slot out{antecedent.cap, true, false, false};
    for (const std::uint16_t of : in(from_.antecedent_slots, antecedent.of)) {
      if (slots_[of].is_fixed) {
        out.value = std::min(out.value, slots_[of].value);
      } else {
        out.is_fixed = false;
      }
    }
    out.is_fixed = out.is_fixed || out.value == 0;
    return out;
  }

  void addAntecedent(const Antecedent& antecedent) {
    const Slot& slot = slots_[antecedent.slot];
    if (slot.is_fixed) return keepFixed(antecedent.slot);
    if (!slot.is_rest) return;
    const std::uint32_t first = sizeOf(out_.antecedent_slots);
    for (const std::uint16_t of : in(from_.antecedent_slots, antecedent.of)) {
      if (slots_[of].is_fixed) continue;
      slots_[of].is_rest = true;
      out_.antecedent_slots.push_back(of);
    }
    out_.antecedents.push_back({antecedent.slot, {first, sizeOf(out_.antecedent_slots) - first}, slot.value});
  }

  void addExpert(const BatchExpert& expert) {
    const std::uint32_t first_lane = sizeOf(out_.lanes);
    for (const BatchLane& lane : in(from_.lanes, expert.lanes)) {
      const std::uint32_t first_group = sizeOf(out_.groups);
      for (const RuleGroup& group : in(from_.groups, lane.groups)) addGroup(group);
      const std::uint32_t groups = sizeOf(out_.groups) - first_group;
      if (groups > 0) out_.lanes.push_back({lane.lane, {first_group, groups}});
    }
    out_.experts.push_back({expert.share, expert.form, {first_lane, sizeOf(out_.lanes) - first_lane}});
  }

  void addGroup(RuleGroup group) {
    Slot& pivot = slots_[group.pivot];
    if (pivot.is_fixed && pivot.value == 0) return;
    const std::uint32_t first = sizeOf(out_.rules);
    for (const BatchRule& rule : in(from_.rules, group.rules)) {
      const Slot& rest = slots_[rule.rest];
      if (!rest.is_fixed) {
        out_.rules.push_back(rule);
      } else if (group.unit_weights) {
        group.cap = std::max(group.cap, rest.value);
      } else if (rest.value > 0) {
        out_.rules.push_back(rule);
      }
    }
    // A rest as large as the pivot can ever be leaves no room for others.
    if (group.cap >= (pivot.is_fixed ? pivot.value : 1)) out_.rules.resize(first);
    group.rules = {first, sizeOf(out_.rules) - first};
    if (group.rules.count == 0 && group.cap == 0) return;
    for (const BatchRule& rule : in(out_.rules, group.rules)) slots_[rule.rest].is_rest = true;
    pivot.is_pivot = true;
    out_.groups.push_back(group);
  }

  const BatchProgram& from_;
  std::span<const std::optional<double>> fixed_;
  BatchProgram out_;
  std::array<Slot, kMostSlots> slots_;  ///< of the current section; those that it has
};

}  // namespace

BatchProgram specialized(const BatchProgram& program, std::span<const std::optional<double>> fixed,
                         std::pmr::memory_resource* memory) {
  return Folding(program, fixed, memory).fold();
}

}  // namespace tactus::fuzzy
