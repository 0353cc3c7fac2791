// Many points at once, one lane per point. Part of kernel_source.h. Words: program.h.

/// Four registers: enough independent work to hide the latency of the instructions.
constexpr int kPoints = 4 * kWidth;
using VB = Pack<kPoints>;

/// Memberships of many points in one term, cut at 1 if the term asks for it. Negative values stay, because the
/// strengths are cut at 0 later.
TACTUS_INLINE VB membership(const BatchTerm& term, const VB& x) noexcept {
  const Ramps& ramps = term.ramps;
  if (!ramps.has_fall && !ramps.has_rise) return spread<kPoints>(1);
  VB result;
  if (!ramps.has_fall) {
    result = (x - ramps.a) * ramps.rise;
  } else {
    result = (ramps.d - x) * ramps.fall;
    if (ramps.has_rise) result = smaller((x - ramps.a) * ramps.rise, result);
  }
  return term.cap ? smaller(result, spread<kPoints>(1)) : result;
}

TACTUS_INLINE VB strengthOf(const RuleGroup& group, const BatchRule* rule, const VB* slots) noexcept {
  const BatchRule* const end = rule + group.rules.count;
  const VB& pivot = slots[group.pivot];
  if (!group.unit_weights) {
    VB best = spread<kPoints>(0);
    for (; rule != end; ++rule) best = larger(smaller(slots[rule->rest], pivot) * rule->weight, best);
    return best;
  }
  if (rule == end) return smaller(pivot, spread<kPoints>(group.cap));
  VB best = slots[rule->rest];
  while (++rule != end) best = larger(slots[rule->rest], best);
  if (group.cap > 0) best = larger(best, spread<kPoints>(group.cap));
  return smaller(best, pivot);
}

/// Adds the centroid of one expert to the force. Marks the points with a negligible area in `look_again`.
TACTUS_INLINE void addExpert(const Program& common, const BatchProgram& program, const BatchExpert& expert,
                             const VB* slots, VB& force, Bits* look_again) noexcept {
  const ClosedForm& form = common.forms[expert.form];
  const bool clips = common.clip;
  const RuleGroup* const groups = program.groups.data();
  const BatchRule* const rules = program.rules.data();
  VB strengths[kMostTerms];
  VB area = spread<kPoints>(0);
  VB moment = spread<kPoints>(0);
  std::uint64_t live = 0;
  for (const BatchLane& lane : in(program.lanes, expert.lanes)) {
    VB strength = spread<kPoints>(0);
    for (const RuleGroup* group = groups + lane.groups.first; group != groups + lane.groups.end(); ++group) {
      strength = larger(strengthOf(*group, rules + group->rules.first, slots), strength);
    }
    strengths[lane.lane] = strength;
    addLane(form, clips, lane.lane, strength, strengths, live, area, moment);
    live |= std::uint64_t{1} << lane.lane;
  }
  for (int p = 0; p < VB::kParts; ++p) look_again[p] |= ~(area.part[p] > common.negligible);
  force = force + moment / area * expert.share;
}

/// Evaluates the experts of `chunk` at kPoints points, starting with point `first`. Returns one bit per point that the
/// general path must evaluate.
TACTUS_INLINE std::uint32_t somePoints(const Program& common, const BatchProgram& program, const BatchChunk& chunk,
                                       const double* const* columns, std::size_t first, VB* slots,
                                       double* force_n) noexcept {
  VB inputs[kMostInputs];
  Bits look_again[VB::kParts] = {};
  for (std::size_t i = 0; i < kMostInputs; ++i) {
    if (columns[i] == nullptr) continue;
    const VB x = load<kPoints>(columns[i] + first);
    for (int p = 0; p < VB::kParts; ++p) look_again[p] |= x.part[p] - x.part[p] != 0.0;  // NaN and infinity
    inputs[i] = smaller(larger(x, spread<kPoints>(common.input_min[i])), spread<kPoints>(common.input_max[i]));
  }
  VB force = chunk.experts.first == 0 ? spread<kPoints>(common.output_min) : load<kPoints>(force_n + first);
  for (const BatchSection& section : in(program.sections, chunk.sections)) {
    for (const FixedSlot& fixed : in(program.fixed, section.fixed)) slots[fixed.slot] = spread<kPoints>(fixed.value);
    for (const BatchTerm& term : in(program.terms, section.terms)) {
      slots[term.slot] = membership(term, inputs[term.input]);
    }
    for (const Antecedent& antecedent : in(program.antecedents, section.antecedents)) {
      VB least = spread<kPoints>(antecedent.cap);
      for (const std::uint16_t slot : in(program.antecedent_slots, antecedent.of)) least = smaller(slots[slot], least);
      slots[antecedent.slot] = least;
    }
    const std::uint32_t end = section.experts.end() < chunk.experts.end() ? section.experts.end() : chunk.experts.end();
    std::uint32_t e = section.experts.first > chunk.experts.first ? section.experts.first : chunk.experts.first;
    for (; e < end; ++e) {
      addExpert(common, program, program.experts[e], slots, force, look_again);
    }
  }
  store(force_n + first, force);
  Bits any{};
  for (int p = 0; p < VB::kParts; ++p) any |= look_again[p];
  long long some = 0;
  for (int lane = 0; lane < kWidth; ++lane) some |= any[lane];
  if (some == 0) return 0;
  std::uint32_t bits = 0;
  for (int p = 0; p < kPoints; ++p) {
    if (look_again[p / kWidth][p % kWidth] != 0) bits |= std::uint32_t{1} << (first + static_cast<std::size_t>(p));
  }
  return bits;
}

std::uint32_t batch(const Program& common, const BatchProgram& program, const BatchChunk& chunk,
                    const double* const* columns, double* force_n) noexcept {
  VB slots[kMostSlots];
  std::uint32_t look_again = 0;
  for (std::size_t first = 0; first < kBatch; first += kPoints) {
    look_again |= somePoints(common, program, chunk, columns, first, slots, force_n);
  }
  return look_again;
}
