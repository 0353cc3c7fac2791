// The source of the kernels. Only kernels.cpp includes it: once per instruction set, each time in another namespace and
// for another target. If the processor lacks an operation of the full width, the compiler splits it. Words: program.h.

// Arithmetic on several numbers at once.

/// Several numbers side by side, in registers of kWidth doubles.
constexpr int kWidth = TACTUS_KERNEL_WIDTH;
using Register = double __attribute__((vector_size(kWidth * sizeof(double)), may_alias));
using Bits = long long __attribute__((vector_size(kWidth * sizeof(double))));

template <int count>
struct Pack {
  static constexpr int kParts = count / kWidth;
  Register part[kParts];
};

/// Evaluates the expression for each register `i` of the result.
#define TACTUS_EACH_PART(expression)                                                                 \
  Pack<count> out;                                                                                   \
  _Pragma("GCC unroll 16") for (int i = 0; i < Pack<count>::kParts; ++i) out.part[i] = (expression); \
  return out

#define TACTUS_INLINE [[gnu::always_inline]] inline

template <int count>
TACTUS_INLINE Pack<count> spread(double x) noexcept {
  TACTUS_EACH_PART(x - Register{});  // gives x itself; x + 0 would cost an addition, because it turns -0 into 0
}
template <int count>
TACTUS_INLINE Pack<count> load(const double* from) noexcept {
  TACTUS_EACH_PART(([&] {
    Register r;
    __builtin_memcpy(&r, from + i * kWidth, sizeof r);
    return r;
  }()));
}
template <int count>
TACTUS_INLINE void store(double* to, const Pack<count>& x) noexcept {
  _Pragma("GCC unroll 16") for (int i = 0; i < Pack<count>::kParts; ++i) {
    __builtin_memcpy(to + i * kWidth, &x.part[i], sizeof(Register));
  }
}
template <int count>
TACTUS_INLINE Pack<count> operator+(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] + y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] - y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator*(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] * y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator/(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] / y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator*(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] * y);
}
template <int count>
TACTUS_INLINE Pack<count> operator+(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] + y);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] - y);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(double x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x - y.part[i]);
}
/// The larger of x and y; y if x is NaN.
template <int count>
TACTUS_INLINE Pack<count> larger(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] > y.part[i] ? x.part[i] : y.part[i]);
}
/// The smaller of x and y; y if x is NaN.
template <int count>
TACTUS_INLINE Pack<count> smaller(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] < y.part[i] ? x.part[i] : y.part[i]);
}
TACTUS_INLINE double smaller(double x, double y) noexcept { return x < y ? x : y; }
/// x if it is positive, else 1. Used as a divisor.
template <int count>
TACTUS_INLINE Pack<count> positiveOrOne(const Pack<count>& x) noexcept {
  TACTUS_EACH_PART(x.part[i] > 0 ? x.part[i] : Register{} + 1.0);
}

// Area and moment of output sets by their closed form.

/// Area and first moment of a trapezoid clipped at s, with positions measured from the lower end of the universe.
/// `Number` is a double, or one double per element of s. A symmetric trapezoid takes fewer operations if `Number` is a
/// double.
template <int count, class Number>
TACTUS_INLINE void clip(const Pack<count>& s, const Polynomial<Number>& f, Pack<count>& area,
                        Pack<count>& moment) noexcept {
  area = s * (f.width - s * f.half_taper);
  moment = area * f.middle;
  if constexpr (std::is_same_v<Number, double>) {
    if (f.linear == 0) return;
  }
  moment = moment + (s * s) * (f.linear - s * f.cubic);
}

/// The overlap of a set scaled by `left` with the next set, scaled by `right`: a triangle between two ramps.
template <int count, class Number>
TACTUS_INLINE void overlapScaled(const Pack<count>& left, const Pack<count>& right, const Overlap<Number>& overlap,
                                 Pack<count>& area, Pack<count>& moment) noexcept {
  const Pack<count> fall = left * overlap.inverse_fall;
  const Pack<count> rise = right * overlap.inverse_rise;
  const Pack<count> share = fall / positiveOrOne(fall + rise);  // way from the start of the overlap to its peak
  const Number& width = overlap.shape.width;
  area = (rise * share) * (width * width) * 0.5;
  moment = area * ((share + 1) * (width * (1.0 / 3)) + overlap.start);
}

/// Subtracts from the sums the overlaps of the output term `lane`, of strength s, with earlier terms.
/// `strengths`: strengths of the earlier lanes. `live`: one bit per lane, set if its strength can be above 0.
template <int count>
TACTUS_INLINE void takeOverlaps(const ClosedForm& form, bool clips, std::size_t lane, const Pack<count>& s,
                                const Pack<count>* strengths, std::uint64_t live, Pack<count>& area,
                                Pack<count>& moment) noexcept {
  const ClosedForm::Pair* const end = form.pairs.data() + form.first_pair[lane + 1];
  for (const ClosedForm::Pair* pair = form.pairs.data() + form.first_pair[lane]; pair != end; ++pair) {
    if ((live >> pair->left & 1U) == 0) continue;
    Pack<count> shared_area, shared_moment;
    if (!clips) {
      overlapScaled(strengths[pair->left], s, pair->overlap, shared_area, shared_moment);
    } else {
      const Pack<count> t = smaller(smaller(strengths[pair->left], s), spread<count>(pair->overlap.peak));
      clip(t, pair->overlap.shape, shared_area, shared_moment);
      if (pair->left + 1U != lane) {
        // Below the strength of the strongest term between, terms between cover the whole overlap.
        Pack<count> between = spread<count>(0);
        for (std::size_t k = pair->left + 1U; k < lane; ++k) {
          if ((live >> k & 1U) != 0) between = larger(strengths[k], between);
        }
        Pack<count> hidden_area, hidden_moment;
        clip(smaller(t, between), pair->overlap.shape, hidden_area, hidden_moment);
        area = area + hidden_area;
        moment = moment + hidden_moment;
      }
    }
    area = area - shared_area;
    moment = moment - shared_moment;
  }
}

/// Adds the output term `lane` of strength s to the sums, minus its overlaps with earlier terms.
template <int count>
TACTUS_INLINE void addLane(const ClosedForm& form, bool clips, std::size_t lane, const Pack<count>& s,
                           const Pack<count>* strengths, std::uint64_t live, Pack<count>& area,
                           Pack<count>& moment) noexcept {
  const Polynomial<double>& term = form.terms[lane];
  if (clips) {
    Pack<count> own_area, own_moment;
    clip(s, term, own_area, own_moment);
    area = area + own_area;
    moment = moment + own_moment;
  } else {
    area = area + s * term.width;
    moment = moment + s * term.middle;
  }
  takeOverlaps(form, clips, lane, s, strengths, live, area, moment);
}

// Many points at once, one lane per point.

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

#if TACTUS_KERNEL_WIDTH <= 4

// Memberships at one point, and the rows of rules that can be active there.

template <int count>
TACTUS_INLINE Pack<count> load(const Lanes& lanes) noexcept {
  return load<count>(lanes.value);
}

/// x clamped to the universe of input i.
TACTUS_INLINE double clampInput(const Program& common, std::size_t i, double x) noexcept {
  const double above = x > common.input_min[i] ? x : common.input_min[i];
  return smaller(above, common.input_max[i]);
}

/// Clamps the inputs to their universes. Returns false if an input is not finite.
TACTUS_INLINE bool clampInputs(const Program& common, const double* inputs, double* clamped) noexcept {
  double nothing = 0;  // becomes NaN if an input is NaN or infinite
  for (std::size_t i = 0; i < common.inputs; ++i) {
    nothing += inputs[i] - inputs[i];
    clamped[i] = clampInput(common, i, inputs[i]);
  }
  return nothing == 0;
}

// Most inputs have three or four terms, which is half a block.
constexpr int kHalf = 4;

/// Memberships of one input in the terms of a block, including absent terms. Negative values stay, because the
/// strengths are cut at 0 later.
template <int count>
TACTUS_INLINE void fuzzify(const TermBlock& block, double input, double* slots) noexcept {
  const Pack<count> x = spread<count>(input);
  const Pack<count> rise = smaller((x - load<count>(block.a)) * load<count>(block.rise), load<count>(block.height));
  store(slots, smaller((load<count>(block.d) - x) * load<count>(block.fall), rise));
}

/// The rows that can be active at x: the rows of the segment that contains x.
TACTUS_INLINE std::span<const std::uint16_t> rowsAt(const PointProgram& program, const PointSection& section,
                                                    double x) noexcept {
  const auto cell = static_cast<int>((x - section.grid_start) * section.cells_per_unit);
  const double* const breakpoints = program.breakpoints.data() + section.first_breakpoint;
  const GridCell& start = program.cells[section.first_cell + static_cast<std::size_t>(cell)];
  const std::uint16_t* rows = program.segment_rows.data() + section.first_segment_row + start.row;
  for (const double* end = breakpoints + start.segment; x >= *end; ++end) rows += section.rows_per_segment;
  return {rows, section.rows_per_segment};
}

/// The slots and the active rows of a section.
struct Fuzzified {
  const double* slots;
  const std::uint16_t* pivots;
  std::span<const std::uint16_t> rows;
};

/// Computes the slots of a section at one point. `inputs`: clamped values. `pivot`: the clamped value of the pivot
/// input.
TACTUS_INLINE Fuzzified fuzzify(const PointProgram& program, const PointSection& section, const double* inputs,
                                double pivot, double* slots) noexcept {
  for (const TermBlock& block : in(program.blocks, section.blocks)) {
    if (block.count <= kHalf) {
      fuzzify<kHalf>(block, inputs[block.input], slots + block.slot);
    } else {
      fuzzify<kLanes>(block, inputs[block.input], slots + block.slot);
    }
  }
  for (const Antecedent& antecedent : in(program.antecedents, section.antecedents)) {
    double least = antecedent.cap;
    for (const std::uint16_t slot : in(program.antecedent_slots, antecedent.of)) least = smaller(slots[slot], least);
    slots[antecedent.slot] = least;
  }
  return {slots, program.pivots.data() + section.first_pivot, rowsAt(program, section, pivot)};
}

#include "core/fuzzy/kernel_point.h"

#endif

#undef TACTUS_EACH_PART
#undef TACTUS_INLINE
#undef TACTUS_KERNEL_WIDTH
